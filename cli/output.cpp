#include "cli/output.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "model/scene/writers.h"

namespace pineda::cli {

using spec::name_of;

Output::Output(const Options& options)
    : json_(options.json), quiet_(options.quiet), file_(options.json == "-" ? stderr : stdout) {}

void Output::put(const std::string& text) const {
  const bool written = std::fwrite(text.data(), 1, text.size(), file_) == text.size();
  if (!written && file_ == stdout) flush_stdout();
}

void Output::row(const std::string& name, const std::string& value) const {
  line("  {:<22}{}", name, value);
}

void Output::warn(const std::string& text) const { fmt::print(stderr, "pineda: {}\n", text); }

void Output::say(const std::string& text) const {
  if (!quiet_) warn(text);
}

void Output::json(const Json& value) const {
  if (json_.empty()) return;
  const std::string text = value.dump(2) + "\n";
  if (json_ == "-") {
    fmt::print(stdout, "{}", text);
    flush_stdout();
  } else {
    scene::write_file(json_, text);
  }
}

void flush_stdout() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw scene::InputError("standard output",
                          fmt::format("expected to write it, got: {}", std::strerror(errno)));
}

Progress::Progress(const Options& options)
    : shown_(!options.quiet && isatty(STDERR_FILENO) != 0),
      last_(std::chrono::steady_clock::now()) {}

void Progress::update(const char* phase, uint64_t done) {
  if (!shown_ || (done & 63) != 0) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  dirty_ = true;
  fmt::print(stderr, "\r\033[K{}{}", phase,
             done == 0 ? std::string() : fmt::format(": {} triangles", grouped(done)));
  std::fflush(stderr);
}

void Progress::clear() {
  if (!dirty_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  dirty_ = false;
}

std::string grouped(uint64_t value) {
  std::string text = std::to_string(value);
  for (int i = static_cast<int>(text.size()) - 3; i > 0; i -= 3) {
    text.insert(static_cast<size_t>(i), ",");
  }
  return text;
}

double median(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  const size_t middle = seconds.size() / 2;
  return seconds.size() % 2 == 1 ? seconds[middle] : (seconds[middle - 1] + seconds[middle]) / 2;
}

Json header_json(const scene::Scene& scene, const spec::Contract& contract) {
  Json json{{"scene", scene.name},
            {"design", contract.design.name},
            {"width", scene.frame.width},
            {"height", scene.frame.height},
            {"cull", name_of(scene.frame.cull)},
            {"depth_func", name_of(scene.frame.depth)}};
  const Json state = unusual_state_json(scene.frame);
  json.insert(state.begin(), state.end());
  return json;
}

Json unusual_state_json(const spec::FrameState& f) {
  Json json = Json::object();
  if (scene::is_cut(f)) {
    json["scissor"] = {{"x", f.clip_x0()},
                       {"y", f.clip_y0()},
                       {"width", std::max(f.clip_x1() - f.clip_x0(), 0)},
                       {"height", std::max(f.clip_y1() - f.clip_y0(), 0)}};
  }
  if (!f.depth_write) json["depth_write"] = name_of(f.depth_write);
  if (f.has_bias()) {
    json["depth_bias"] = {{"constant", f.bias_constant},
                          {"slope", f.bias_slope / double{1 << spec::kBiasFactorFractionBits}}};
  }
  if (f.clear_depth != 1) json["clear_depth"] = f.clear_depth;
  if (f.shade != spec::Shade::kSmooth) json["shade"] = name_of(f.shade);
  return json;
}

Json input_json(const scene::Counters& c) {
  return {{"triangles", c.triangles},         {"nan_dropped", c.nan_dropped},
          {"saturated", c.saturated},         {"z_clamped", c.z_clamped},
          {"denormals", c.denormals},         {"clipped", c.clipped},
          {"clipped_away", c.clipped_away},   {"perspective", c.perspective},
          {"affine_colors", c.affine_colors}, {"affine_lsb", c.affine_lsb},
          {"rounded_slope", c.rounded_slope}};
}

Json counters_json(const core::FrameCounters& c, bool depth_tests) {
  Json json;
  for (const core::FrameCounter& row : core::kFrameCounters) {
    const std::string place = row.json();
    if (place.empty() || (row.known == core::Known::kIfTested && !depth_tests)) continue;
    json[Json::json_pointer(place)] = row.of(c);
  }
  return json;
}

void print_notes(const Output& output, const scene::Scene& scene) {
  for (const auto& warning : scene.warnings)
    output.warn(fmt::format("{}: {}", scene.name, warning));
  for (const auto& note : scene::notes(scene)) {
    output.warn(fmt::format("{}: {}", scene.name, note));
  }
}

void print_state(const Output& output, const scene::Scene& scene) {
  std::string text = scene::unusual_state(scene.frame);
  if (!text.empty()) output.row("state", text);
}

void print_counters(const Output& output, const core::FrameCounters& c, bool depth_tests) {
  uint64_t dropped = 0;
  std::string causes;
  for (int i = 1; i < core::kDropCauses; ++i) {
    const uint64_t count = c.dropped[static_cast<size_t>(i)];
    if (count == 0) continue;
    dropped += count;
    causes += fmt::format("{}{} {}", causes.empty() ? "" : ", ", grouped(count),
                          core::drop_name(static_cast<core::Drop>(i)));
  }
  output.row("triangles set up", grouped(c.triangles));
  output.row("  dropped", causes.empty() ? "0" : fmt::format("{} ({})", grouped(dropped), causes));
  output.row(
      "tiles tested",
      fmt::format("{} ({} rejected, {} accepted whole{})", grouped(c.tiles_tested),
                  grouped(c.tiles_rejected), grouped(c.tiles_accepted),
                  c.tiles_hidden == 0 ? "" : fmt::format(", {} hidden", grouped(c.tiles_hidden))));
  const auto also = [&](const char* text, uint64_t count) {
    return depth_tests ? fmt::format(fmt::runtime(text), grouped(count)) : std::string();
  };
  output.row("stamps", grouped(c.stamps) + also(" ({} seen, so interpolated)", c.interpolated));
  output.row("covered samples", grouped(c.fragments) + also(" ({} written)", c.passed));
}

}  // namespace pineda::cli
