// The last write of a frame, found without testing the depths of all stamps.
#pragma once

#include <vector>

#include "model/fast/tile_shader.h"
#include "model/timing/counted/cycles.h"

namespace pineda::timing {

/// Finds when the last write of a frame is, where memories are always ready. The outcome of a depth
/// test then decides about one thing in time alone: whether its stamp writes, and so which write is
/// the last one and ends the frame. So stamps are only noted here. At the end they are tested, tile
/// by tile from the last stamp backwards, until one is found that has a sample that passes.
///
/// Bits     fast::TileShader.
/// In       triangle(), then run() for its tiles. When there are too many to keep, those noted so
///          far are tested.
/// Out      find(): the cycle in which the last stamp with a passing sample retires; -1 if there is
///          none.
class LastWrite {
 public:
  explicit LastWrite(const spec::Contract& contract) : contract_(contract) {}

  /// The buffer's depths are cleared where they are needed.
  void begin_frame(const spec::FrameState& frame, fast::TiledBuffer* buffer);
  /// A triangle that setup sends. It must be there until its last run().
  void triangle(const spec::Triangle& triangle);
  /// A tile of the last triangle. The k-th stamp, from 0, retires in `retire` + k.
  void run(int tile_x, int tile_y, Cycle retire);
  /// A tile of the last triangle, whose stamps retire in other cycles: retires() is called for each
  /// of its stamps.
  void run(int tile_x, int tile_y);
  void retires(Cycle cycle) { irregular_.push_back(cycle); }

  Cycle find();

 private:
  static constexpr uint32_t kNone = UINT32_MAX;
  static constexpr size_t kKept = size_t{1} << 20;  // runs, some 32 bytes each

  struct Corner {
    explicit Corner(const spec::Vertex& v) : x(v.x), y(v.y), z(v.z) {}
    int32_t x, y;
    int64_t z;
  };
  struct Run {
    uint32_t triangle;  // index into triangles_
    uint32_t tile;
    uint32_t before;     // the run before it in this tile, kNone
    uint32_t irregular;  // index into irregular_, kNone: regular
    // Of its first stamp; after test(): of the last stamp that passes, -1 if none does
    Cycle retire;
  };
  void add(int tile_x, int tile_y, uint32_t irregular, Cycle retire);
  void test_tile(uint32_t last_run);
  void test(Run* run);
  void flush();
  void clear(uint32_t tile);

  spec::Contract contract_;
  spec::FrameState frame_;
  fast::TiledBuffer* buffer_ = nullptr;
  int tile_columns_ = 0;
  const spec::Triangle* triangle_ = nullptr;      // the last one, as long as it has no run
  std::vector<std::array<Corner, 3>> triangles_;  // that have a run
  std::vector<Run> runs_;
  std::vector<Cycle> irregular_;
  std::vector<uint32_t> last_;  // by tile: its last run that is not tested
  std::vector<bool> cleared_;   // by tile: its depths in the buffer are this frame's
  Cycle found_ = -1;            // among the runs that are not kept
};

}  // namespace pineda::timing
