#include "studies/run/derived.h"

#include <map>
#include <tuple>

namespace pineda::studies {
namespace {

/// The rows of one measure, by what they depend on.
class Rows {
 public:
  explicit Rows(const std::vector<Row>& rows) {
    for (const Row& row : rows) by_place_[{row.measure, row.scene, row.design, row.memory}] = &row;
  }
  const Row* find(Measure measure, const std::string& scene, const std::string& design,
                  const std::string& memory) const {
    const auto found = by_place_.find({spec::name_of(measure), scene, design, memory});
    return found == by_place_.end() ? nullptr : found->second;
  }

 private:
  std::map<std::tuple<std::string, std::string, std::string, std::string>, const Row*> by_place_;
};

std::optional<double> hit_rate(const Row& row, const std::string& cache) {
  const auto accesses = figure(row, cache + ".accesses");
  if (!accesses || *accesses == 0) return std::nullopt;
  return 1 - *figure(row, cache + ".misses") / *accesses;
}

Throughput throughput(const Rows& rows, const Row& frame, const Row& timing) {
  Throughput t;
  t.scene = frame.scene;
  t.design = frame.design;
  t.memory = frame.memory;
  t.technology = timing.memory;
  t.cycles = *figure(frame, "cycles");
  t.fmax_mhz = *figure(timing, "fmax_mhz");
  const double frames_per_second = 1e6 * t.fmax_mhz / t.cycles;
  t.triangles_per_second = frames_per_second * *figure(frame, "triangles");
  t.samples_per_second = frames_per_second * *figure(frame, "fragments");
  if (const Row* area = rows.find(Measure::kArea, "", frame.design, timing.memory)) {
    t.area_mm2 = 1e-6 * *figure(*area, "area_um2");
  }
  if (const Row* bytes = rows.find(Measure::kBandwidth, frame.scene, frame.design, frame.memory)) {
    t.read_mb_per_second = 1e-6 * frames_per_second * *figure(*bytes, "bytes_read");
    t.written_mb_per_second = 1e-6 * frames_per_second * *figure(*bytes, "bytes_written");
    t.depth_hit_rate = hit_rate(*bytes, "depth");
    t.color_hit_rate = hit_rate(*bytes, "color");
  }
  return t;
}

}  // namespace

std::optional<double> figure(const Row& row, const std::string& name) {
  for (const Figure& f : row.figures) {
    if (f.name == name) return f.value;
  }
  return std::nullopt;
}

std::vector<Throughput> throughputs(const std::vector<Row>& rows) {
  const Rows by_place(rows);
  std::vector<Throughput> all;
  for (const Row& frame : rows) {
    if (frame.measure != spec::name_of(Measure::kCycles)) continue;
    for (const Row& timing : rows) {
      if (timing.measure != spec::name_of(Measure::kTiming) || timing.design != frame.design)
        continue;
      all.push_back(throughput(by_place, frame, timing));
    }
  }
  return all;
}

}  // namespace pineda::studies
