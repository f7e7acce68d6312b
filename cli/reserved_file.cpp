#include "cli/reserved_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "model/scene/error.h"

namespace pineda::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& why) {
  throw scene::InputError(path, fmt::format("expected to write it, got: {}", why));
}

}  // namespace

ReservedFile::ReservedFile(const std::string& path) : path_(path), place_(path) {
  std::error_code error;
  if (fs::is_symlink(place_, error)) place_ = fs::weakly_canonical(place_, error);
  if (fs::exists(place_, error) && !fs::is_regular_file(place_, error)) {
    fail(path_, fs::is_directory(place_, error) ? "a folder" : "no regular file");
  }
  make_folders(place_.parent_path());
  temporary_ = fmt::format("{}.partial-{}", place_.string(), ::getpid());
  unfinished_.emplace_back(temporary_);
  unfinished_.emplace_back(temporary_ + ".hier");
  file_ = std::fopen(temporary_.c_str(), "wb");
  if (file_ != nullptr) return;
  const std::string why = std::strerror(errno);
  for (; !made_.empty(); made_.pop_back()) fs::remove(made_.back(), error);
  fail(path_, why);
}

// Failures are ignored here: they show when the file is opened.
void ReservedFile::make_folders(const fs::path& folder) {
  std::error_code error;
  if (folder.empty() || fs::exists(folder, error)) return;
  make_folders(folder.parent_path());
  unfinished_.emplace_back(folder.string());
  if (fs::create_directory(folder, error)) made_.push_back(folder);
}

ReservedFile::~ReservedFile() {
  if (file_ != nullptr) std::fclose(file_);
  if (temporary_.empty()) return;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
  for (; !made_.empty(); made_.pop_back()) fs::remove(made_.back(), ignored);  // if empty
}

void ReservedFile::keep(bool written) {
  const bool closed = std::fclose(file_) == 0;
  file_ = nullptr;
  if (!written || !closed) fail(path_, std::strerror(errno));
  if (std::rename(temporary_.c_str(), place_.c_str()) != 0) fail(path_, std::strerror(errno));
  temporary_.clear();
  unfinished_.clear();
}

}  // namespace pineda::cli
