// A file that will be written only once the work is done, or as it goes on.
#pragma once

#include <cstdio>
#include <filesystem>
#include <list>
#include <string>
#include <vector>

#include "model/files/unfinished.h"

namespace pineda::cli {

/// Creates a file under a temporary name before the work starts, so that a file that cannot be
/// written is reported first. Without keep(), and also when a signal ends the program, nothing is
/// left behind and an older file of that name stays as it was.
///
/// Errors   scene::InputError in one line.
class ReservedFile {
 public:
  explicit ReservedFile(const std::string& path);
  ~ReservedFile();
  ReservedFile(const ReservedFile&) = delete;
  ReservedFile& operator=(const ReservedFile&) = delete;

  const std::string& path() const { return path_; }
  /// Where it is until it is kept, and open for writing.
  const std::string& temporary() const { return temporary_; }
  std::FILE* file() const { return file_; }

  /// Closes the file and moves it to its place; `written`: all writes so far succeeded.
  void keep(bool written);

 private:
  void make_folders(const std::filesystem::path& folder);

  std::string path_;
  std::filesystem::path place_;  // where a link leads
  std::string temporary_;
  std::FILE* file_ = nullptr;
  std::vector<std::filesystem::path> made_;  // folders, the inner ones last
  std::list<files::Unfinished> unfinished_;  // what a signal removes, GTKWave's files included
};

}  // namespace pineda::cli
