#include "tb/rtl.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include "model/spec/design_file.h"
#include "model/spec/package.h"
#include "tb/plugin_cache.h"

namespace pineda::tb {
namespace {

// The plug-in that was built with the program; empty where there is none of this design.
std::string built_plugin(const spec::Design& design) {
  const spec::Design* named = spec::find_design(design.name);
  // A design from a file may have taken the name of another.
  if (named == nullptr || spec::design_toml(*named) != spec::design_toml(design)) return {};
  return built_file(fmt::format("pineda_rtl_{}.so", design.name)).string();
}

std::string plugin_file(const spec::Contract& contract,
                        const std::function<void(const std::string&)>& say) {
  const std::string built = built_plugin(contract.design);
  return built.empty() ? cached_plugin(contract, say) : built;
}

}  // namespace

RtlLibrary::RtlLibrary(const spec::Contract& contract,
                       const std::function<void(const std::string&)>& say)
    : RtlLibrary(contract, plugin_file(contract, say)) {}

RtlLibrary::RtlLibrary(const spec::Contract& contract, const std::string& file)
    : contract_(contract) {
  load(file);
}

void RtlLibrary::load(const std::string& file) {
  handle_ = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle_ == nullptr) throw PluginError(dlerror());
  using Entry = const PinedaRtlPlugin* (*)();
  const auto entry = reinterpret_cast<Entry>(dlsym(handle_, "pineda_rtl_plugin"));
  plugin_ = entry != nullptr ? entry() : nullptr;
  if (plugin_ == nullptr || plugin_->abi != kPinedaRtlAbi) {
    throw PluginError(fmt::format("{}: not a plug-in of this version", file));
  }
  if (plugin_->package_hash != spec::package_hash(contract_)) {
    throw PluginError(fmt::format("{}: built from another package (hash {:016x}, expected {:016x})",
                                  file, plugin_->package_hash, spec::package_hash(contract_)));
  }
}

RtlLibrary::~RtlLibrary() {
  if (handle_ != nullptr) dlclose(handle_);
}

RtlUnit::RtlUnit(const RtlLibrary& library, const std::string& unit)
    : contract_(library.contract()),
      plugin_(library.plugin()),
      name_(unit),
      rtl_(plugin_.open(unit.c_str())) {
  if (rtl_ == nullptr) throw RtlError(fmt::format("the RTL has no unit '{}'", unit));
}

RtlUnit::~RtlUnit() { plugin_.close(rtl_); }

PortData RtlUnit::port(const std::string& name) const {
  for (const PinedaRtlPort* port = plugin_.ports(rtl_); port->name != nullptr; ++port) {
    if (name == port->name) return {port->data, port->bytes};
  }
  throw RtlError(fmt::format("{}: no port '{}'", name_, name));
}

void RtlUnit::reset() {
  const PortData rst_n = port("rst_ni");
  rst_n.set_bit(false);
  for (int edge = 0; edge < 2; ++edge) {
    plugin_.settle(rtl_);
    plugin_.clock(rtl_);
  }
  rst_n.set_bit(true);
  cycle_ = 0;
}

void RtlUnit::clock() {
  plugin_.clock(rtl_);
  ++cycle_;
  if (plugin_.errors(rtl_) != 0) {
    throw RtlError(fmt::format("{}: an assertion failed in cycle {}", name_, cycle_ - 1));
  }
}

}  // namespace pineda::tb
