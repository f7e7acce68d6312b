// A module between two sockets that holds both sides to the rules of the TLM-2.0 base protocol.
#pragma once

#include <tlm_utils/passthrough_target_socket.h>
#include <tlm_utils/simple_initiator_socket.h>

#include <memory>
#include <string>
#include <systemc>
#include <tlm>
#include <vector>

namespace pineda::test {

/// Passes blocking transport, debug transport and direct access on, and notes what breaks a rule of
/// IEEE 1666-2011, clauses 11 and 14: of the initiator, before the call; of the target, after it.
class TlmChecker : public sc_core::sc_module {
 public:
  tlm_utils::passthrough_target_socket_optional<TlmChecker> in{"in"};
  tlm_utils::simple_initiator_socket_optional<TlmChecker> out{"out"};

  explicit TlmChecker(sc_core::sc_module_name name);

  /// Each broken rule in one line; what is broken many times comes once.
  const std::vector<std::string>& faults() const { return faults_; }
  int transactions() const { return transactions_; }
  /// Extensions do not reach the target, as behind an interconnect that does not know them.
  void strip_extensions() { strips_ = true; }

 private:
  /// What a target must leave as it is.
  struct Attributes {
    explicit Attributes(const tlm::tlm_generic_payload& payload);
    tlm::tlm_command command;
    sc_dt::uint64 address;
    unsigned char* data;
    unsigned length, streaming_width;
    unsigned char* enables;
    unsigned enable_length;
    std::vector<unsigned char> bytes, enable_bytes;
    std::vector<tlm::tlm_extension_base*> extensions;
  };
  void b_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  unsigned transport_dbg(tlm::tlm_generic_payload& payload);
  bool get_direct_mem_ptr(tlm::tlm_generic_payload& payload, tlm::tlm_dmi& dmi);
  void invalidate(sc_dt::uint64 start, sc_dt::uint64 end);
  void check_call(const tlm::tlm_generic_payload& payload);
  void check_left_alone(const Attributes& before, const tlm::tlm_generic_payload& payload);
  void check_bytes(const Attributes& before, const tlm::tlm_generic_payload& payload);
  void pass_on(tlm::tlm_generic_payload* payload, sc_core::sc_time* delay);
  void require(bool rule, const char* text);

  std::vector<std::string> faults_;
  int transactions_ = 0;
  bool strips_ = false;
};

/// Checkers between initiators and targets.
class Checkers {
 public:
  template <class Initiator, class Target>
  TlmChecker* between(Initiator* initiator, Target* target) {
    const std::string name = "checker" + std::to_string(all_.size());
    all_.push_back(std::make_unique<TlmChecker>(name.c_str()));
    initiator->bind(all_.back()->in);
    all_.back()->out.bind(*target);
    return all_.back().get();
  }
  /// All faults, one a line; what saw no transaction is one as well.
  std::string faults() const {
    std::string text;
    for (const auto& checker : all_) {
      for (const auto& fault : checker->faults())
        text += std::string(checker->name()) + ": " + fault + "\n";
      if (checker->transactions() == 0) text += std::string(checker->name()) + ": saw nothing\n";
    }
    return text;
  }

 private:
  std::vector<std::unique_ptr<TlmChecker>> all_;
};

}  // namespace pineda::test
