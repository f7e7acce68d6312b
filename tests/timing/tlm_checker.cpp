#include "tests/timing/tlm_checker.h"

#include <algorithm>

namespace pineda::test {

using tlm::tlm_generic_payload;

TlmChecker::TlmChecker(sc_core::sc_module_name name) : sc_module(name) {
  in.register_b_transport(this, &TlmChecker::b_transport);
  in.register_transport_dbg(this, &TlmChecker::transport_dbg);
  in.register_get_direct_mem_ptr(this, &TlmChecker::get_direct_mem_ptr);
  out.register_invalidate_direct_mem_ptr(this, &TlmChecker::invalidate);
}

TlmChecker::Attributes::Attributes(const tlm_generic_payload& payload)
    : command(payload.get_command()),
      address(payload.get_address()),
      data(payload.get_data_ptr()),
      length(payload.get_data_length()),
      streaming_width(payload.get_streaming_width()),
      enables(payload.get_byte_enable_ptr()),
      enable_length(payload.get_byte_enable_length()) {
  if (data != nullptr) bytes.assign(data, data + length);
  if (enables != nullptr) enable_bytes.assign(enables, enables + enable_length);
  for (unsigned i = 0; i < tlm::max_num_extensions(); ++i) {
    extensions.push_back(payload.get_extension(i));
  }
}

void TlmChecker::require(bool rule, const char* text) {
  if (rule || std::find(faults_.begin(), faults_.end(), text) != faults_.end()) return;
  faults_.emplace_back(text);
}

void TlmChecker::check_call(const tlm_generic_payload& payload) {
  const auto command = payload.get_command();
  require(payload.is_read() || payload.is_write() || command == tlm::TLM_IGNORE_COMMAND,
          "call: no such command");
  require(payload.get_data_ptr() != nullptr, "call: no data pointer");
  require(payload.get_data_length() > 0, "call: no data length");
  require(payload.get_streaming_width() > 0, "call: no streaming width");
  require(payload.get_byte_enable_ptr() == nullptr || payload.get_byte_enable_length() > 0,
          "call: byte enables without a length");
  require(payload.get_response_status() == tlm::TLM_INCOMPLETE_RESPONSE,
          "call: response is not TLM_INCOMPLETE_RESPONSE");
  require(!payload.is_dmi_allowed(), "call: DMI hint is set");
}

void TlmChecker::check_left_alone(const Attributes& before, const tlm_generic_payload& payload) {
  const Attributes after(payload);
  require(after.command == before.command, "return: command has changed");
  require(after.address == before.address, "return: address has changed");
  require(after.data == before.data, "return: data pointer has changed");
  require(after.length == before.length, "return: data length has changed");
  require(after.streaming_width == before.streaming_width, "return: streaming width has changed");
  require(after.enables == before.enables && after.enable_length == before.enable_length &&
              after.enable_bytes == before.enable_bytes,
          "return: byte enables have changed");
  require(after.extensions == before.extensions, "return: extensions have changed");
}

// Only a read moves bytes to the initiator, and only enabled ones.
void TlmChecker::check_bytes(const Attributes& before, const tlm_generic_payload& payload) {
  if (before.data == nullptr || payload.is_response_error()) return;
  for (size_t i = 0; i < before.bytes.size(); ++i) {
    const bool may_change =
        before.command == tlm::TLM_READ_COMMAND &&
        (before.enable_bytes.empty() || before.enable_bytes[i % before.enable_bytes.size()] != 0);
    require(may_change || before.data[i] == before.bytes[i], "return: data have changed");
  }
}

void TlmChecker::pass_on(tlm_generic_payload* payload, sc_core::sc_time* delay) {
  std::vector<tlm::tlm_extension_base*> kept(tlm::max_num_extensions());
  for (unsigned i = 0; strips_ && i < kept.size(); ++i)
    kept[i] = payload->set_extension(i, nullptr);
  out->b_transport(*payload, *delay);
  for (unsigned i = 0; strips_ && i < kept.size(); ++i) payload->set_extension(i, kept[i]);
}

void TlmChecker::b_transport(tlm_generic_payload& payload, sc_core::sc_time& delay) {
  ++transactions_;
  check_call(payload);
  const Attributes before(payload);
  const sc_core::sc_time arrived = sc_core::sc_time_stamp() + delay;
  pass_on(&payload, &delay);
  require(sc_core::sc_time_stamp() + delay >= arrived, "return: time went back");
  require(payload.get_response_status() != tlm::TLM_INCOMPLETE_RESPONSE,
          "return: response is TLM_INCOMPLETE_RESPONSE");
  check_left_alone(before, payload);
  check_bytes(before, payload);
}

unsigned TlmChecker::transport_dbg(tlm_generic_payload& payload) {
  require(payload.is_read() || payload.is_write(), "debug call: no command");
  require(payload.get_data_ptr() != nullptr, "debug call: no data pointer");
  const Attributes before(payload);
  const sc_core::sc_time now = sc_core::sc_time_stamp();
  const unsigned moved = out->transport_dbg(payload);
  require(moved <= before.length, "debug return: more bytes than asked for");
  require(sc_core::sc_time_stamp() == now, "debug return: time has passed");
  const Attributes after(payload);
  require(after.command == before.command && after.address == before.address &&
              after.data == before.data && after.length == before.length,
          "debug return: attributes have changed");
  return moved;
}

bool TlmChecker::get_direct_mem_ptr(tlm_generic_payload& payload, tlm::tlm_dmi& dmi) {
  require(payload.is_read() || payload.is_write(), "DMI call: no command");
  const Attributes before(payload);
  const bool granted = out->get_direct_mem_ptr(payload, dmi);
  check_left_alone(before, payload);
  require(dmi.get_start_address() <= dmi.get_end_address(), "DMI return: no range");
  require(before.address >= dmi.get_start_address() && before.address <= dmi.get_end_address(),
          "DMI return: the address is not in the range");
  require(!granted || dmi.get_dmi_ptr() != nullptr, "DMI return: granted without a pointer");
  const bool allowed =
      before.command == tlm::TLM_READ_COMMAND ? dmi.is_read_allowed() : dmi.is_write_allowed();
  require(!granted || allowed, "DMI return: granted, but not what was asked for");
  return granted;
}

void TlmChecker::invalidate(sc_dt::uint64 start, sc_dt::uint64 end) {
  require(start <= end, "DMI invalidated: no range");
  in->invalidate_direct_mem_ptr(start, end);
}

}  // namespace pineda::test
