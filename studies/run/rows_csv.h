// Rows of results as CSV: for a spreadsheet, and to be committed.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "studies/run/results.h"

namespace pineda::studies {

/// A line for each figure under a line of names: scene,design,memory,measure,figure,value,key,made_by.
/// A value is the shortest text that reads as the same double.
std::string csv_of(const std::vector<Row>& rows);

/// Errors   ResultsError: file, line and what was expected.
std::vector<Row> read_csv(const std::string& file);

}  // namespace pineda::studies
