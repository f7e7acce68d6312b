// Fetches a frame's triangles from memory, ahead of their use.
#pragma once

#include <tlm_utils/simple_initiator_socket.h>

#include <deque>
#include <systemc>
#include <tlm>
#include <vector>

#include "model/spec/pack.h"
#include "model/spec/structs.h"

namespace pineda::timing {

/// A process that reads one triangle after the other, as far ahead as there is room.
///
/// Bits     the words of spec::Packer, little-endian, one triangle behind the other.
/// Out      blocking transport, a burst a triangle; no further ahead of simulated time than the
///          global quantum.
/// Rate     one transaction at a time, kRoom triangles ahead.
/// Errors   a response that is not TLM_OK_RESPONSE: SC_REPORT_WARNING "pineda/device/fetch"; the
///          stream ends there, and failed() is true.
class TriangleFetch final : public sc_core::sc_module {
 public:
  static constexpr size_t kRoom = 8;
  struct Fetched {
    spec::Triangle triangle;
    sc_core::sc_time arrived;
  };

  tlm_utils::simple_initiator_socket<TriangleFetch> socket{"socket"};

  TriangleFetch(sc_core::sc_module_name name, const spec::Contract& contract);

  void begin(uint64_t address, uint32_t count);
  /// What is under way is dropped.
  void stop() { begin(0, 0); }
  bool failed() const { return failed_; }
  /// No triangle will come any more.
  bool at_end() const { return fetched_.empty() && next_ == count_; }
  bool empty() const { return fetched_.empty(); }
  /// The next one. Not if empty().
  Fetched take();
  /// Something came, or the end.
  const sc_core::sc_event& changed() const { return changed_; }
  const spec::Packer<spec::Triangle>& packer() const { return packer_; }

 private:
  void run();
  void fetch();
  bool read(uint64_t address);

  spec::Packer<spec::Triangle> packer_;
  std::vector<unsigned char> bytes_;
  tlm::tlm_generic_payload payload_;
  sc_core::sc_time local_;  // when the last transaction was over
  uint64_t address_ = 0;
  uint32_t next_ = 0, count_ = 0;
  uint64_t frame_ = 0;  // counts begin()
  bool failed_ = false;
  std::deque<Fetched> fetched_;
  sc_core::sc_event begun_, room_, changed_;
};

}  // namespace pineda::timing
