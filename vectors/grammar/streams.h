// The streams of a case as rows of numbers, for whoever writes them in another form.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "vectors/grammar/cases.h"

namespace pineda::vectors {

/// An element of a field.
struct StreamColumn {
  std::string name;  // "e[1]"
  int bits = 0;
  bool is_signed = false;
  int position = 0;  // its lowest bit in the packed row
};

/// What a row of a stream looks like. Rows of a struct are packed as that struct is in SystemVerilog.
struct StreamShape {
  std::string name;  // "triangle"
  std::vector<StreamColumn> columns;
  int bits = 0;  // of a packed row
};

/// The streams of a unit's cases, inputs first: `case` (state and stalls, one row), those of the structs, of
/// setup also `drop` (core::Drop of each triangle), of a frame also `counters` (one row) and `sample`.
template <class Case>
std::vector<StreamShape> stream_shapes(const spec::Contract& contract);

/// Calls visit(stream, values) for each row, stream by stream; `stream` indexes stream_shapes().
template <class Case>
void for_each_row(const spec::Contract& contract, const Case& value,
                  const std::function<void(size_t, const std::vector<int64_t>&)>& visit);

}  // namespace pineda::vectors
