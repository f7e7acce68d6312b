#include "studies/cycles/child.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <system_error>

namespace pineda::studies {
namespace {

constexpr char kAnswer = 'a';  // sent before an answer; before an exception's message:
constexpr char kFailure = 'f';

void send(int pipe, const char* bytes, size_t size) {
  while (size > 0) {
    const ssize_t sent = write(pipe, bytes, size);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return;  // nobody listens: the parent is gone
    bytes += sent;
    size -= static_cast<size_t>(sent);
  }
}

std::string receive_all(int pipe) {
  std::string text;
  char part[4096];
  for (;;) {
    const ssize_t got = read(pipe, part, sizeof part);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return text;
    text.append(part, static_cast<size_t>(got));
  }
}

[[noreturn]] void work_and_answer(const std::function<void()>& work, int pipe, const void* answer,
                                  size_t bytes) {
  std::string message;
  try {
    work();
    message = kAnswer + std::string(static_cast<const char*>(answer), bytes);
  } catch (const std::exception& error) {
    message = kFailure + std::string(error.what());
  } catch (...) {
  }
  send(pipe, message.data(), message.size());
  _exit(0);  // not exit(): the parent's inherited buffers and files stay untouched
}

}  // namespace

void fill_in_child(const std::function<void()>& work, void* answer, size_t bytes) {
  int ends[2];
  if (pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    close(ends[0]);
    work_and_answer(work, ends[1], answer, bytes);
  }
  close(ends[1]);
  const std::string message = receive_all(ends[0]);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!message.empty() && message[0] == kFailure) throw std::runtime_error(message.substr(1));
  if (message.size() != bytes + 1) {
    throw std::runtime_error("the cycle model ended without an answer");
  }
  std::memcpy(answer, message.data() + 1, bytes);
}

}  // namespace pineda::studies
