#include "vectors/generator/generate.h"

#include "model/spec/package.h"
#include "model/spec/random.h"

namespace pineda::vectors {
namespace {

using spec::Contract;

// Limits that keep the committed files small; a larger scene is used for the other units only.
constexpr size_t kMaxStamps = 80;
constexpr int64_t kMaxFrameCaseSamples = 512;
constexpr int64_t kMaxBoxTiles = 65536;

enum class Fit { kTaken, kEmpty, kLarge };

int64_t samples(const spec::FrameState& frame) { return int64_t{frame.width} * frame.height; }

std::vector<spec::SetupPrim> prims(const Contract& c, const Scene& scene) {
  return run_model(c, SetupCase{scene.name, scene.frame, scene.triangles, {}, {}}).out;
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
  *result = run_model(c, SetupCase{scene.name, scene.frame, scene.triangles, {}, {}});
  return Fit::kTaken;
}

Fit make_case(const Contract& c, const Scene& scene, TraversalCase* result) {
  TraversalCase inputs{scene.name, scene.frame, prims(c, scene), {}};
  if (inputs.in.empty()) return Fit::kEmpty;
  if (box_tiles(c, inputs.in) > kMaxBoxTiles) return Fit::kLarge;
  *result = run_model(c, inputs);
  return result->out.size() <= kMaxStamps ? Fit::kTaken : Fit::kLarge;
}

Fit make_case(const Contract& c, const Scene& scene, InterpZtestCase* result) {
  if (samples(scene.frame) > kMaxFrameSamples) return Fit::kLarge;
  TraversalCase traversal;
  const Fit fit = make_case(c, scene, &traversal);
  if (fit != Fit::kTaken) return fit;
  if (traversal.out.empty()) return Fit::kEmpty;
  *result = run_model(c, InterpZtestCase{scene.name, scene.frame, traversal.out, {}, {}});
  return Fit::kTaken;
}

Fit make_case(const Contract& c, const Scene& scene, FrameCase* result) {
  if (samples(scene.frame) > kMaxFrameCaseSamples) return Fit::kLarge;
  *result = run_model(c, FrameCase{scene.name, scene.frame, scene.triangles, {}, {}});
  return Fit::kTaken;
}

// A plane with every bit random: it wraps and leaves the output's range.
spec::Plane raw_plane(spec::Random& random, int bits) {
  const auto any = [&] { return spec::wrap(static_cast<int64_t>(random.bits()), bits); };
  return {any(), any(), any()};
}

// Stamps with random planes, as no triangle gives them: they wrap, clamp and round where scenes
// cannot. The exact judge cannot check them; core alone defines their results.
InterpZtestCase raw_stamps(const Contract& c, uint64_t seed, int index) {
  spec::Random random(seed ^ spec::text_hash("raw_planes." + std::to_string(index)));
  const spec::Design& d = c.design;
  InterpZtestCase inputs;
  inputs.name = "raw_planes." + std::to_string(index);
  inputs.frame.width = inputs.frame.height = 2 << d.tile_log2;
  inputs.frame.depth = static_cast<spec::DepthFunc>(index % 9);
  for (uint32_t i = 0; i < 12; ++i) {
    spec::Stamp stamp;
    stamp.id = i;
    stamp.x = static_cast<int>(random.between(0, (2 << d.tile_log2 >> d.stamp_width_log2) - 1));
    stamp.y = static_cast<int>(random.between(0, (2 << d.tile_log2 >> d.stamp_height_log2) - 1));
    stamp.mask = static_cast<uint32_t>(random.between(1, (int64_t{1} << c.width.lanes) - 1));
    stamp.planes.z = raw_plane(random, c.width.depth_tile_plane);
    stamp.planes.z_bias = spec::wrap(static_cast<int64_t>(random.bits()), c.width.depth_bias);
    for (size_t a = 0; a < static_cast<size_t>(d.attributes); ++a) {
      stamp.planes.attr[a] = raw_plane(random, c.width.attr_tile_plane);
    }
    inputs.in.push_back(stamp);
  }
  return run_model(c, inputs);
}

void add_raw(uint64_t seed, File<InterpZtestCase>* file) {
  // These stamps have no edges, hence no weights for perspective.
  if (file->contract.design.perspective) return;
  const int count = file->level == 1 ? 8 : 64;
  for (int i = 0; i < count; ++i) file->cases.push_back(raw_stamps(file->contract, seed, i));
}
template <class Case>
void add_raw(uint64_t, File<Case>*) {}

template <class Case>
Tally generate_one(const Contract& contract, int level, uint64_t seed,
                   const spec::ErrorBounds& bounds, const std::string& path) {
  Tally tally;
  write(path, generate<Case>(contract, level, seed, bounds, &tally));
  return tally;
}

}  // namespace

template <class Case>
File<Case> generate(const Contract& contract, int level, uint64_t seed,
                    const spec::ErrorBounds& bounds, Tally* tally) {
  File<Case> file{contract, level, seed, {}};
  Tally count;
  for (const Scene& scene : scenes(contract, level, seed)) {
    Case made;
    const Fit fit = make_case(contract, scene, &made);
    count.empty += fit == Fit::kEmpty ? 1 : 0;
    count.large += fit == Fit::kLarge ? 1 : 0;
    if (fit != Fit::kTaken) continue;
    if (const auto text = misjudged(contract, scene, bounds)) throw Misjudged(*text);
    file.cases.push_back(std::move(made));
  }
  add_raw(seed, &file);
  count.cases = file.cases.size();
  if (tally != nullptr) *tally = count;
  return file;
}

template File<SetupCase> generate(const Contract&, int, uint64_t, const spec::ErrorBounds&, Tally*);
template File<TraversalCase> generate(const Contract&, int, uint64_t, const spec::ErrorBounds&,
                                      Tally*);
template File<InterpZtestCase> generate(const Contract&, int, uint64_t, const spec::ErrorBounds&,
                                        Tally*);
template File<FrameCase> generate(const Contract&, int, uint64_t, const spec::ErrorBounds&, Tally*);

Tally generate_file(Unit unit, const Contract& contract, int level, uint64_t seed,
                    const spec::ErrorBounds& bounds, const std::string& path) {
  switch (unit) {
    case Unit::kSetup:
      return generate_one<SetupCase>(contract, level, seed, bounds, path);
    case Unit::kTraversal:
      return generate_one<TraversalCase>(contract, level, seed, bounds, path);
    case Unit::kInterpZtest:
      return generate_one<InterpZtestCase>(contract, level, seed, bounds, path);
    case Unit::kFrame:
      break;
  }
  return generate_one<FrameCase>(contract, level, seed, bounds, path);
}

}  // namespace pineda::vectors
