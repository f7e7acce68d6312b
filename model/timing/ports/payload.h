// What TLM-2.0 targets do with a generic payload.
#pragma once

#include <algorithm>
#include <cstring>
#include <tlm>
#include <vector>

namespace pineda::timing {

/// Moves the payload's enabled bytes from or to a memory.
inline void move_bytes(const tlm::tlm_generic_payload& payload, unsigned char* memory_bytes) {
  unsigned char* const data = payload.get_data_ptr();
  const unsigned length = payload.get_data_length();
  const unsigned char* const enables = payload.get_byte_enable_ptr();
  const unsigned period = payload.get_byte_enable_length();
  for (unsigned i = 0; i < length; ++i) {
    if (enables != nullptr && enables[i % period] != TLM_BYTE_ENABLED) continue;
    if (payload.is_read()) data[i] = memory_bytes[i];
    if (payload.is_write()) memory_bytes[i] = data[i];
  }
}

/// What a memory of `bytes` bytes has against a read or a write; TLM_OK_RESPONSE if nothing.
inline tlm::tlm_response_status checked_range(const tlm::tlm_generic_payload& payload,
                                              uint64_t bytes) {
  const uint64_t length = payload.get_data_length();
  if (length == 0 || payload.get_address() >= bytes || length > bytes - payload.get_address()) {
    return tlm::TLM_ADDRESS_ERROR_RESPONSE;
  }
  if (payload.get_streaming_width() < length) return tlm::TLM_BURST_ERROR_RESPONSE;
  const bool enables = payload.get_byte_enable_ptr() != nullptr;
  if (enables && payload.get_byte_enable_length() == 0) return tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE;
  return tlm::TLM_OK_RESPONSE;
}

/// Debug transport from or to a memory: the bytes that were moved, up to its end.
inline unsigned debug_bytes(const tlm::tlm_generic_payload& payload,
                            std::vector<unsigned char>* memory_bytes) {
  const uint64_t address = payload.get_address();
  if (address >= memory_bytes->size()) return 0;
  const auto length = static_cast<unsigned>(
      std::min<uint64_t>(payload.get_data_length(), memory_bytes->size() - address));
  unsigned char* const at = memory_bytes->data() + address;
  if (payload.is_read()) std::memcpy(payload.get_data_ptr(), at, length);
  if (payload.is_write()) std::memcpy(at, payload.get_data_ptr(), length);
  return payload.is_read() || payload.is_write() ? length : 0;
}

}  // namespace pineda::timing
