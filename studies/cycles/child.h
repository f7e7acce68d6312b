// Runs work in a child process, since SystemC can elaborate only once per process.
#pragma once

#include <cstddef>
#include <functional>
#include <type_traits>

namespace pineda::studies {

/// Runs `work` in a forked process. The `bytes` that it writes to *answer are copied back.
///
/// Errors   std::runtime_error with what `work` threw, or that the process ended without an answer.
void fill_in_child(const std::function<void()>& work, void* answer, size_t bytes);

/// The same for work that returns its answer.
template <class Work>
auto in_child(Work work) {
  using Answer = decltype(work());
  static_assert(std::is_trivially_copyable_v<Answer>, "it goes through a pipe");
  Answer answer{};
  fill_in_child([&] { answer = work(); }, &answer, sizeof answer);
  return answer;
}

}  // namespace pineda::studies
