// The two ends of a ready/valid stream at a Verilated unit.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "tb/rtl.h"

namespace pineda::tb {

/// A bench that sees no handshake for so long gives up. Nothing waits that long: stalls last
/// hundreds of cycles, a screen of rejected tiles a few million.
inline constexpr timing::Cycle kDeadlockCycles = 8'000'000;

/// The same for a frame whose size is known: a walk over all its samples, most cycles stalled.
inline timing::Cycle deadlock_cycles(const spec::FrameState& frame) {
  constexpr timing::Cycle kStalls = 100'000, kSample = 16;
  return std::min(kDeadlockCycles, kStalls + kSample * frame.width * frame.height);
}

/// Moves packed structs between port storage and C++; storage of up to 64 bits is 1, 2, 4 or 8
/// bytes wide, so the words go through a buffer.
template <class T>
class PayloadPort {
 public:
  PayloadPort(const RtlUnit& unit, const std::string& name)
      : port_(unit.port(name)),
        packer_(unit.contract()),
        words_(static_cast<size_t>(packer_.words()) + 1) {
    if (port_.bytes * 8 < static_cast<uint32_t>(packer_.bits())) {
      throw RtlError(fmt::format("{}: port '{}' is too narrow", unit.name(), name));
    }
  }

  void set(const T& value) {
    packer_.pack(value, words_.data());
    std::memcpy(port_.data, words_.data(), port_.bytes);
  }
  /// The same from words that hold the packed struct.
  void set_packed(const uint32_t* words) { std::memcpy(port_.data, words, port_.bytes); }
  T get() {
    std::memcpy(words_.data(), port_.data, port_.bytes);
    return packer_.unpack(words_.data());
  }
  const spec::Packer<T>& packer() const { return packer_; }
  /// The packed struct where it lies; only for structs of more than 32 bits, which lie in words.
  uint32_t* words() const { return static_cast<uint32_t*>(port_.data); }
  /// The raw bytes, to see whether a payload changed.
  bool copy_if_changed(std::vector<uint8_t>* last) const {
    const auto* bytes = static_cast<const uint8_t*>(port_.data);
    if (last->size() == port_.bytes && std::equal(last->begin(), last->end(), bytes)) return false;
    last->assign(bytes, bytes + port_.bytes);
    return true;
  }

 private:
  PortData port_;
  spec::Packer<T> packer_;
  std::vector<uint32_t> words_;  // one more than the struct needs: 64-bit storage of 32 bits
};

/// Feeds tokens to NAME_valid_i, NAME_ready_o, NAME_i. Once offered, a token stays.
template <class T>
class SourceEnd {
 public:
  SourceEnd(const RtlUnit& unit, const std::string& name)
      : valid_(unit.port(name + "_valid_i")),
        ready_(unit.port(name + "_ready_o")),
        payload_(unit, name + "_i") {
    valid_.set_bit(false);
  }

  bool offered() const { return valid_.bit(); }
  void offer(const T& token) {
    payload_.set(token);
    valid_.set_bit(true);
  }
  /// After settle: does the unit take the token in this cycle? If so, call withdraw() after the
  /// clock edge.
  bool taken() const { return valid_.bit() && ready_.bit(); }
  void withdraw() { valid_.set_bit(false); }

 private:
  PortData valid_;
  PortData ready_;
  PayloadPort<T> payload_;
};

/// Takes tokens from NAME_valid_o, NAME_ready_i, NAME_o and checks the protocol: a token that is
/// offered stays, unchanged, until it is taken.
template <class T>
class SinkEnd {
 public:
  SinkEnd(const RtlUnit& unit, const std::string& name)
      : unit_(unit),
        name_(name),
        valid_(unit.port(name + "_valid_o")),
        ready_(unit.port(name + "_ready_i")),
        payload_(unit, name + "_o") {
    ready_.set_bit(false);
  }

  void set_ready(bool ready) { ready_.set_bit(ready); }
  /// After settle: is a token taken in this cycle?
  bool taken() {
    const bool valid = valid_.bit();
    if (waiting_ && (!valid || payload_.copy_if_changed(&last_))) {
      throw RtlError(fmt::format("{}: {} is not stable while it waits, cycle {}", unit_.name(),
                                 name_, unit_.cycle()));
    }
    const bool ready = ready_.bit();
    if (valid && !ready && !waiting_) payload_.copy_if_changed(&last_);
    waiting_ = valid && !ready;
    return valid && ready;
  }
  T value() { return payload_.get(); }
  const PayloadPort<T>& payload() const { return payload_; }
  bool offered() const { return valid_.bit(); }
  void forget() { waiting_ = false; }

 private:
  const RtlUnit& unit_;
  std::string name_;
  PortData valid_;
  PortData ready_;
  PayloadPort<T> payload_;
  bool waiting_ = false;
  std::vector<uint8_t> last_;
};

/// Watches a stream inside the top: NAME_valid, NAME_ready, NAME.
template <class T>
class Tap {
 public:
  Tap(const RtlUnit& unit, const std::string& name)
      : valid_(unit.port(name + "_valid")),
        ready_(unit.port(name + "_ready")),
        payload_(unit, name) {}
  bool taken() const { return valid_.bit() && ready_.bit(); }
  T value() { return payload_.get(); }

 private:
  PortData valid_;
  PortData ready_;
  PayloadPort<T> payload_;
};

}  // namespace pineda::tb
