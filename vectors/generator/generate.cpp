#include "vectors/generator/generate.h"

#include <algorithm>
#include <cstdlib>
#include <future>
#include <memory>
#include <thread>
#include <type_traits>
#include <utility>

#include "vectors/coverage/coverage.h"
#include "vectors/generator/raw_cases.h"

namespace pineda::vectors {
namespace {

using spec::Contract;

// Limits that keep files small; a larger scene is used for the other units only.
constexpr size_t kMaxStamps = 80;
constexpr uint64_t kMaxFragments = 1024;  // of a frame, hidden ones too
constexpr int64_t kMaxBoxTiles = 65536;

constexpr int kMaxAttempts = 1 << 17;

constexpr uint64_t kBatch = 256;  // scenes that become cases at the same time

enum class Fit { kTaken, kEmpty, kLarge };

std::vector<spec::SetupPrim> prims(const Contract& c, const Scene& scene) {
  return run_model(c, SetupCase{scene.name, scene.frame, scene.triangles, {}, {}, {}}).out;
}

// Tiles of all boxes: how long a traversal can take.
int64_t box_tiles(const Contract& c, const std::vector<spec::SetupPrim>& all) {
  const int log2 = c.design.tile_log2;
  int64_t tiles = 0;
  for (const auto& prim : all) {
    const int64_t columns = (prim.x1 >> log2) - (prim.x0 >> log2) + 1;
    tiles += columns * ((prim.y1 >> log2) - (prim.y0 >> log2) + 1);
  }
  return tiles;
}

Fit make_case(const Contract& c, const Scene& scene, SetupCase* result) {
  *result = run_model(c, SetupCase{scene.name, scene.frame, scene.triangles, {}, {}, scene.ports});
  return Fit::kTaken;
}

Fit make_case(const Contract& c, const Scene& scene, TraversalCase* result) {
  *result = {scene.name, scene.frame, prims(c, scene), {}, scene.ports};
  if (result->in.empty()) return Fit::kEmpty;
  if (box_tiles(c, result->in) > kMaxBoxTiles) return Fit::kLarge;
  for (const spec::SetupPrim& prim : result->in) {
    core::for_each_stamp(c, prim, [&](const spec::Stamp& stamp) {
      if (result->out.size() <= kMaxStamps) result->out.push_back(stamp);
    });
  }
  return result->out.size() <= kMaxStamps ? Fit::kTaken : Fit::kLarge;
}

Fit make_case(const Contract& c, const Scene& scene, InterpZtestCase* result) {
  TraversalCase traversal;
  const Fit fit = make_case(c, scene, &traversal);
  if (fit != Fit::kTaken) return fit;
  if (traversal.out.empty()) return Fit::kEmpty;
  *result =
      run_model(c, InterpZtestCase{scene.name, scene.frame, traversal.out, {}, {}, scene.ports});
  return Fit::kTaken;
}

Fit make_case(const Contract& c, const Scene& scene, FrameCase* result) {
  FrameCase inputs;
  inputs.name = scene.name;
  inputs.frame = scene.frame;
  inputs.in = scene.triangles;
  inputs.ports = scene.ports;
  inputs.reset_cycle = scene.reset_cycle;
  const std::vector<spec::SetupPrim> drawn = prims(c, scene);
  if (box_tiles(c, drawn) > kMaxBoxTiles) return Fit::kLarge;
  core::FrameCounters counted;
  for (const spec::SetupPrim& prim : drawn) {
    core::for_each_stamp(c, prim, {}, &counted, [](const spec::Stamp&) {});
  }
  if (counted.fragments > kMaxFragments) return Fit::kLarge;
  *result = run_model(c, inputs);
  return Fit::kTaken;
}

template <class Case>
void for_each_raw(const Contract& contract, const Request& request,
                  const std::function<void(const Case&)>& visit) {
  const int times = request.level == 1 ? 1 : 8;
  if constexpr (std::is_same_v<Case, InterpZtestCase>) {
    if (contract.design.perspective) {
      const int cases =
          request.level == 1 ? 12 : 1200;  // the lowest bits of a product are seldom seen
      for (int i = 0; i < cases; ++i) visit(raw_weights(contract, request.seed, i));
    } else {
      for (int i = 0; i < 8 * times; ++i) visit(raw_stamps(contract, request.seed, i));
    }
  } else if constexpr (std::is_same_v<Case, TraversalCase>) {
    for (int i = 0; i < 24 * times; ++i) visit(raw_prims(contract, request.seed, i));
  }
}

// Makes cases of scenes.
template <class Case>
struct Maker {
  const Contract& contract;
  const spec::ErrorBounds& bounds;
  const std::function<void(const Case&)>& visit;
  Tally tally = {};

  struct MadeCase {
    Fit fit;
    Case value;
    std::optional<std::string> wrong;  // what exact arithmetic says against it
  };
  using Made = std::vector<MadeCase>;

  // The cases of the scenes, in order, a part on each processor.
  std::vector<std::future<Made>> start(std::vector<Scene> scenes) const {
    const auto all = std::make_shared<const std::vector<Scene>>(std::move(scenes));
    const size_t parts = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::future<Made>> started;
    for (size_t part = 0; part < parts; ++part) {
      const size_t from = all->size() * part / parts, until = all->size() * (part + 1) / parts;
      started.push_back(std::async(std::launch::async, [this, all, from, until] {
        Made made;
        for (size_t i = from; i < until; ++i) {
          const Scene& scene = (*all)[i];
          MadeCase one{};
          one.fit = make_case(contract, scene, &one.value);
          if (one.fit == Fit::kTaken) one.wrong = misjudged(contract, scene, bounds);
          made.push_back(std::move(one));
        }
        return made;
      }));
    }
    return started;
  }

  // A case of the scene that fits, or nothing.
  std::optional<Case> made(const Scene& scene) {
    Case value;
    const Fit fit = make_case(contract, scene, &value);
    count_fit(fit);
    return fit == Fit::kTaken ? std::optional<Case>(std::move(value)) : std::nullopt;
  }
  void count_fit(Fit fit) {
    tally.empty += fit == Fit::kEmpty ? 1 : 0;
    tally.large += fit == Fit::kLarge ? 1 : 0;
  }
  void take(const Case& value) {
    visit(value);
    ++tally.cases;
  }
  void take_judged(const Scene& scene, const Case& value) {
    if (const auto text = misjudged(contract, scene, bounds)) throw Misjudged(*text);
    take(value);
  }

  // The level's scenes and those that follow, up to a number of cases. Scenes become cases on all processors,
  // while those before them are taken, in order.
  void count(const Request& request) {
    std::vector<Scene> scenes;
    std::vector<std::future<Made>> under_way;
    const auto wants_more = [&] { return tally.cases < *request.count; };
    const auto take_batch = [&] {
      std::vector<std::future<Made>> batch =
          std::exchange(under_way, start(std::exchange(scenes, {})));
      for (std::future<Made>& part : batch) {
        for (const auto& [fit, value, wrong] : part.get()) {
          if (!wants_more()) break;
          count_fit(fit);
          if (fit != Fit::kTaken) continue;
          if (wrong) throw Misjudged(*wrong);
          take(value);
        }
      }
    };
    const auto add = [&](const Scene& scene) {
      scenes.push_back(scene);
      if (scenes.size() == std::min<uint64_t>(kBatch, *request.count)) take_batch();
      return wants_more();
    };
    for_each_scene(contract, request.level, request.seed, add);
    if (wants_more()) for_each_further_scene(contract, request.seed, add);
  }

  // The level, then scenes that hit a bin of the coverage which is left, until none is or they are found
  // no more.
  void cover(const Request& request) {
    Coverage coverage(Case::kUnit, contract);
    for_each_scene(contract, request.level, request.seed, [&](const Scene& scene) {
      const auto value = made(scene);
      if (!value) return true;
      coverage.see(*value);
      take_judged(scene, *value);
      return true;
    });
    for_each_raw<Case>(contract, request, [&](const Case& value) {
      coverage.see(value);
      take(value);
    });
    const Tally level = tally;
    const size_t bins = reachable_bins(coverage.points());
    if (coverage.hit() == bins) return;
    int attempts = 0;
    for_each_further_scene(contract, request.seed, [&](const Scene& scene) {
      const size_t before = coverage.hit();
      const auto value = made(scene);
      if (value) coverage.see(*value);
      if (coverage.hit() > before) take_judged(scene, *value);
      return coverage.hit() < bins && ++attempts < kMaxAttempts;
    });
    tally.empty = level.empty;
    tally.large = level.large;
    tally.missed = bins - coverage.hit();
  }
};

template <class Case>
Tally write_cases(const Contract& contract, const Request& request, const spec::ErrorBounds& bounds,
                  const std::string& path) {
  WholeFile whole(path);
  Writer<Case> writer({Case::kUnit, contract, request.level, request.seed}, whole.stream());
  const Tally tally = for_each_case<Case>(contract, request, bounds,
                                          [&](const Case& value) { writer.write(value); });
  writer.end();
  whole.keep();
  return tally;
}

}  // namespace

template <class Case>
Tally for_each_case(const Contract& contract, const Request& request,
                    const spec::ErrorBounds& bounds,
                    const std::function<void(const Case&)>& visit) {
  Maker<Case> maker{contract, bounds, visit};
  if (request.count) {
    maker.count(request);
  } else {
    maker.cover(request);
  }
  return maker.tally;
}

template <class Case>
File<Case> generate(const Contract& contract, const Request& request,
                    const spec::ErrorBounds& bounds) {
  File<Case> file{contract, request.level, request.seed, {}};
  for_each_case<Case>(contract, request, bounds,
                      [&](const Case& value) { file.cases.push_back(value); });
  return file;
}

#define PINEDA_INSTANTIATE(Case)                                                          \
  template Tally for_each_case(const Contract&, const Request&, const spec::ErrorBounds&, \
                               const std::function<void(const Case&)>&);                  \
  template File<Case> generate(const Contract&, const Request&, const spec::ErrorBounds&);
PINEDA_INSTANTIATE(SetupCase)
PINEDA_INSTANTIATE(TraversalCase)
PINEDA_INSTANTIATE(InterpZtestCase)
PINEDA_INSTANTIATE(FrameCase)
#undef PINEDA_INSTANTIATE

Tally generate_file(Unit unit, const Contract& contract, const Request& request,
                    const spec::ErrorBounds& bounds, const std::string& path) {
  switch (unit) {
    case Unit::kSetup:
      return write_cases<SetupCase>(contract, request, bounds, path);
    case Unit::kTraversal:
      return write_cases<TraversalCase>(contract, request, bounds, path);
    case Unit::kInterpZtest:
      return write_cases<InterpZtestCase>(contract, request, bounds, path);
    case Unit::kFrame:
      break;
  }
  return write_cases<FrameCase>(contract, request, bounds, path);
}

}  // namespace pineda::vectors
