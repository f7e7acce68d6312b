/* The C face of a design's RTL as fast as it can be simulated: the top alone, with memories in the
   same translation unit. It answers how fast and in how many cycles, nothing else; what the
   RTL does is looked at through plugin.h. */
#ifndef PINEDA_TB_BENCH_PLUGIN_H
#define PINEDA_TB_BENCH_PLUGIN_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { kPinedaBenchAbi = 2 };

/* Ports that can stall, a bit each. */
enum {
  kPinedaBenchTriangle = 1 << 1,
  kPinedaBenchEnd = 1 << 2,
  kPinedaBenchClear = 1 << 4,
  kPinedaBenchDepthRead = 1 << 5,
  kPinedaBenchDepthWrite = 1 << 6,
  kPinedaBenchColorWrite = 1 << 7
};

/* Who may keep the top waiting. Cycles are those of the frame. */
typedef struct {
  void* self;
  /* The ports whose other side moves in this cycle; asked once in each. */
  uint32_t (*moving)(void* self, uint64_t cycle);
  /* A memory port takes a request on the stamp in column x, row y. A read is answered in the cycle
     that is returned. Within a cycle depth reads come first, then depth writes. */
  uint64_t (*accept)(void* self, uint32_t port, uint64_t cycle, uint32_t x, uint32_t y);
} PinedaBenchOutside;

/* A frame to draw. Packed structs lie as in model/spec/pack.h. */
typedef struct {
  const uint32_t* state;     /* frame_t */
  const uint32_t* triangles; /* triangle_t, one after the other */
  uint64_t count;            /* of triangles */
  int32_t width;             /* px */
  int32_t height;
  const PinedaBenchOutside* outside; /* NULL: all ports move, reads take depth_latency_cycles */
  int32_t depth_latency_cycles;
  /* Memories, row-major; cleared by run(). */
  uint32_t* depth; /* a code a sample */
  uint16_t* color; /* the attributes of a sample, flat ones last */
} PinedaBenchFrame;

typedef struct PinedaBench PinedaBench;

typedef struct {
  uint32_t abi;           /* kPinedaBenchAbi */
  const char* design;     /* name of the design */
  uint64_t package_hash;  /* pineda::spec::package_hash() of the package it was built from */
  const char* compiler;   /* and its version */
  PinedaBench* (*open)(); /* reset and idle */
  void (*close)(PinedaBench*);
  /* Draws a frame; from its first clock edge to the last write accepted, cycles. 0: nothing moved
     for eight million cycles. */
  uint64_t (*run)(PinedaBench*, const PinedaBenchFrame*);
} PinedaBenchPlugin;

/* The one symbol that a plug-in exports. */
const PinedaBenchPlugin* pineda_bench_plugin(void);

#ifdef __cplusplus
}
#endif
#endif
