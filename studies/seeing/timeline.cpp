#include "studies/seeing/timeline.h"

#include <fmt/format.h>

namespace pineda::studies {
namespace {

using timing::Cause;
using timing::Cycle;
using timing::Fifo;
using timing::Unit;

// Viewers show lanes in the order of their numbers. Counters have none.
int triangle_lane(Unit unit) { return 2 * static_cast<int>(unit) + 1; }
int stall_lane(Unit unit) { return triangle_lane(unit) + 1; }

std::string lane_name(int lane, const std::string& name) {
  return fmt::format(
      ",\n{{\"ph\":\"M\",\"pid\":1,\"tid\":{},\"name\":\"thread_name\",\"args\":"
      "{{\"name\":\"{}\"}}}},\n{{\"ph\":\"M\",\"pid\":1,\"tid\":{},\"name\":"
      "\"thread_sort_index\",\"args\":{{\"sort_index\":{}}}}}",
      lane, name, lane, lane);
}

}  // namespace

Timeline::Timeline(std::FILE* file, const Window& window, const std::string& about)
    : file_(file), window_(window) {
  put("{\"displayTimeUnit\":\"ms\",\n\"otherData\":" + about + ",\n\"traceEvents\":[\n");
  put(R"({"ph":"M","pid":1,"name":"process_name","args":{"name":"pineda, 1 us = 1 cycle"}})");
  for (size_t i = 0; i < timing::kUnits; ++i) {
    const auto unit = static_cast<Unit>(i);
    const std::string name = timing::unit_name(unit);
    put(lane_name(triangle_lane(unit), name));
    put(lane_name(stall_lane(unit), name + ", stalls"));
  }
}

void Timeline::put(const std::string& text) {
  written_ &= std::fwrite(text.data(), 1, text.size(), file_) == text.size();
}

void Timeline::spent(Unit unit, Cause cause, Cycle from, Cycle until, uint32_t id) {
  lanes_[static_cast<size_t>(unit)].spans.add({cause, from, until, id}, window_,
                                              [&](const Span& span) { add(unit, span); });
}

void Timeline::add(Unit unit, const Span& span) {
  Lane& lane = lanes_[static_cast<size_t>(unit)];
  if (span.id != lane.triangle.id || lane.triangle.cycles() == 0) {
    end_triangle(unit);
    lane.triangle = span;
  } else if (lane.triangle.until < span.from) {
    const Span gap{Cause::kStarved, lane.triangle.until, span.from, span.id};
    lane.cycles[Cause::kStarved] += gap.cycles();
    stall(unit, gap);
  }
  lane.triangle.until = span.until;
  lane.cycles[span.cause] += span.cycles();
  if (span.cause != Cause::kBusy) stall(unit, span);
}

void Timeline::end_triangle(Unit unit) {
  Lane& lane = lanes_[static_cast<size_t>(unit)];
  if (lane.triangle.cycles() == 0) return;
  std::string causes;
  for (size_t i = 0; i < timing::kCauses; ++i) {
    const auto cause = static_cast<Cause>(i);
    if (lane.cycles[cause] == 0) continue;
    causes += fmt::format("{}\"{}\":{}", causes.empty() ? "" : ",", timing::cause_name(cause),
                          lane.cycles[cause]);
  }
  slice(triangle_lane(unit), fmt::format("triangle {}", lane.triangle.id), lane.triangle, causes);
  lane.triangle = {};
  lane.cycles = {};
}

void Timeline::stall(Unit unit, const Span& span) {
  slice(stall_lane(unit), timing::cause_name(span.cause), span,
        fmt::format("\"triangle\":{}", span.id));
}

void Timeline::slice(int lane, const std::string& name, const Span& span,
                     const std::string& arguments) {
  put(
      fmt::format(",\n{{\"ph\":\"X\",\"pid\":1,\"tid\":{},\"ts\":{},\"dur\":{},\"name\":\"{}\","
                  "\"args\":{{{}}}}}",
                  lane, span.from, span.cycles(), name, arguments));
  ++slices_;
}

void Timeline::slot(Fifo fifo, Cycle inserted, Cycle freed) {
  levels_[static_cast<size_t>(fifo)].slot(inserted, freed,
                                          [&](Cycle cycle, int now) { level(fifo, cycle, now); });
}

void Timeline::level(Fifo fifo, Cycle cycle, int level) {
  if (cycle <= window_.from) {
    first_levels_[static_cast<size_t>(fifo)] = level;
  } else if (cycle < window_.until) {
    counter(fifo, cycle, level);
  }
}

void Timeline::counter(Fifo fifo, Cycle cycle, int level) {
  put(
      fmt::format(",\n{{\"ph\":\"C\",\"pid\":1,\"ts\":{},\"name\":\"fifo {}\",\"args\":"
                  "{{\"level\":{}}}}}",
                  cycle, timing::fifo_name(fifo), level));
}

bool Timeline::finish() {
  for (size_t i = 0; i < timing::kUnits; ++i) {
    const auto unit = static_cast<Unit>(i);
    lanes_[i].spans.finish([&](const Span& span) { add(unit, span); });
    end_triangle(unit);
  }
  for (size_t i = 0; i < timing::kFifos; ++i) {
    const auto fifo = static_cast<Fifo>(i);
    levels_[i].finish([&](Cycle cycle, int now) { level(fifo, cycle, now); });
    counter(fifo, window_.from, first_levels_[i]);
  }
  put("\n]}\n");
  written_ &= std::fflush(file_) == 0;
  return written_;
}

}  // namespace pineda::studies
