// The table of a DRAM's and its caches' parameters, as a study's file names them.
#pragma once

#include <string>

#include "studies/run/study.h"

namespace pineda::studies {

struct DramParameter {
  const char* key;
  int memory::DramParameters::*member;
};
inline constexpr DramParameter kDramParameters[] = {
    {"banks", &memory::DramParameters::banks},
    {"row_bytes", &memory::DramParameters::row_bytes},
    {"bus_bytes", &memory::DramParameters::bus_bytes},
    {"row_hit_cycles", &memory::DramParameters::row_hit_cycles},
    {"row_miss_cycles", &memory::DramParameters::row_miss_cycles},
    {"row_conflict_cycles", &memory::DramParameters::row_conflict_cycles},
    {"refresh_interval_cycles", &memory::DramParameters::refresh_interval_cycles},
    {"refresh_cycles", &memory::DramParameters::refresh_cycles},
    {"set_columns_log2", &memory::DramParameters::set_columns_log2},
    {"set_rows_log2", &memory::DramParameters::set_rows_log2},
    {"ways", &memory::DramParameters::ways},
    {"hit_latency_cycles", &memory::DramParameters::hit_latency_cycles},
};

/// What a memory does, in words: its kind and what it has of these.
std::string parameters_of(const StudyMemory& memory);

/// A memory of a study in front of a design.
std::shared_ptr<memory::MemoryTiming> make_memory(const StudyMemory& memory,
                                                  const spec::Contract& contract);

}  // namespace pineda::studies
