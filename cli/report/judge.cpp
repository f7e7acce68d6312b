#include "cli/report/judge.h"

#include <algorithm>
#include <cmath>

#include "studies/judge/truth.h"

namespace pineda::cli {
namespace {

/// The exact samples of one triangle, as many rows at a time as a row of tiles has: memory stays
/// bounded whatever the frame.
class TileRowTruth {
 public:
  TileRowTruth(const exact::ScreenJudge& judge, const spec::Design& design)
      : judge_(judge),
        perspective_(design.perspective && !judge.affine()),
        rows_(size_t{1} << design.tile_log2) {}

  /// nullptr: not covered.
  const exact::Sample* find(int x, int y) {
    Row& row = rows_[static_cast<size_t>(y) % rows_.size()];
    if (row.y != y) {
      row.y = y;
      row.samples.clear();
      judge_.row(y, perspective_, &row.samples);
    }
    if (row.samples.empty() || x < row.samples.front().x || x > row.samples.back().x) {
      return nullptr;
    }
    return &row.samples[static_cast<size_t>(x - row.samples.front().x)];
  }
  bool with_perspective() const { return perspective_; }
  int first_vertex(int attribute) const {
    return judge_.snapped().vertices()[0].attr[static_cast<size_t>(attribute)];
  }

 private:
  struct Row {
    int y = -1;
    std::vector<exact::Sample> samples;
  };
  const exact::ScreenJudge& judge_;
  bool perspective_;
  std::vector<Row> rows_;
};

/// Sees the stamps of one triangle.
struct JudgeSink {
  const spec::Contract& contract;
  const spec::FrameState& frame;
  TileRowTruth truth;
  spec::ErrorBounds bounds;  // this triangle's
  Judgement* to;
  studies::MeshJudge* mesh;                 // null: no mesh
  uint64_t right = 0;                       // samples that both cover
  std::array<int, 4> last{-1, -1, -1, -1};  // tile row, tile column, row, column of a stamp

  void prim(const spec::SetupPrim&) {}
  void depth(const spec::DepthWrite&) {}
  void color(const spec::ColorWrite&) {}
  void stamp(const spec::Stamp&) {}
  void fragment(const spec::Stamp& stamp, const spec::Fragment& fragment) {
    const spec::Design& d = contract.design;
    if (mesh != nullptr) hit_mesh(stamp, fragment);
    const std::array<int, 4> now{stamp.y >> (d.tile_log2 - d.stamp_height_log2),
                                 stamp.x >> (d.tile_log2 - d.stamp_width_log2), stamp.y, stamp.x};
    if (now <= last) {  // sent before: it must not make up for one that is missing
      const auto samples = static_cast<uint64_t>(__builtin_popcount(stamp.mask));
      to->samples += samples;
      to->extra += samples;
      return;
    }
    last = now;
    for (int lane = 0; lane < contract.width.lanes; ++lane) {
      if ((stamp.mask >> lane & 1) == 0) continue;
      sample(lane_x(stamp, lane), lane_y(stamp, lane), fragment.z[static_cast<size_t>(lane)],
             fragment.attr[static_cast<size_t>(lane)], stamp.planes.flat);
    }
  }

  void hit_mesh(const spec::Stamp& stamp, const spec::Fragment& fragment) {
    const spec::Design& d = contract.design;
    for (int lane = 0; lane < contract.width.lanes; ++lane) {
      if ((stamp.mask >> lane & 1) == 0) continue;
      const auto i = static_cast<size_t>(lane);
      studies::MeshHit hit{lane_x(stamp, lane), lane_y(stamp, lane), stamp.id, fragment.z[i], {}};
      const auto smooth = static_cast<size_t>(d.attributes);
      for (size_t k = 0; k < hit.color.size(); ++k) {
        hit.color[k] = k < smooth ? fragment.attr[i][k] : stamp.planes.flat[k - smooth];
      }
      mesh->hit(hit);
    }
  }

  int lane_x(const spec::Stamp& stamp, int lane) const {
    const int log2 = contract.design.stamp_width_log2;
    return (stamp.x << log2) + (lane & ((1 << log2) - 1));
  }
  int lane_y(const spec::Stamp& stamp, int lane) const {
    const spec::Design& d = contract.design;
    return (stamp.y << d.stamp_height_log2) + (lane >> d.stamp_width_log2);
  }

  void sample(int x, int y, uint32_t z, const spec::Attributes& attr,
              const spec::Attributes& flat) {
    ++to->samples;
    const exact::Sample* exact = truth.find(x, y);
    if (exact == nullptr) {
      ++to->extra;
      return;
    }
    ++right;
    const spec::Design& d = contract.design;
    const double depth_ulp = d.depth_test ? std::abs(exact->z.error_of(z)) : 0;
    to->max_depth_ulp = std::max(to->max_depth_ulp, depth_ulp);
    bool beyond = depth_ulp > bounds.depth_ulp;
    for (int a = 0; a < spec::channels(d); ++a) {
      const bool is_flat = a >= d.attributes;
      const int32_t value =
          is_flat ? flat[static_cast<size_t>(a - d.attributes)] : attr[static_cast<size_t>(a)];
      const exact::Value wanted = is_flat ? exact::Value{truth.first_vertex(a), 0, 0}
                                          : channel(*exact, static_cast<size_t>(a));
      const double error = std::abs(wanted.error_of(value));
      to->max_color_lsb = std::max(to->max_color_lsb, error);
      const bool must_equal = is_flat || frame.shade == spec::Shade::kFlat;
      beyond = beyond || error > (must_equal ? 0 : bounds.attribute_lsb);
    }
    to->beyond += beyond ? 1 : 0;
  }

  /// Channels after the colour are 0 everywhere.
  exact::Value channel(const exact::Sample& exact, size_t a) const {
    if (a >= exact.affine.size()) return {};
    return truth.with_perspective() ? exact.perspective[a] : exact.affine[a];
  }
};

}  // namespace

exact::ScreenTriangle stated(const scene::ScreenTriangle& triangle) {
  exact::ScreenTriangle result;
  for (size_t i = 0; i < 3; ++i) {
    const scene::ScreenVertex& v = triangle.v[i];
    result[i] = {v.x, v.y, v.z, v.w, {v.rgba[0], v.rgba[1], v.rgba[2], v.rgba[3]}};
  }
  return result;
}

Judgement judge(const scene::Scene& scene, core::Renderer* renderer, Progress* progress) {
  const spec::Contract& contract = renderer->contract();
  const spec::FrameState& frame = renderer->frame();
  const auto format = studies::format_of(contract.design);
  const auto exact_frame = studies::exact_frame(frame);
  const spec::ErrorBounds bounds = spec::error_bounds(contract.design);
  const double slope = std::ldexp(frame.bias_slope, -spec::kBiasFactorFractionBits);
  Judgement judgement;
  judgement.bounds = bounds;
  std::optional<studies::MeshJudge> mesh;
  if (scene.mesh) mesh.emplace(*scene.mesh, contract, frame);
  spec::Triangle triangle;
  while (scene.source->next(&triangle)) {
    progress->update("exact judge", triangle.id);
    const exact::ScreenJudge screen(stated(scene.source->screen()), format, exact_frame);
    spec::ErrorBounds own = bounds;
    own.depth_ulp += spec::depth_bias_error_bound(contract.design, slope, screen.depth_slope());
    judgement.bounds.depth_ulp = std::max(judgement.bounds.depth_ulp, own.depth_ulp);
    JudgeSink sink{contract, frame,      TileRowTruth(screen, contract.design),
                   own,      &judgement, mesh ? &*mesh : nullptr};
    renderer->draw(triangle, sink);
    judgement.missing += static_cast<uint64_t>(screen.snapped().samples()) - sink.right;
  }
  if (mesh) judgement.mesh = mesh->finish();
  return judgement;
}

std::string mesh_text(const studies::MeshJudgement& j) {
  const std::string judged =
      fmt::format("{} faces from clip space, {} samples, {} of them in an edge's band",
                  grouped(j.faces), grouped(j.samples), grouped(j.banded));
  const std::string bent =
      j.bent == 0 ? ""
                  : fmt::format(
                        "; {} polygons are not plane: judged by the triangles that they "
                        "were cut into",
                        grouped(j.bent));
  if (!j.first) return judged + bent;
  return fmt::format("{}{}; {} WRONG, first ({}, {}) of triangle {}: {}", judged, bent,
                     grouped(j.wrong), j.first->x, j.first->y, j.first->triangle, j.first->what);
}

Json mesh_json(const studies::MeshJudgement& j) {
  Json json = {{"faces", j.faces},
               {"bent", j.bent},
               {"samples", j.samples},
               {"banded", j.banded},
               {"wrong", j.wrong}};
  if (j.first) {
    json["first"] = {{"x", j.first->x},
                     {"y", j.first->y},
                     {"triangle", j.first->triangle},
                     {"what", j.first->what}};
  }
  return json;
}

}  // namespace pineda::cli
