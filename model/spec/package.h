// The SystemVerilog package of a design, generated from the contract.
#pragma once

#include <cstdint>
#include <string>

#include "model/spec/widths.h"

namespace pineda::spec {

/// Text of pineda_pkg.sv: constants, structs and the reciprocal ROM. The same bytes on every run.
std::string package_text(const Contract& contract);

/// Text of loopback.sv: a module that takes every struct apart into its fields (STRUCT_i ->
/// STRUCT_FIELD_o) and puts it together again (STRUCT_FIELD_i -> STRUCT_o). Packing is tested
/// against it, one bit at a time.
std::string loopback_text(const Contract& contract);

/// The ports of that module, each as PORT(name), a line each.
std::string loopback_ports(const Contract& contract);

/// FNV-1a (64 bits) of a text.
uint64_t text_hash(const std::string& text);

/// Hash of the whole package, buffer depths included: a plug-in carries it, so that a stale one is
/// refused.
uint64_t package_hash(const Contract& contract);

/// Hash of what decides bits: the structs' fields and the design's numeric parameters. Vectors
/// carry it, so that stale ones are refused.
uint64_t formats_hash(const Contract& contract);

}  // namespace pineda::spec
