// Reader of .tri: triangles after the viewport transform, as text.
#pragma once

#include <array>

#include "model/scene/readers/lines.h"
#include "model/scene/screen.h"

namespace pineda::scene {

/// Reads triangle by triangle, so that memory does not grow with the file.
///
/// In       the format "pineda-tri 1". A line ends with LF; a CR is a blank. '#' begins a comment,
///          also after values and before the first line.
/// Errors   InputError with the line: in the constructor for the state lines, in read() for the
///          vertices.
class TriReader final : public ScreenReader {
 public:
  TriReader(const spec::Contract& contract, const std::string& file,
            std::unique_ptr<std::istream> stream);

  const spec::FrameState& frame() const { return frame_; }
  /// True if the slope factor of the depth bias was no multiple of 2^-8 and was rounded.
  bool rounded_slope() const { return rounded_slope_; }
  bool read(ScreenTriangle* triangle, Counters* counters) override;
  void rewind() override;

 private:
  struct StateLine;
  static const std::array<StateLine, 8> kStateLines;
  static size_t find_state_line(const char* key);

  bool is_first_line() const;
  void read_state();
  void state_line();
  void read_size();
  void read_scissor();
  void read_bias();
  void read_clear_depth();
  template <class T, T spec::FrameState::*Member>
  void read_word();
  ScreenVertex vertex(Counters* counters) const;

  spec::Design design_;
  LineReader lines_;
  spec::FrameState frame_;
  bool rounded_slope_ = false;
  std::array<bool, 8> seen_{};  // which of kStateLines occurred
  bool at_vertex_ = false;      // the current line is a vertex that was not used yet
  uint64_t next_ = 0;           // number of the next triangle
};

}  // namespace pineda::scene
