// A frame by the SystemC model and by the RTL, both from an installed tree: the same cycles.
#include <cstdio>

#include "model/timing/raster_top.h"
#include "tb/frame_bench.h"

namespace {

using namespace pineda;  // NOLINT: a program, not a header

std::vector<spec::Triangle> triangles() {
  std::vector<spec::Triangle> all;
  for (int i = 0; i < 20; ++i) {
    spec::Triangle t;
    t.id = static_cast<uint32_t>(i);
    const int px[3][2] = {{i, 2 * i}, {3 * i, 60 - i}, {63 - i, 30 + i}};
    for (size_t k = 0; k < 3; ++k) {
      t.v[k].x = px[k][0] * 256;
      t.v[k].y = px[k][1] * 256;
      t.v[k].z = int64_t{1000} * (i + 1) << 8;
    }
    all.push_back(t);
  }
  return all;
}

}  // namespace

int sc_main(int, char*[]) {
  const spec::Contract contract = spec::contract(spec::kHighTile);
  const spec::FrameState frame{64, 64};
  timing::RasterTop model("rasterizer", contract);
  const auto predicted = model.run(frame, triangles());

  const tb::RtlLibrary library(contract);
  tb::FrameBench bench(library, {});
  size_t next = 0;
  const auto all = triangles();
  const auto counted = bench.run(
      frame,
      [&](spec::Triangle* t) {
        if (next == all.size()) return false;
        *t = all[next++];
        return true;
      },
      nullptr);
  std::printf("model %lld cycles, RTL %lld cycles\n", static_cast<long long>(predicted.cycles),
              static_cast<long long>(counted.cycles));
  return predicted.cycles == counted.cycles && predicted.cycles > 0 ? 0 : 1;
}
