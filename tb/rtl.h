// A design's plug-in, and one Verilated unit of it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string>

#include "model/spec/pack.h"
#include "model/timing/counted/cycles.h"
#include "tb/plugin.h"

namespace pineda::tb {

/// The RTL cannot be had or broke its own rules: a missing or stale plug-in, a failed assertion, a
/// broken handshake, a deadlock. One line.
class RtlError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The plug-in is missing, or stale, or not one.
class PluginError : public RtlError {
 public:
  using RtlError::RtlError;
};

/// The loaded plug-in of a design: that of the build, or else one from the cache, which is built
/// there the first time (see plugin_cache.h). Throws PluginError if it cannot be had, or was built
/// from another package.
class RtlLibrary {
 public:
  explicit RtlLibrary(const spec::Contract& contract,
                      const std::function<void(const std::string&)>& say = {});
  /// The same from a given file.
  RtlLibrary(const spec::Contract& contract, const std::string& file);
  ~RtlLibrary();
  RtlLibrary(const RtlLibrary&) = delete;
  RtlLibrary& operator=(const RtlLibrary&) = delete;

  const spec::Contract& contract() const { return contract_; }
  const PinedaRtlPlugin& plugin() const { return *plugin_; }

 private:
  void load(const std::string& file);

  spec::Contract contract_;
  void* handle_ = nullptr;
  const PinedaRtlPlugin* plugin_ = nullptr;
};

/// Storage of a port, one bit to 64 bits or packed words.
struct PortData {
  void* data = nullptr;
  uint32_t bytes = 0;

  bool bit() const { return *static_cast<const uint8_t*>(data) != 0; }
  /// Of a port of at most 32 bits.
  uint32_t word() const {
    uint32_t value = 0;
    std::memcpy(&value, data, std::min<size_t>(bytes, sizeof value));  // little-endian
    return value;
  }
  void set_bit(bool value) const { *static_cast<uint8_t*>(data) = value ? 1 : 0; }
};

/// One Verilated unit: setup, traversal, interp_ztest, top or loopback.
class RtlUnit {
 public:
  RtlUnit(const RtlLibrary& library, const std::string& unit);
  ~RtlUnit();
  RtlUnit(const RtlUnit&) = delete;
  RtlUnit& operator=(const RtlUnit&) = delete;

  const spec::Contract& contract() const { return contract_; }
  const std::string& name() const { return name_; }
  PortData port(const std::string& name) const;

  /// Holds reset for two clock edges; cycle() starts again at 0.
  void reset();
  /// Inputs take effect on outputs that depend on them in the same cycle.
  void settle() { plugin_.settle(rtl_); }
  /// The clock edge that ends the cycle. Throws RtlError when an assertion failed in it.
  void clock();
  /// Clock edges since reset: the number of the cycle under way.
  timing::Cycle cycle() const { return cycle_; }
  /// FST waveform from now on; false if the file cannot be written.
  bool trace(const std::string& file) { return plugin_.trace(rtl_, file.c_str()) != 0; }
  /// Verilator's coverage so far; false if the plug-in does not count it. The file can be written.
  bool write_coverage(const std::string& file) const {
    return plugin_.write_coverage(rtl_, file.c_str()) != 0;
  }

 private:
  const spec::Contract& contract_;
  const PinedaRtlPlugin& plugin_;
  std::string name_;
  PinedaRtl* rtl_;
  timing::Cycle cycle_ = 0;
};

}  // namespace pineda::tb
