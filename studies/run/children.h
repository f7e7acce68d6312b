// Work in child processes, several at once.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace pineda::studies {

/// What became of a piece of work.
struct Answer {
  std::string text;     // that it returned
  std::string failure;  // or what it threw; that the process ended without an answer
};

/// Does `count` pieces of work, at most `most` at once, each in a process of its own. `done` hears of
/// each, in the order in which they end; what it throws ends the children. They end, too, when this
/// process does, however it ends. `begins` may leave a piece out by returning false.
///
/// Errors   std::system_error where no process can be started.
void in_children(size_t count, size_t most, const std::function<bool(size_t)>& begins,
                 const std::function<std::string(size_t)>& work,
                 const std::function<void(size_t, const Answer&)>& done);

}  // namespace pineda::studies
