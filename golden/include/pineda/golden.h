/* Pineda as a golden model: the bits of a fixed-point rasterizer, unit by unit and frame by frame, and
 * the judge of any rasterizer's frame by exact arithmetic. C99; the library is libpineda_golden.
 *
 * Every call returns a status. Inputs are checked before anything is done with them: a call that
 * returns anything but PINEDA_OK has changed neither the model nor what its pointers point to, unless
 * it says so, and pineda_last_error() has a line that says what was expected. No C++ exception leaves
 * the library, and none of its calls ends the program.
 *
 * Threads: calls on different models run at the same time; calls on one model wait for one another.
 *
 * Formats: S subpixel bits, G guard bits, D depth bits, A attribute bits of the design: see
 * pineda_design. y points down; the centre of the first pixel is at (0.5, 0.5). Arrays of samples are
 * row by row, the top row first.
 */
#ifndef PINEDA_GOLDEN_H
#define PINEDA_GOLDEN_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Changes when a struct or a call does; also the library's soname. */
#define PINEDA_GOLDEN_ABI 0

#define PINEDA_MAX_ATTRIBUTES 16
#define PINEDA_MAX_LANES 16

#if defined(__GNUC__)
#define PINEDA_API __attribute__((visibility("default")))
#else
#define PINEDA_API
#endif

typedef enum pineda_status {
  PINEDA_OK = 0,
  PINEDA_NULL_POINTER = 1, /* where something was to be read or written */
  PINEDA_NO_DESIGN = 2,    /* no design of that name, or its TOML is not one */
  PINEDA_NO_FRAME = 3,     /* pineda_begin_frame() must come first */
  PINEDA_OUT_OF_RANGE = 4, /* a value that its format does not hold, or NaN */
  PINEDA_WRONG_SIZE = 5,   /* of an array */
  PINEDA_UNSUPPORTED = 6,  /* the design has no such unit or value */
  PINEDA_OUT_OF_MEMORY = 7,
  PINEDA_INTERNAL = 8 /* a bug of the library */
} pineda_status;

/* "0.1.0"; the ABI that the library was built with. */
PINEDA_API const char* pineda_version(void);
PINEDA_API int pineda_abi(void);
/* One or two words; never null. */
PINEDA_API const char* pineda_status_text(int32_t status);
/* What the last call of this thread that failed expected, and what it got. Good until the next one
 * fails. */
PINEDA_API const char* pineda_last_error(void);

/* ---- Models: a design, and one frame at a time ---- */

typedef struct pineda_model pineda_model;

/* A named design: low, med, high_tile, persp, ... */
PINEDA_API pineda_status pineda_open(const char* design, pineda_model** model);
/* The text of a design file; `name` is what errors call it, and the design where it states no name. */
PINEDA_API pineda_status pineda_open_toml(const char* text, const char* name, pineda_model** model);
/* Null is fine. */
PINEDA_API void pineda_close(pineda_model* model);

typedef struct pineda_design {
  int32_t subpixel_bits;   /* S: positions are multiples of 2^-S px */
  int32_t guard_bits;      /* G: positions in [-2^G, 2^G) px, frames of up to 2^G px a side */
  int32_t depth_bits;      /* D; 0: the design has no depth */
  int32_t attribute_bits;  /* A */
  int32_t attributes;      /* interpolated */
  int32_t flat_attributes; /* those of a triangle's first vertex */
  int32_t perspective;     /* 1: attributes are corrected by 1/w */
  int32_t inverse_w_bits;  /* of a mantissa; 0 without perspective */
  int32_t tile_px;         /* tiles are square */
  int32_t stamp_width_px;
  int32_t stamp_height_px;
} pineda_design;

PINEDA_API pineda_status pineda_get_design(pineda_model* model, pineda_design* design);
/* The design file, with an end of string. *length is without it; where that is not below `capacity`,
 * PINEDA_WRONG_SIZE, and *length is set. `text` may be null where `capacity` is 0. */
PINEDA_API pineda_status pineda_get_toml(pineda_model* model, char* text, size_t capacity,
                                         size_t* length);

/* ---- Raster state, triangles ---- */

typedef enum pineda_cull { PINEDA_CULL_NONE, PINEDA_CULL_BACK, PINEDA_CULL_FRONT } pineda_cull;
typedef enum pineda_shade { PINEDA_SHADE_SMOOTH, PINEDA_SHADE_FLAT } pineda_shade;
typedef enum pineda_depth_func {
  PINEDA_DEPTH_LESS,
  PINEDA_DEPTH_LEQUAL,
  PINEDA_DEPTH_OFF, /* neither tested nor written */
  PINEDA_DEPTH_NEVER,
  PINEDA_DEPTH_EQUAL,
  PINEDA_DEPTH_GREATER,
  PINEDA_DEPTH_NOTEQUAL,
  PINEDA_DEPTH_GEQUAL,
  PINEDA_DEPTH_ALWAYS
} pineda_depth_func;

typedef struct pineda_frame {
  int32_t width, height; /* px, 1 to 2^G */
  int32_t cull;          /* pineda_cull; front-facing = counter-clockwise on screen */
  int32_t depth_func;    /* pineda_depth_func */
  int32_t depth_write;   /* 0 or 1 */
  int32_t shade;         /* pineda_shade */
  int32_t has_scissor;   /* 0 or 1 */
  int32_t scissor_x, scissor_y, scissor_width,
      scissor_height;    /* px; it may reach beyond the frame */
  int32_t bias_slope;    /* units of 2^-8, -2^15 to 2^15 - 1 */
  int64_t bias_constant; /* depth codes, less than 2^D in magnitude */
  double clear_depth;    /* 0 to 1 */
} pineda_frame;

/* A frame of this size that is drawn as usual: no culling, depth less and written, cleared to 1. */
PINEDA_API pineda_frame pineda_default_frame(int32_t width, int32_t height);

/* A snapped vertex. */
typedef struct pineda_vertex {
  int32_t x, y;                        /* units of 2^-S px */
  int64_t z;                           /* units of 2^-8 codes, 0 to (2^D - 1) * 2^8 */
  int32_t attr[PINEDA_MAX_ATTRIBUTES]; /* interpolated ones, then flat ones; others are ignored */
  /* With perspective, else ignored: 1/w = inverse_w * 2^-inverse_w_shift * f with a common f,
   * 2^(bits-1) <= inverse_w < 2^bits, 0 <= shift < 256; a vertex of the three has shift 0. */
  int32_t inverse_w, inverse_w_shift;
} pineda_vertex;

typedef struct pineda_triangle {
  uint32_t id; /* passed on */
  pineda_vertex v[3];
} pineda_triangle;

/* A vertex after the viewport transform. Positions within the guard band, 0 <= z <= 1, w normal and
 * positive. */
typedef struct pineda_screen_vertex {
  float x, y; /* px */
  float z;
  float w; /* clip-space; 1: affine */
  uint8_t rgba[4];
} pineda_screen_vertex;

typedef struct pineda_screen_triangle {
  uint32_t id;
  pineda_screen_vertex v[3];
} pineda_screen_triangle;

/* Positions to the nearest 2^-S px, halves to even; depths to the nearest 2^-8 code, halves up. */
PINEDA_API pineda_status pineda_snap(pineda_model* model, const pineda_screen_triangle* screen,
                                     pineda_triangle* triangle);

/* ---- Frames ---- */

/* Clears the model's frame. */
PINEDA_API pineda_status pineda_begin_frame(pineda_model* model, const pineda_frame* frame);
/* Draws triangles; none of them where one is refused. */
PINEDA_API pineda_status pineda_draw(pineda_model* model, const pineda_triangle* triangles,
                                     size_t count);
PINEDA_API pineda_status pineda_draw_screen(pineda_model* model,
                                            const pineda_screen_triangle* triangles, size_t count);

/* What the frame holds. `count` is the number of samples, of colours times that of all attributes.
 * How many triangles cover a sample, before the depth test, saturating at 65535; depth codes; colours:
 * interpolated attributes, then flat ones. */
PINEDA_API pineda_status pineda_read_hits(pineda_model* model, uint16_t* hits, size_t count);
PINEDA_API pineda_status pineda_read_depth(pineda_model* model, uint32_t* depth, size_t count);
PINEDA_API pineda_status pineda_read_color(pineda_model* model, uint16_t* color, size_t count);

/* ---- Units. Each is a pure function of the design and its inputs ---- */

typedef struct pineda_plane {
  int64_t dx, dy,
      ref; /* value = ref + x*dx + y*dy, modulo its width; px from the reference sample */
} pineda_plane;

typedef struct pineda_edge {
  int64_t a, b, e; /* a*x + b*y + e >= 0 inside; the top-left rule is folded into e */
} pineda_edge;

/* What a triangle's depth and attributes come from; a design uses some of the members. */
typedef struct pineda_planes {
  pineda_plane z;
  uint8_t z_steep; /* hierarchical z: it may wrap within a tile, outside the triangle */
  int64_t z_bias;  /* units of 2^-16 codes */
  pineda_plane attr[PINEDA_MAX_ATTRIBUTES];
  int32_t flat[PINEDA_MAX_ATTRIBUTES];
  /* Perspective: the low S bits of E of each edge, 1/w and attributes of each vertex. */
  int32_t e_low[3];
  int32_t inverse_w[3];
  int32_t inverse_w_shift[3];
  int32_t vertex_attr[3][PINEDA_MAX_ATTRIBUTES];
} pineda_planes;

typedef struct pineda_setup_prim {
  uint32_t id;
  int32_t x0, y0, x1, y1; /* box of samples that may be covered, px, inclusive */
  pineda_edge edge[3];    /* at the first sample of the box's first tile */
  pineda_planes planes;
} pineda_setup_prim;

/* The samples of one cycle: lane i is pixel (x*W + i%W, y*H + i/W) of a stamp of W x H px. */
typedef struct pineda_stamp {
  uint32_t id;
  int32_t x, y;         /* in stamps */
  uint32_t mask;        /* bit i: lane i is covered */
  uint8_t first;        /* of its tile */
  pineda_planes planes; /* at the first sample of the stamp's tile */
  pineda_edge edge[3];  /* perspective: there too */
} pineda_stamp;

typedef struct pineda_fragment {
  uint32_t z[PINEDA_MAX_LANES]; /* depth codes; 0 in lanes that are not covered */
  int32_t attr[PINEDA_MAX_LANES][PINEDA_MAX_ATTRIBUTES];
} pineda_fragment;

typedef enum pineda_drop {
  PINEDA_KEPT,
  PINEDA_ZERO_AREA,
  PINEDA_FACING,
  PINEDA_NO_SAMPLE,
  PINEDA_OUTSIDE
} pineda_drop;

/* Setup of one triangle. *prim is written where *drop is PINEDA_KEPT. */
PINEDA_API pineda_status pineda_setup(pineda_model* model, const pineda_frame* frame,
                                      const pineda_triangle* triangle, pineda_setup_prim* prim,
                                      pineda_drop* drop);
/* Traversal: the stamps that have a covered sample, in order. *count is their number; where it is above
 * `capacity`, PINEDA_WRONG_SIZE, and the first ones are written. */
PINEDA_API pineda_status pineda_traverse(pineda_model* model, const pineda_setup_prim* prim,
                                         pineda_stamp* stamps, size_t capacity, size_t* count);
/* Interpolation of a stamp's covered samples. Not of a design without a reciprocal. */
PINEDA_API pineda_status pineda_interpolate(pineda_model* model, const pineda_stamp* stamp,
                                            pineda_fragment* fragment);
/* The lanes of `mask` whose depth passes against the stored one by a pineda_depth_func. `z`, `stored`:
 * of all lanes. */
PINEDA_API pineda_status pineda_depth_test(pineda_model* model, int32_t func, uint32_t mask,
                                           const uint32_t* z, const uint32_t* stored,
                                           uint32_t* passed);

/* ---- Structs as the bits of their SystemVerilog packed structs (rtl/pineda_pkg.sv) ----
 * Bit i is bit i%32 of word i/32. `kind` is a pineda_packed. */

typedef enum pineda_packed {
  PINEDA_PACKED_FRAME,      /* frame_t, pineda_frame */
  PINEDA_PACKED_TRIANGLE,   /* triangle_t, pineda_triangle */
  PINEDA_PACKED_SETUP_PRIM, /* setup_prim_t, pineda_setup_prim */
  PINEDA_PACKED_STAMP       /* stamp_t, pineda_stamp */
} pineda_packed;

PINEDA_API pineda_status pineda_packed_bits(pineda_model* model, int32_t kind, size_t* bits);
/* `words`: (bits + 31) / 32 of them. */
PINEDA_API pineda_status pineda_pack(pineda_model* model, int32_t kind, const void* value,
                                     uint32_t* words, size_t count);
/* Bits above the struct are ignored. */
PINEDA_API pineda_status pineda_unpack(pineda_model* model, int32_t kind, const uint32_t* words,
                                       size_t count, void* value);

/* ---- Judge: any rasterizer's frame against exact arithmetic; no model, no design ---- */

typedef struct pineda_tolerance {
  int32_t subpixel_bits; /* of the rasterizer, 4 to 12 */
  int32_t guard_bits;    /* 4 to 14 */
  int32_t depth_bits;    /* 16 to 32 */
  double depth_ulp;      /* greatest error of a depth, codes, the rounding to a code included */
  double color_lsb;      /* of a colour, of 255 */
} pineda_tolerance;

/* 8, 14 and 24 bits, 1 ulp, 1 LSB. */
PINEDA_API pineda_tolerance pineda_default_tolerance(void);

/* What the rasterizer drew, sample by sample; what there is not is null, but not all of it. */
typedef struct pineda_dump {
  const uint16_t* hits;  /* how many triangles cover the sample, before the depth test */
  const uint32_t* depth; /* codes */
  const uint8_t* rgba;   /* four bytes a sample */
  size_t samples;        /* width * height of the frame */
} pineda_dump;

typedef enum pineda_rule {
  PINEDA_RULE_COVERAGE,
  PINEDA_RULE_FILL_RULE,
  PINEDA_RULE_CULL,
  PINEDA_RULE_SCISSOR,
  PINEDA_RULE_NEAR_PLANE,
  PINEDA_RULE_DEPTH_FUNC,
  PINEDA_RULE_DEPTH_TIE,
  PINEDA_RULE_DEPTH_VALUE,
  PINEDA_RULE_COLOR_VALUE,
  PINEDA_RULE_CLEAR
} pineda_rule;

typedef struct pineda_verdict {
  uint64_t samples_wrong; /* 0: it holds, and the rest is 0, but for the triangle */
  int32_t x, y;           /* the first wrong sample by row */
  int32_t rule;           /* pineda_rule */
  int64_t triangle;       /* its place among the triangles, -1: none has to do with it */
  char what[256];         /* a line */
} pineda_verdict;

/* `wrong`: null, or a byte a sample that becomes 1 where it is wrong, else 0. */
PINEDA_API pineda_status pineda_judge(const pineda_frame* frame, const pineda_tolerance* tolerance,
                                      const pineda_screen_triangle* triangles, size_t count,
                                      const pineda_dump* dump, pineda_verdict* verdict,
                                      uint8_t* wrong);

#ifdef __cplusplus
}
#endif

#endif
