// Reader of .tri: triangles after the viewport transform, as text.
#pragma once

#include "model/scene/lines.h"
#include "model/scene/screen.h"

namespace pineda::scene {

/// Reads triangle by triangle, so that memory does not grow with the file.
///
/// In       the format "pineda-tri 1". CR LF line ends are taken like LF.
/// Errors   InputError with the line: in the constructor for the state lines, in read() for the
///          vertices. State lines that this version does not know how to draw are refused.
class TriReader final : public ScreenReader {
 public:
  TriReader(const spec::Contract& contract, const std::string& file,
            std::unique_ptr<std::istream> stream);

  const spec::FrameState& frame() const { return frame_; }
  bool read(ScreenTriangle* triangle, Counters* counters) override;
  void rewind() override;

 private:
  void read_state();
  void state_line();
  ScreenVertex vertex(Counters* counters) const;

  int greatest_size_px_;
  LineReader lines_;
  spec::FrameState frame_;
  bool has_size_ = false, has_cull_ = false, has_depth_ = false;
  bool at_vertex_ = false;  // lines_ stands on a vertex that was not taken yet
  uint64_t next_ = 0;       // number of the next triangle
};

}  // namespace pineda::scene
