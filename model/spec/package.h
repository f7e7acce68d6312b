// The SystemVerilog package of a design, generated from the contract.
#pragma once

#include <cstdint>
#include <string>

#include "model/spec/widths.h"

namespace pineda::spec {

/// Text of pineda_pkg.sv: constants, structs and the reciprocal ROM. The same bytes on every run.
std::string package_text(const Contract& contract);

/// Text of loopback.sv: a module that splits every struct into its fields (STRUCT_i ->
/// STRUCT_FIELD_o) and assembles it from fields (STRUCT_FIELD_i -> STRUCT_o). Tests compare packing
/// with it, one bit at a time.
std::string loopback_text(const Contract& contract);

/// The ports of loopback.sv, one line PORT(name) for each.
std::string loopback_ports(const Contract& contract);

/// FNV-1a (64 bits) of a text; of more text, `before` is the hash of what stands before it.
uint64_t text_hash(const std::string& text, uint64_t before = 0xcbf29ce484222325u);

/// Hash of the whole package, buffer depths included. A plug-in stores it, so that one built from
/// another package is refused.
uint64_t package_hash(const Contract& contract);

/// Hash of what decides output bits: the structs' fields and the design's numeric parameters.
/// Vectors store it, so that outdated ones are refused.
uint64_t formats_hash(const Contract& contract);

}  // namespace pineda::spec
