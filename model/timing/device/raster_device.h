// The rasterizer as a device of a platform: registers, an interrupt, triangles from memory.
#pragma once

#include <tlm_utils/simple_target_socket.h>

#include <array>
#include <deque>
#include <systemc>
#include <tlm>
#include <vector>

#include "model/timing/device/registers.h"
#include "model/timing/device/triangle_fetch.h"
#include "model/timing/raster_top.h"

namespace pineda::timing {

/// A RasterTop behind registers. A start takes the registers as they are and puts a frame into the
/// queue; frames are drawn one after the other.
///
/// Bits     core::Renderer defines every write.
/// In       registers: 32-bit accesses at the offsets of kRegisters, see docs/device.md. The delay
///          of an access passes before it has its effect.
/// Out      triangle_socket: see TriangleFetch; depth_socket, color_socket: see MemorySocket. The
///          interrupt is high while a bit is pending that is enabled. Memories are cleared by the
///          platform before a start.
/// Rate     the cycles of RasterTop, where a triangle is offered once it has arrived.
/// Drops    a reset drops all frames: the one being drawn ends at its next transaction, and what it
///          has written stays.
/// Errors   responses, with nothing done: TLM_ADDRESS_ERROR_RESPONSE where no register is,
///          TLM_BURST_ERROR_RESPONSE of another length than 4, TLM_BYTE_ENABLE_ERROR_RESPONSE of a
///          part of a word, TLM_COMMAND_ERROR_RESPONSE of a write to what is read alone and the
///          other way round, TLM_GENERIC_ERROR_RESPONSE of a start while the queue is full or of a
///          state that does not exist, and of more triangle_data than there is room for. A frame
///          in which an error is reported has failed: status and interrupt say so, and the next
///          one is drawn.
class RasterDevice final : public sc_core::sc_module {
 public:
  static constexpr size_t kQueueFrames = 4;       // with the one being drawn
  static constexpr size_t kPushedTriangles = 64;  // of a frame, through triangle_data

  tlm_utils::simple_target_socket<RasterDevice> registers{"registers"};
  sc_core::sc_out<bool> interrupt{"interrupt"};

  RasterDevice(sc_core::sc_module_name name, const spec::Contract& contract,
               const sc_core::sc_time& period = {1, sc_core::SC_NS});

  auto& triangle_socket() { return fetch_.socket; }
  auto& depth_socket() { return top_.depth_socket(); }
  auto& color_socket() { return top_.color_socket(); }

 private:
  struct Frame {
    spec::FrameState state;
    uint64_t depth_base, color_base, triangle_base;
    uint32_t count;
    bool is_pushed;
    std::vector<spec::Triangle> pushed;
    uint64_t reset;  // number of resets before it
  };

  void b_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  unsigned transport_dbg(tlm::tlm_generic_payload& payload);
  tlm::tlm_response_status write(const RegisterRow& row, uint32_t written);
  uint32_t read(const RegisterRow& row) const;
  tlm::tlm_response_status control(uint32_t bits);
  tlm::tlm_response_status push(uint32_t word);
  bool start(bool pushed);
  void reset();
  void reset_registers();

  void draw_frames();
  bool draw(const Frame& frame, Cycle* cycles);
  bool next(const Frame& frame, size_t number, spec::Triangle* triangle);
  void drive_interrupt();

  uint32_t& value(Register reg) { return values_[static_cast<size_t>(reg)]; }
  uint32_t value(Register reg) const { return values_[static_cast<size_t>(reg)]; }
  uint64_t both(Register low) const;
  bool read_state(spec::FrameState* state) const;

  sc_core::sc_time period_;
  int64_t bias_limit_;  // a constant is nearer to 0
  RasterTop top_;
  TriangleFetch fetch_;
  std::array<uint32_t, kRegisterCount> values_{};
  spec::Packed words_;  // of the triangle that is being pushed
  std::vector<spec::Triangle> pushed_;
  std::deque<Frame> queue_;
  bool drawing_ = false;
  bool has_failed_ = false;
  uint64_t resets_ = 0;
  Cycle arrived_ = 0;  // of the triangle that is next, in cycles of the frame
  sc_core::sc_event started_, interrupts_changed_;
};

}  // namespace pineda::timing
