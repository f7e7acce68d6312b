/* The header is C99, and a program of C that links nothing else draws a triangle. */
#include <pineda/golden.h>
#include <stdio.h>

int main(void) {
  pineda_model* model = NULL;
  pineda_frame frame = pineda_default_frame(16, 16);
  const pineda_screen_triangle triangle = {0,
                                           {{0.f, 0.f, .5f, 1.f, {255, 0, 0, 255}},
                                            {0.f, 16.f, .5f, 1.f, {255, 0, 0, 255}},
                                            {16.f, 0.f, .5f, 1.f, {255, 0, 0, 255}}}};
  uint16_t hits[256];
  int covered = 0, i;
  if (pineda_open("high_tile", &model) != PINEDA_OK ||
      pineda_begin_frame(model, &frame) != PINEDA_OK ||
      pineda_draw_screen(model, &triangle, 1) != PINEDA_OK ||
      pineda_read_hits(model, hits, 256) != PINEDA_OK) {
    printf("%s\n", pineda_last_error());
    return 1;
  }
  pineda_close(model);
  for (i = 0; i < 256; ++i) covered += hits[i];
  printf("%d samples\n", covered);
  return covered == 120 ? 0 : 1; /* its third edge belongs to the other side */
}
