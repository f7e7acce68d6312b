#include "bench/rounds.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

namespace pineda::bench {
namespace {

double cpu_ms() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

double wall_ms() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now).count();
}

template <class Side>
void time_frame(Side* side, Times* times) {
  const double cpu = cpu_ms(), wall = wall_ms();
  side->draw();
  times->wall_ms.push_back(wall_ms() - wall);
  times->cpu_ms.push_back(cpu_ms() - cpu);
}

double difference(uint64_t a, uint64_t b) {
  return std::abs(static_cast<double>(a) - static_cast<double>(b));
}

}  // namespace

bool Row::agrees() const {
  const double tolerated = kToleratedShare * static_cast<double>(of_llvmpipe.covered);
  return difference(of_llvmpipe.covered, of_pineda.covered) <= tolerated &&
         difference(of_llvmpipe.passed, of_pineda.passed) <= tolerated;
}

double Row::ratio() const { return median(llvmpipe.cpu_ms) / median(pineda.cpu_ms); }

std::vector<double> Row::ratios() const {
  std::vector<double> ratios;
  for (size_t i = 0; i < pineda.cpu_ms.size(); ++i) {
    ratios.push_back(llvmpipe.cpu_ms[i] / pineda.cpu_ms[i]);
  }
  return ratios;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

Row compare(const std::string& name, const std::vector<scene::ScreenTriangle>& triangles,
            int rounds, Llvmpipe* llvmpipe, Pineda* pineda) {
  Row row;
  row.scene = name;
  row.triangles = triangles.size();
  llvmpipe->load(triangles);
  pineda->load(triangles);
  row.of_llvmpipe = llvmpipe->count();
  row.of_pineda = pineda->count();
  if (!row.agrees()) return row;
  llvmpipe->draw();  // compiles its shaders anew, since nothing is counted
  pineda->draw();
  for (int round = 0; round < rounds; ++round) {
    if (round % 2 == 0) time_frame(pineda, &row.pineda);
    time_frame(llvmpipe, &row.llvmpipe);
    if (round % 2 == 1) time_frame(pineda, &row.pineda);
  }
  return row;
}

}  // namespace pineda::bench
