/* The C face of a design's RTL as fast as it can be simulated: the top alone, with ideal memories
   in the same translation unit. It answers how fast and in how many cycles, nothing else; what the
   RTL does is looked at through plugin.h. */
#ifndef PINEDA_TB_BENCH_PLUGIN_H
#define PINEDA_TB_BENCH_PLUGIN_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { kPinedaBenchAbi = 1 };

/* A frame to draw. Packed structs lie as in model/spec/pack.h. */
typedef struct {
  const uint32_t* state;     /* frame_t */
  const uint32_t* triangles; /* triangle_t, one after the other */
  uint64_t count;            /* of triangles */
  int32_t width;             /* px */
  int32_t height;
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
