#include "cli/report/differ.h"

#include <filesystem>

#include "cli/reserved_file.h"
#include "cli/triangles.h"

namespace pineda::cli {
namespace {

using studies::Boundary;
using studies::ByBoundary;
using studies::Token;
using studies::TokenListener;

constexpr const char* kLooking = "looking at the difference";

/// Draws the frame once more: run(pull).
template <class Run>
auto once_more(const Rerun& rerun, Run run) {
  rerun.scene.source->rewind();
  ChunkedTriangles triangles(rerun.scene.source.get(), rerun.progress, kLooking);
  return run([&](spec::Triangle* t) { return triangles.next(t); });
}

studies::TokenDifference find_token(const Rerun& rerun, uint32_t triangle) {
  ByBoundary<int64_t> model, rtl;
  const auto keep = [triangle](ByBoundary<int64_t>* cycles) {
    return [triangle, cycles](Boundary boundary, const Token& token) {
      if (token.triangle == triangle)
        (*cycles)[static_cast<size_t>(boundary)].push_back(token.cycle);
    };
  };
  TokenListener model_tokens(keep(&model));
  TokenListener rtl_tokens(keep(&rtl));
  once_more(rerun, [&](const auto& pull) {
    return rerun.model->run(rerun.scene.frame, pull, &model_tokens);
  });
  tb::FrameBench bench(rerun.library, rerun.bench);
  once_more(rerun,
            [&](const auto& pull) { return bench.run(rerun.scene.frame, pull, &rtl_tokens); });
  // There is a difference, since the triangle's last writes are in different cycles.
  return studies::first_token_difference(model, rtl).value();
}

/// Records what the model's units do in one cycle, beside its tokens.
class ModelStates final : public TokenListener {
 public:
  ModelStates(See see, timing::Cycle cycle, StatesAround* states)
      : TokenListener(std::move(see)), cycle_(cycle), states_(*states) {
    states_.causes.fill(timing::Cause::kStarved);  // starved cycles are not reported
  }
  void spent(timing::Unit unit, timing::Cause cause, timing::Cycle from, timing::Cycle until,
             uint32_t id) override {
    if (cycle_ < from || cycle_ >= until) return;
    states_.causes[static_cast<size_t>(unit)] = cause;
    states_.triangles[static_cast<size_t>(unit)] = id;
  }

 private:
  timing::Cycle cycle_;
  StatesAround& states_;
};

/// Fills in the states around d->token.cycle() and writes the waveform.
void look_around(const Rerun& rerun, const std::string& waveform, FirstRetireDifference* d) {
  const int64_t at = d->token.cycle();
  const auto keep = [d](StatesAround* states) {
    return [d, states](Boundary boundary, const Token& token) {
      if (token.cycle < d->from || token.cycle >= d->until) return;
      states->tokens[static_cast<size_t>(boundary)].push_back(token);
    };
  };
  TokenListener rtl(keep(&d->rtl));
  tb::FrameBench bench(rerun.library, rerun.bench);
  const tb::CloseUp close_up{d->from, at, d->until, waveform};
  d->rtl.causes = once_more(rerun, [&](const auto& pull) {
    return bench.run_close_up(rerun.scene.frame, pull, &rtl, close_up);
  });
  // Runs last: it reads the scene to its end, so that the scene's counters are complete again.
  ModelStates model(keep(&d->model), at, &d->model);
  once_more(rerun,
            [&](const auto& pull) { return rerun.model->run(rerun.scene.frame, pull, &model); });
  for (StatesAround* side : {&d->model, &d->rtl}) {
    for (auto& tokens : side->tokens) tokens = studies::tokens_around(tokens, at);
  }
}

std::string cycle_text(int64_t cycle) {
  return cycle < 0 ? "never" : grouped(static_cast<uint64_t>(cycle));
}

std::string cycles_text(int64_t model, int64_t rtl) {
  return fmt::format("model {}, RTL {}", cycle_text(model), cycle_text(rtl));
}

std::string tokens_text(const std::vector<Token>& tokens) {
  std::string text;
  for (const Token& token : tokens) {
    text += fmt::format("{}{} in {}", text.empty() ? "" : ", ", token.triangle,
                        cycle_text(token.cycle));
  }
  return text.empty() ? "none near" : "of triangle " + text;
}

std::string states_text(const StatesAround& states) {
  std::string text;
  for (size_t u = 0; u < timing::kUnits; ++u) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ",
                        timing::unit_name(static_cast<timing::Unit>(u)),
                        timing::cause_name(states.causes[u]));
    if (states.triangles[u]) text += fmt::format(" ({})", *states.triangles[u]);
  }
  return text;
}

// The boundary where the sides differ and the one before it; setup's, the first one, and the next.
std::vector<Boundary> shown(Boundary boundary) {
  if (boundary == Boundary::kPrim) return {boundary, Boundary::kStamp};
  if (boundary == Boundary::kStamp) return {Boundary::kPrim, boundary};
  return {Boundary::kStamp, boundary};
}

Json side_json(const StatesAround& states) {
  Json json;
  for (size_t u = 0; u < timing::kUnits; ++u) {
    json["units"][timing::unit_name(static_cast<timing::Unit>(u))] =
        timing::cause_name(states.causes[u]);
  }
  for (size_t b = 0; b < studies::kBoundaries; ++b) {
    Json& tokens = json["tokens"][studies::boundary_name(static_cast<Boundary>(b))] = Json::array();
    for (const Token& token : states.tokens[b]) {
      tokens.push_back({{"triangle", token.triangle}, {"cycle", token.cycle}});
    }
  }
  return json;
}

}  // namespace

std::optional<FirstRetireDifference> find_retire_difference(const Rerun& rerun,
                                                            const std::vector<int64_t>& model,
                                                            const std::vector<int64_t>& rtl,
                                                            const std::string& folder) {
  const std::string path = folder.empty() ? "" : folder + "/differ.fst";
  const auto retire = studies::first_retire_difference(model, rtl);
  if (!retire) {
    std::error_code ignored;  // or an older one would be taken for this run's
    if (!path.empty()) std::filesystem::remove(path, ignored);
    return std::nullopt;
  }
  FirstRetireDifference found;
  found.retire = *retire;
  std::optional<ReservedFile> file;
  if (!path.empty()) file.emplace(path);
  found.token = find_token(rerun, retire->triangle);
  found.from = std::max<int64_t>(0, found.token.cycle() - kWaveformCycles);
  found.until = found.token.cycle() + kWaveformCycles + 1;
  look_around(rerun, file ? file->temporary() : "", &found);
  if (file) file->keep(true);
  found.waveform = path;
  return found;
}

std::string retire_text(const studies::RetireErrors& e) {
  if (e.off == 0) return fmt::format("{} triangles, all equal", grouped(e.triangles));
  return fmt::format("{} triangles, {} in another cycle: by {} at most (triangle {}), p99 {}",
                     grouped(e.triangles), grouped(e.off), grouped(static_cast<uint64_t>(e.max)),
                     e.worst, grouped(static_cast<uint64_t>(e.p99)));
}

std::vector<std::pair<std::string, std::string>> difference_rows(const FirstRetireDifference& d) {
  std::vector<std::pair<std::string, std::string>> rows;
  const auto& token = d.token;
  rows.emplace_back("  first triangle",
                    fmt::format("{} retires at another cycle ({})", d.retire.triangle,
                                cycles_text(d.retire.model, d.retire.rtl)));
  rows.emplace_back("  first in",
                    fmt::format("{}: its {} {} ({})", studies::unit_before(token.boundary),
                                studies::boundary_name(token.boundary), token.index + 1,
                                cycles_text(token.model, token.rtl)));
  for (const Boundary b : shown(token.boundary)) {
    const std::string name = std::string("  ") + studies::boundary_name(b);
    rows.emplace_back(name + ", model", tokens_text(d.model.tokens[static_cast<size_t>(b)]));
    rows.emplace_back(name + ", RTL", tokens_text(d.rtl.tokens[static_cast<size_t>(b)]));
  }
  const std::string at = cycle_text(token.cycle());
  rows.emplace_back("  model in " + at, states_text(d.model));
  rows.emplace_back("  RTL in " + at, states_text(d.rtl));
  rows.emplace_back("  waveform",
                    d.waveform.empty()
                        ? "-o DIR writes the RTL's around that cycle"
                        : fmt::format("{}: cycles {} to {}, cycle c from time 2c + 4", d.waveform,
                                      cycle_text(d.from), cycle_text(d.until - 1)));
  return rows;
}

Json retire_json(const studies::RetireErrors& e) {
  return {{"triangles", e.triangles}, {"off", e.off}, {"p99", e.p99}, {"max", e.max}};
}

Json difference_json(const std::optional<FirstRetireDifference>& difference) {
  if (!difference) return nullptr;
  const FirstRetireDifference& d = *difference;
  Json json = {{"triangle", d.retire.triangle},
               {"unit", studies::unit_before(d.token.boundary)},
               {"model", d.retire.model},
               {"rtl", d.retire.rtl}};
  json["token"] = {{"boundary", studies::boundary_name(d.token.boundary)},
                   {"index", d.token.index},
                   {"model", d.token.model},
                   {"rtl", d.token.rtl}};
  json["around"] = {
      {"cycle", d.token.cycle()}, {"model", side_json(d.model)}, {"rtl", side_json(d.rtl)}};
  if (!d.waveform.empty()) {
    json["waveform"] = {{"file", d.waveform}, {"from", d.from}, {"until", d.until}};
  }
  return json;
}

}  // namespace pineda::cli
