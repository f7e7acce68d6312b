#include "tests/timing/clocked.h"

#include <algorithm>
#include <stdexcept>

namespace pineda::test {

namespace {

constexpr size_t kLanes = static_cast<size_t>(kContract.width.lanes);

}  // namespace

ClockedRasterizer::ClockedRasterizer(const tb::RtlLibrary& library, const Scene& scene,
                                     const Traffic& traffic)
    : unit_(library, "top"),
      scene_(scene),
      traffic_(traffic),
      columns_(((scene.frame.width - 1) >> kContract.design.stamp_width_log2) + 1),
      frames_(unit_, "frame"),
      triangles_(unit_, "tri"),
      end_valid_(unit_.port("end_valid_i")),
      end_ready_(unit_.port("end_ready_o")),
      clear_valid_(unit_.port("clear_valid_o")),
      clear_ready_(unit_.port("clear_ready_i")),
      clear_depth_(unit_.port("clear_depth_o")),
      reads_(unit_, "depth_rd"),
      depth_writes_(unit_, "depth_wr"),
      color_writes_(unit_, "color_wr"),
      response_valid_(unit_.port("depth_rsp_valid_i")),
      response_ready_(unit_.port("depth_rsp_ready_o")),
      response_(unit_, "depth_rsp_i") {
  const int rows = ((scene.frame.height - 1) >> kContract.design.stamp_height_log2) + 1;
  depths_.resize(static_cast<size_t>(columns_) * static_cast<size_t>(rows) * kLanes);
  end_valid_.set_bit(false);
  response_valid_.set_bit(false);
  clear_ready_.set_bit(true);
  unit_.reset();
  frames_.offer(scene.frame);
}

std::vector<uint32_t>::iterator ClockedRasterizer::stamp(int x, int y) {
  return depths_.begin() + (y * columns_ + x) * static_cast<int>(kLanes);
}

void ClockedRasterizer::drive_triangles(Cycle cycle) {
  const bool more = next_ < scene_.triangles.size();
  if (more && !triangles_.offered() && traffic_.triangle_ready(cycle)) {
    triangles_.offer(scene_.triangles[next_++]);
  }
  if (!more && !triangles_.offered()) end_valid_.set_bit(true);
}

void ClockedRasterizer::drive_memory(Cycle cycle) {
  reads_.set_ready(true);
  depth_writes_.set_ready(depth_done_ != kIdle && depth_done_ <= cycle);
  color_writes_.set_ready(color_done_ != kIdle && color_done_ <= cycle);
  const bool due = answered_ < due_.size() && due_[answered_].cycle <= cycle;
  response_valid_.set_bit(due);
  if (due) response_.set(due_[answered_].data);
}

int ClockedRasterizer::offer(Cycle cycle) {
  drive_triangles(cycle);
  drive_memory(cycle);
  unit_.settle();
  fresh_.clear();
  if (reads_.offered()) fresh_.push_back(kRead);
  if (depth_writes_.offered() && depth_done_ == kIdle) fresh_.push_back(kDepthWrite);
  if (color_writes_.offered() && color_done_ == kIdle) fresh_.push_back(kColorWrite);
  return static_cast<int>(fresh_.size());
}

void ClockedRasterizer::served(int i, Cycle done) {
  switch (fresh_[static_cast<size_t>(i)]) {
    case kRead: {
      last_response_ = std::max(done, last_response_ + 1);
      const spec::DepthRead read = reads_.value();
      Response response{last_response_, {}};
      for (size_t lane = 0; lane < kLanes; ++lane) {
        if (read.mask >> lane & 1) response.data.z[lane] = *(stamp(read.x, read.y) + lane);
      }
      due_.push_back(response);
      break;
    }
    case kDepthWrite:
      depth_done_ = done;
      break;
    case kColorWrite:
      color_done_ = done;
      break;
  }
}

void ClockedRasterizer::clock(Cycle cycle) {
  if (clear_valid_.bit()) std::fill(depths_.begin(), depths_.end(), clear_depth_.word());
  if (response_valid_.bit() && response_ready_.bit()) ++answered_;
  const bool frame = frames_.taken();
  const bool triangle = triangles_.taken();
  reads_.taken();
  if (depth_writes_.taken()) {
    const spec::DepthWrite write = depth_writes_.value();
    for (size_t lane = 0; lane < kLanes; ++lane) {
      if (write.mask >> lane & 1) *(stamp(write.x, write.y) + lane) = write.z[lane];
    }
    depth_done_ = kIdle;
  }
  if (color_writes_.taken()) color_done_ = kIdle;
  if (end_valid_.bit() && end_ready_.bit() && drained_ < 0) drained_ = cycle;
  unit_.clock();
  if (frame) frames_.withdraw();
  if (triangle) triangles_.withdraw();
  if (drained_ >= 0) end_valid_.set_bit(false);
}

ClockedResult run_clocked(const tb::RtlLibrary& library, const std::vector<Scene>& scenes,
                          const Traffic& traffic) {
  constexpr Cycle kPatience = 5'000'000;
  std::vector<std::unique_ptr<ClockedRasterizer>> all;
  for (const Scene& scene : scenes) {
    all.push_back(std::make_unique<ClockedRasterizer>(library, scene, traffic));
  }
  ClockedResult result;
  Cycle free = 0;  // the channel is, from this cycle on
  std::vector<int> fresh(all.size());
  size_t left = all.size();
  for (Cycle cycle = 0; left > 0; ++cycle) {
    if (cycle > kPatience)
      throw std::runtime_error("the clocked rasterizers do not come to an end");
    for (size_t r = 0; r < all.size(); ++r) {
      fresh[r] = all[r]->drained() < 0 ? all[r]->offer(cycle) : 0;
    }
    for (int i = 0; i < 3; ++i) {
      for (size_t r = 0; r < all.size(); ++r) {
        if (i >= fresh[r]) continue;
        free = std::max(free, cycle) + traffic.channel_cycles;
        result.busy += traffic.channel_cycles;
        all[r]->served(i, free + traffic.latency_cycles);
      }
    }
    for (auto& rasterizer : all) {
      if (rasterizer->drained() >= 0) continue;
      rasterizer->clock(cycle);
      if (rasterizer->drained() >= 0) --left;
    }
  }
  for (const auto& rasterizer : all) result.drained.push_back(rasterizer->drained());
  return result;
}

}  // namespace pineda::test
