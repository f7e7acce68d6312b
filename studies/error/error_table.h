// The tables of `pineda error`: for a terminal as lines, for a page as cells.
#pragma once

#include <string>
#include <vector>

#include "studies/error/error.h"

namespace pineda::studies {

struct Column {
  std::string group;  // stands above the first column of a group
  std::string name;
  bool is_text = false;  // false: a figure, aligned to the right
};

struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> designs;
  std::vector<std::vector<std::string>> baselines;
  std::vector<std::string> notes;  // explain the marks that occur in the table
};

/// Coverage, depth and colour errors, and what the design promises.
Table accuracy(const ErrorStudy& study);
/// Speed of the software, cycles of the hardware.
Table speed(const ErrorStudy& study);

/// The tables as lines of at most 110 characters (with names of up to 23): heads, designs, a rule,
/// baselines, notes. Text that is too long for its line is cut.
std::vector<std::string> accuracy_table(const ErrorStudy& study);
std::vector<std::string> speed_table(const ErrorStudy& study);

}  // namespace pineda::studies
