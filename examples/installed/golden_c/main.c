/* A triangle through each unit of the golden model, then a whole frame, written as a picture.
 *
 *   golden_c [FILE.ppm]
 */
#include <pineda/golden.h>
#include <stdio.h>
#include <stdlib.h>

static void must(pineda_status status) {
  if (status == PINEDA_OK) return;
  fprintf(stderr, "%s: %s\n", pineda_status_text(status), pineda_last_error());
  exit(1);
}

/* What a scoreboard of one's own RTL compares at each boundary. */
static void walk(pineda_model* model, const pineda_frame* frame, const pineda_triangle* triangle) {
  pineda_setup_prim prim;
  pineda_drop drop;
  pineda_fragment fragment;
  size_t count = 0, i;
  pineda_stamp* stamps;

  must(pineda_setup(model, frame, triangle, &prim, &drop));
  if (drop != PINEDA_KEPT) {
    printf("dropped\n");
    return;
  }
  printf("setup         box (%d, %d) to (%d, %d)\n", prim.x0, prim.y0, prim.x1, prim.y1);
  for (i = 0; i < 3; ++i) {
    printf("  edge %d      a %lld, b %lld, e %lld\n", (int)i, (long long)prim.edge[i].a,
           (long long)prim.edge[i].b, (long long)prim.edge[i].e);
  }
  /* First how many, then the stamps. */
  (void)pineda_traverse(model, &prim, NULL, 0, &count);
  stamps = malloc((count + 1) * sizeof *stamps);
  if (stamps == NULL) exit(1);
  must(pineda_traverse(model, &prim, stamps, count, &count));
  printf("traversal     %d stamps, the first at (%d, %d), mask %x\n", (int)count, stamps[0].x,
         stamps[0].y, (unsigned)stamps[0].mask);
  must(pineda_interpolate(model, &stamps[0], &fragment));
  for (i = 0; i < 4; ++i) {
    if ((stamps[0].mask >> i & 1) == 0) continue;
    printf("interpolation lane %d: depth %u, red %d\n", (int)i, (unsigned)fragment.z[i],
           fragment.attr[i][0]);
    break;
  }
  free(stamps);
}

static void write_picture(pineda_model* model, const pineda_frame* frame, const char* file) {
  const size_t samples = (size_t)frame->width * (size_t)frame->height;
  uint16_t* color = malloc(samples * 4 * sizeof *color);
  FILE* out = fopen(file, "wb");
  size_t i;
  if (color == NULL || out == NULL) {
    fprintf(stderr, "%s: expected a file to write\n", file);
    exit(2);
  }
  must(pineda_read_color(model, color, samples * 4));
  fprintf(out, "P6 %d %d 255\n", frame->width, frame->height);
  for (i = 0; i < samples * 4; ++i) {
    if (i % 4 != 3) fputc(color[i], out);
  }
  fclose(out);
  free(color);
}

int main(int argc, char** argv) {
  const pineda_screen_triangle screen[2] = {
      {0,
       {{32.f, 4.f, .25f, 1.f, {255, 0, 0, 255}},
        {4.f, 60.f, .5f, 1.f, {0, 255, 0, 255}},
        {60.f, 56.f, .75f, 1.f, {0, 0, 255, 255}}}},
      {1,
       {{2.f, 30.f, .4f, 1.f, {255, 255, 0, 255}},
        {20.f, 50.f, .4f, 1.f, {255, 255, 0, 255}},
        {62.f, 20.f, .4f, 1.f, {255, 255, 0, 255}}}}};
  const pineda_frame frame = pineda_default_frame(64, 64);
  pineda_model* model = NULL;
  pineda_triangle triangle;

  must(pineda_open("high_tile", &model));
  must(pineda_snap(model, &screen[0], &triangle));
  walk(model, &frame, &triangle);
  must(pineda_begin_frame(model, &frame));
  must(pineda_draw_screen(model, screen, 2));
  write_picture(model, &frame, argc > 1 ? argv[1] : "golden_c.ppm");

  /* What its formats do not hold is refused, and nothing is drawn. */
  triangle.v[0].x = 1 << 30;
  if (pineda_draw(model, &triangle, 1) != PINEDA_OUT_OF_RANGE) return 1;
  printf("refused       %s\n", pineda_last_error());
  pineda_close(model);
  return 0;
}
