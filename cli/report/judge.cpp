#include "cli/report/judge.h"

#include <algorithm>

#include "studies/judge/stated.h"

namespace pineda::cli {
namespace {

/// Takes the stamps of one triangle after another to the judges.
struct JudgeSink {
  const spec::Design& design;
  judge::TileRowComparison* comparison;
  studies::MeshJudge* mesh;  // null: no mesh

  void prim(const spec::SetupPrim&) {}
  void depth(const spec::DepthWrite&) {}
  void color(const spec::ColorWrite&) {}
  void stamp(const spec::Stamp&) {}
  void fragment(const spec::Stamp& stamp, const spec::Fragment& fragment) {
    judge::for_each_sample(design, stamp, fragment, [&](const judge::Drawn& drawn) {
      if (mesh != nullptr) hit_mesh(stamp.id, drawn);
      comparison->sample(drawn);
    });
  }

  void hit_mesh(uint32_t triangle, const judge::Drawn& drawn) const {
    studies::MeshHit hit{drawn.x, drawn.y, triangle, static_cast<uint32_t>(drawn.z), {}};
    std::copy_n(drawn.attr.begin(), hit.color.size(), hit.color.begin());
    mesh->hit(hit);
  }
};

}  // namespace

Judgement judge(const scene::Scene& scene, core::Renderer* renderer, Progress* progress) {
  const spec::Design& design = renderer->contract().design;
  const spec::FrameState& frame = renderer->frame();
  const auto format = judge::format_of(design);
  const auto exact_frame = judge::exact_frame(frame);
  Judgement judgement;
  judgement.bounds = spec::error_bounds(design);
  std::optional<studies::MeshJudge> mesh;
  if (scene.mesh) mesh.emplace(*scene.mesh, renderer->contract(), frame);
  judge::TileRowComparison comparison(judge::values_of(design), design.tile_log2, &judgement);
  JudgeSink sink{design, &comparison, mesh ? &*mesh : nullptr};
  spec::Triangle triangle;
  while (scene.source->next(&triangle)) {
    progress->update("exact judge", triangle.id);
    const exact::ScreenJudge screen(studies::stated(scene.source->screen()), format, exact_frame);
    const auto bounds = judge::triangle_bounds(design, frame, screen.depth_slope());
    judgement.bounds.depth_ulp = std::max(judgement.bounds.depth_ulp, bounds.depth_ulp);
    comparison.begin(screen, bounds, triangle.id);
    renderer->draw(triangle, sink);
    comparison.end();
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
