/* The C face of a design's Verilated RTL: a shared library that the bench loads without knowing the
   design's widths. Ports are named storage; a packed struct lies there as in model/spec/pack.h. */
#ifndef PINEDA_TB_PLUGIN_H
#define PINEDA_TB_PLUGIN_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { kPinedaRtlAbi = 2 };

typedef struct {
  const char* name;
  void* data; /* 1, 2, 4, 8 or a multiple of 4 bytes, little-endian, bit 0 first */
  uint32_t bytes;
} PinedaRtlPort;

typedef struct PinedaRtl PinedaRtl;

typedef struct {
  uint32_t abi;          /* kPinedaRtlAbi */
  const char* design;    /* name of the design */
  uint64_t package_hash; /* pineda::spec::package_hash() of the package it was built from */

  /* Units: setup, traversal, interp_ztest, top, loopback_STRUCT. NULL if there is none. */
  PinedaRtl* (*open)(const char* unit);
  void (*close)(PinedaRtl*);
  /* Ports, and for the top also the streams between the units; ends with a NULL name. */
  const PinedaRtlPort* (*ports)(PinedaRtl*);
  /* Lets inputs settle while the clock is low. */
  void (*settle)(PinedaRtl*);
  /* One rising edge, then the clock is low again; outputs follow at the next settle. */
  void (*clock)(PinedaRtl*);
  /* Failed assertions so far. */
  uint64_t (*errors)(PinedaRtl*);
  /* Writes an FST waveform from now on; 0 if the unit has none or the file cannot be written. */
  int (*trace)(PinedaRtl*, const char* file);
  /* Writes how often each line ran and each bit changed so far, by instance, in Verilator's form; 0 if
     the plug-in was built without these counters. */
  int (*write_coverage)(PinedaRtl*, const char* file);
} PinedaRtlPlugin;

/* The one symbol that a plug-in exports. */
const PinedaRtlPlugin* pineda_rtl_plugin(void);

#ifdef __cplusplus
}
#endif
#endif
