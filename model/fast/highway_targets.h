// Which of Highway's targets the kernels are compiled for; included before Highway.
#pragma once

#if defined(__aarch64__)
// On ARM NEON alone, called without a choice at run time. SVE's vectors have no size, so no struct holds
// them. Where Highway 1.0 could choose (GCC on Linux), it compiles NEON for AES, too, and the vectors'
// constructors cannot be inlined into those of std::array, which are compiled without; it chooses by
// sys/auxv.h.
#define HWY_COMPILE_ONLY_STATIC
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#ifndef TOOLCHAIN_MISS_SYS_AUXV_H
#define TOOLCHAIN_MISS_SYS_AUXV_H
#endif
#endif
