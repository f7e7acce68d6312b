// A frame's time as a waveform of what the units do.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "studies/seeing/spans.h"
#include "studies/seeing/waveform.h"

namespace pineda::studies {

/// Signals of a frame, a nanosecond a cycle:
///   pineda.UNIT.state, .triangle   a cause's name (text); 32 bits, x between two triangles
///   pineda.fifos.NAME              16 bits: the level as the cycle begins
///   pineda.memory.PORT             1 bit: the port moves in this cycle
///
/// In       spent(), slot(), depth(), color().
/// Out      write(): a waveform of signals(), to a VCD or FST file.
///
/// Memory: 16 bytes for every change inside the window, twice that while vectors grow or are
/// sorted. Each unit reports its own changes in order, but a file needs one order for all.
class StateTrace final : public timing::Listener {
 public:
  /// `reads_depth`: a stamp's depth is read in the cycle in which the stamp leaves its FIFO.
  StateTrace(const Window& window, bool reads_depth);

  void spent(timing::Unit unit, timing::Cause cause, timing::Cycle from, timing::Cycle until,
             uint32_t id) override;
  void slot(timing::Fifo fifo, timing::Cycle inserted, timing::Cycle freed) override;
  void depth(timing::Cycle cycle, const spec::DepthWrite& write) override;
  void color(timing::Cycle cycle, const spec::ColorWrite& write) override;

  /// After the frame, before it is written; `drained`: where the waveform ends.
  void finish(timing::Cycle drained);
  size_t changes() const { return changes_.size(); }
  /// After finish().
  void write(Waveform* waveform) const;

  static std::vector<Signal> signals();

 private:
  struct Value {
    uint32_t number = 0;
    bool known = true;
  };
  struct Change {
    timing::Cycle cycle;
    uint32_t number;
    uint8_t signal;
    bool known;
  };
  struct UnitState {
    SpanJoiner spans;
    timing::Cycle until = 0;  // end of the last span: the unit is starved from then on
    uint32_t id = 0;
  };
  static constexpr size_t kLevels = 2 * timing::kUnits;  // signal of the first FIFO
  static constexpr size_t kPorts = kLevels + timing::kFifos;
  static constexpr size_t kSignals = kPorts + timing::kMemoryPorts;

  void add(timing::Unit unit, const Span& span);
  void starve(timing::Unit unit, bool within_triangle);
  void move(timing::MemoryPort port, timing::Cycle cycle);
  void change(size_t signal, timing::Cycle cycle, Value value);

  Window window_;
  bool reads_depth_;
  std::array<UnitState, timing::kUnits> units_;
  std::array<FifoLevel, timing::kFifos> levels_;
  std::array<timing::Cycle, timing::kMemoryPorts> moved_;  // the last cycle in which a port moved
  std::array<Value, kSignals> first_{};                    // as the window begins
  std::array<Value, kSignals> last_{};
  std::vector<Change> changes_;
};

/// A GTKWave save file: all signals of a StateTrace arranged. `file`: the waveform's name beside
/// it.
std::string gtkwave_save(const std::string& file);

}  // namespace pineda::studies
