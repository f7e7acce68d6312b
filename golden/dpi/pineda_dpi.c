/* The C side of pineda_dpi_pkg.sv, on pineda/golden.h. A packed 2-state argument is an array of 32-bit
 * words, as the standard has it (IEEE 1800, 35.5.6). Compiles as C and, for Verilator, as C++. */
#include <pineda/golden.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A model, and the stamps that traversal has found and nobody has asked for yet. */
typedef struct {
  pineda_model* model;
  size_t words[4]; /* of each pineda_packed */
  pineda_stamp* stamp;
  size_t first, count, capacity;
} dpi_model;

static char own_error[128];
static int is_own_error;

static int own(const char* text) {
  snprintf(own_error, sizeof own_error, "%s", text);
  is_own_error = 1;
  return -1;
}
static int refused(void) {
  is_own_error = 0;
  return -1;
}

const char* pineda_dpi_error(void) { return is_own_error ? own_error : pineda_last_error(); }

void pineda_dpi_close(void* handle) {
  dpi_model* dpi = (dpi_model*)handle;
  if (dpi == NULL) return;
  pineda_close(dpi->model);
  free(dpi->stamp);
  free(dpi);
}

void* pineda_dpi_open(const char* design, int frame_bits, int triangle_bits, int setup_prim_bits,
                      int stamp_bits) {
  static const char* const name[4] = {"frame_t", "triangle_t", "setup_prim_t", "stamp_t"};
  const int bits[4] = {frame_bits, triangle_bits, setup_prim_bits, stamp_bits};
  dpi_model* dpi = (dpi_model*)calloc(1, sizeof *dpi);
  pineda_status status;
  int kind;
  if (dpi == NULL) {
    own("out of memory");
    return NULL;
  }
  status = strchr(design, '=') != NULL ? pineda_open_toml(design, "design", &dpi->model)
                                       : pineda_open(design, &dpi->model);
  if (status != PINEDA_OK) {
    refused();
    pineda_dpi_close(dpi);
    return NULL;
  }
  for (kind = 0; kind < 4; ++kind) {
    size_t own_bits = 0;
    if (pineda_packed_bits(dpi->model, kind, &own_bits) != PINEDA_OK ||
        own_bits != (size_t)bits[kind]) {
      char text[sizeof own_error];
      snprintf(text, sizeof text, "pineda_pkg is of another design: %s: expected %d bits, got %d",
               name[kind], (int)own_bits, bits[kind]);
      own(text);
      pineda_dpi_close(dpi);
      return NULL;
    }
    dpi->words[kind] = (own_bits + 31) / 32;
  }
  return dpi;
}

int pineda_dpi_setup(void* handle, const uint32_t* frame, const uint32_t* triangle,
                     uint32_t* prim) {
  dpi_model* dpi = (dpi_model*)handle;
  pineda_frame state;
  pineda_triangle in;
  pineda_setup_prim out;
  pineda_drop drop;
  memset(prim, 0, dpi->words[PINEDA_PACKED_SETUP_PRIM] * sizeof *prim);
  if (pineda_unpack(dpi->model, PINEDA_PACKED_FRAME, frame, dpi->words[PINEDA_PACKED_FRAME],
                    &state) != PINEDA_OK ||
      pineda_unpack(dpi->model, PINEDA_PACKED_TRIANGLE, triangle,
                    dpi->words[PINEDA_PACKED_TRIANGLE], &in) != PINEDA_OK ||
      pineda_setup(dpi->model, &state, &in, &out, &drop) != PINEDA_OK) {
    return refused();
  }
  if (drop != PINEDA_KEPT) return (int)drop;
  if (pineda_pack(dpi->model, PINEDA_PACKED_SETUP_PRIM, &out, prim,
                  dpi->words[PINEDA_PACKED_SETUP_PRIM]) != PINEDA_OK) {
    return refused();
  }
  return 0;
}

/* Room for `more` stamps behind those that wait. */
static int reserve(dpi_model* dpi, size_t more) {
  pineda_stamp* larger;
  memmove(dpi->stamp, dpi->stamp + dpi->first, (dpi->count - dpi->first) * sizeof *dpi->stamp);
  dpi->count -= dpi->first;
  dpi->first = 0;
  if (dpi->count + more <= dpi->capacity) return 1;
  larger = (pineda_stamp*)realloc(dpi->stamp, (dpi->count + more) * sizeof *larger);
  if (larger == NULL) return 0;
  dpi->stamp = larger;
  dpi->capacity = dpi->count + more;
  return 1;
}

int pineda_dpi_traverse(void* handle, const uint32_t* prim) {
  dpi_model* dpi = (dpi_model*)handle;
  pineda_setup_prim in;
  size_t found = 0;
  pineda_status status;
  if (pineda_unpack(dpi->model, PINEDA_PACKED_SETUP_PRIM, prim,
                    dpi->words[PINEDA_PACKED_SETUP_PRIM], &in) != PINEDA_OK) {
    return refused();
  }
  if (!reserve(dpi, 1)) return own("out of memory");
  status = pineda_traverse(dpi->model, &in, dpi->stamp + dpi->count, dpi->capacity - dpi->count,
                           &found);
  if (status == PINEDA_WRONG_SIZE) {
    if (!reserve(dpi, found)) return own("out of memory");
    status = pineda_traverse(dpi->model, &in, dpi->stamp + dpi->count, found, &found);
  }
  if (status != PINEDA_OK) return refused();
  dpi->count += found;
  return (int)found;
}

int pineda_dpi_next_stamp(void* handle, uint32_t* stamp) {
  dpi_model* dpi = (dpi_model*)handle;
  memset(stamp, 0, dpi->words[PINEDA_PACKED_STAMP] * sizeof *stamp);
  if (dpi->first == dpi->count) return 0;
  if (pineda_pack(dpi->model, PINEDA_PACKED_STAMP, &dpi->stamp[dpi->first++], stamp,
                  dpi->words[PINEDA_PACKED_STAMP]) != PINEDA_OK) {
    return refused();
  }
  return 1;
}

#ifdef __cplusplus
}
#endif
