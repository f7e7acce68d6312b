#include "studies/model_cycles.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <system_error>

#include "model/timing/raster_top.h"

namespace pineda::studies {
namespace {

int64_t run(const spec::Contract& contract, const spec::FrameState& frame,
            const std::vector<spec::Triangle>& triangles) {
  timing::RasterTop top("raster_top", contract);
  top.set_depth_latency_cycles(contract.design.depth_latency_cycles);
  const auto pull = [&triangles, i = size_t{0}](spec::Triangle* triangle) mutable {
    if (i == triangles.size()) return false;
    *triangle = triangles[i++];
    return true;
  };
  return top.run(frame, pull).cycles;
}

[[noreturn]] void answer(int pipe, const spec::Contract& contract, const spec::FrameState& frame,
                         const std::vector<spec::Triangle>& triangles) {
  int status = 1;
  try {
    const int64_t cycles = run(contract, frame, triangles);
    status = write(pipe, &cycles, sizeof cycles) == sizeof cycles ? 0 : 1;
  } catch (...) {
  }
  _exit(status);  // nothing of the parent's is flushed or closed twice
}

}  // namespace

int64_t model_cycles(const spec::Contract& contract, const spec::FrameState& frame,
                     const std::vector<spec::Triangle>& triangles) {
  const std::string reason = spec::no_cycles_reason(contract.design);
  if (!reason.empty()) throw std::invalid_argument(reason);
  int ends[2];
  if (pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) answer(ends[1], contract, frame, triangles);
  close(ends[1]);
  int64_t cycles = 0;
  const bool answered = read(ends[0], &cycles, sizeof cycles) == sizeof cycles;
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!answered) throw std::runtime_error("the cycle model ended without an answer");
  return cycles;
}

}  // namespace pineda::studies
