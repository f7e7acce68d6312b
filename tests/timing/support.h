// What the timing tests share: scenes to draw, and a record of every token with its cycle.
#pragma once

#include <string>
#include <vector>

#include "model/spec/difference.h"
#include "model/timing/raster_top.h"

namespace pineda::test {

using timing::Cause;
using timing::Cycle;
using timing::Unit;

inline constexpr spec::Contract kContract = spec::contract(spec::kHighTile);
inline constexpr int kPx = 1 << spec::kHighTile.subpixel_bits;  // subpixels of a pixel

struct Scene {
  spec::FrameState frame;
  std::vector<spec::Triangle> triangles;
};

/// Hands over the triangles of a scene one by one; the scene must outlive it.
timing::Pull pull_from(const Scene& scene);

/// A triangle at these corners in px, a flat plane at depth code `z`.
spec::Triangle flat_triangle(int x0, int y0, int x1, int y1, int x2, int y2, int64_t z = 1000);

/// Kinds of random scenes. Each stresses another unit.
enum class Kind {
  kSmall,     // up to 6 px: setup is the bottleneck, many are dropped
  kMedium,    // up to 40 px
  kHuge,      // the guard band over a small frame: whole rows of rejected or accepted tiles
  kNeedles,   // long and thin: most tiles are rejected
  kOneStamp,  // all on the same few stamps, one after the other: hazards
  kOneStack,  // two triangles that cover the frame, in turn: the stamps are the bottleneck
  kMixed,     // any of the above, triangle by triangle
};
inline constexpr Kind kKinds[] = {Kind::kSmall,    Kind::kMedium,   Kind::kHuge, Kind::kNeedles,
                                  Kind::kOneStamp, Kind::kOneStack, Kind::kMixed};
const char* kind_name(Kind kind);
/// In any raster state; the triangles fitted into the formats of the design.
Scene random_scene(Kind kind, uint64_t seed, int triangles,
                   const spec::Contract& contract = kContract);

/// A token and the cycle of its handshake.
template <class T>
struct Event {
  Cycle cycle;
  T token;
};

/// Every token of a frame.
struct Record {
  std::vector<Event<spec::SetupPrim>> prims;
  std::vector<Event<spec::Stamp>> stamps;
  std::vector<Event<spec::DepthWrite>> depths;
  std::vector<Event<spec::ColorWrite>> colors;
};

/// Records what a listener hears; cycles count from `start`.
class Recorder final : public timing::Listener {
 public:
  explicit Recorder(Record* record, Cycle start = 0) : record_(*record), start_(start) {}
  void prim(Cycle cycle, const spec::SetupPrim& t) override { add(&record_.prims, cycle, t); }
  void stamp(Cycle cycle, const spec::Stamp& t) override { add(&record_.stamps, cycle, t); }
  void depth(Cycle cycle, const spec::DepthWrite& t) override { add(&record_.depths, cycle, t); }
  void color(Cycle cycle, const spec::ColorWrite& t) override { add(&record_.colors, cycle, t); }

 private:
  template <class T>
  void add(std::vector<Event<T>>* events, Cycle cycle, const T& token) {
    events->push_back({cycle - start_, token});
  }
  Record& record_;
  Cycle start_;
};

/// The first difference of two sequences in bits or cycles, with the name of the boundary; empty if
/// none.
template <class T>
std::string difference(const std::vector<Event<T>>& expected, const std::vector<Event<T>>& got,
                       bool with_cycles, const spec::Contract& contract) {
  const spec::Comparer<T> comparer(contract);
  const std::string name = spec::struct_name<T>();
  for (size_t i = 0; i < std::min(expected.size(), got.size()); ++i) {
    const std::string where = name + " " + std::to_string(i) + ": ";
    if (const auto text = comparer.difference(expected[i].token, got[i].token)) {
      return where + *text;
    }
    if (with_cycles && expected[i].cycle != got[i].cycle) {
      return where + "expected in cycle " + std::to_string(expected[i].cycle) + ", got in " +
             std::to_string(got[i].cycle);
    }
  }
  if (expected.size() == got.size()) return {};
  return name + ": expected " + std::to_string(expected.size()) + " tokens, got " +
         std::to_string(got.size());
}
std::string difference(const Record& expected, const Record& got, bool with_cycles,
                       const spec::Contract& contract = kContract);

/// "ID: MESSAGE" of the SC_REPORT_ERROR that an action throws; empty if none.
template <class Action>
std::string reported(Action&& action) {
  try {
    action();
  } catch (const sc_core::sc_report& report) {
    return std::string(report.get_msg_type()) + ": " + report.get_msg();
  }
  return {};
}

}  // namespace pineda::test
