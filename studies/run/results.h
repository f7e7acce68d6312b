// The results of studies in a file that lasts: an SQLite database.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "studies/run/study.h"

struct sqlite3;

namespace pineda::studies {

/// A file of results that cannot be read or written, in one line.
class ResultsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One result. What a measure does not depend on is an empty text.
struct Row {
  std::string key;  // of all that the figures depend on: equal keys, equal figures
  std::string scene;
  std::string design;
  std::string memory;  // or the technology, with its clock if one was asked for
  std::string measure;
  std::string made_by;  // versions of what made it
  std::vector<Figure> figures;
};

/// "bunny, high_tile, ideal": what a row is of.
std::string place_of(const Row& row);

/// A database of rows. Whatever ends the program, at whatever moment, a row is there whole or not at
/// all. Several programs may add to one file at once.
class Results {
 public:
  /// Opens a file; makes it if it is not there and `may_make`.
  ///
  /// Errors   ResultsError: no such file, no database of results, or one of another version.
  Results(const std::string& file, bool may_make);

  /// The keys of all rows.
  std::set<std::string> keys() const;
  bool has(const std::string& key) const;
  /// Adds rows, all or none; returns how many were new. A row that is there stays as it is.
  ///
  /// Errors   ResultsError: the disk is full, say.
  size_t add(const std::vector<Row>& rows);
  /// All rows, by scene, design, memory and measure.
  std::vector<Row> rows() const;
  const std::string& file() const { return file_; }

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  class Statement;
  void execute(const char* sql) const;
  int64_t number(const char* sql) const;
  [[noreturn]] void fail() const;

  std::string file_;
  std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace pineda::studies
