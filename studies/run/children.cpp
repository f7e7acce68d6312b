#include "studies/run/children.h"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <system_error>
#include <vector>

namespace pineda::studies {
namespace {

// The first byte that a child sends; one that is cut off sends no kEnd.
constexpr char kAnswer = 'a', kFailure = 'f', kEnd = '.';

void send(int pipe, const std::string& text) {
  for (size_t at = 0; at < text.size();) {
    const ssize_t sent = write(pipe, text.data() + at, text.size() - at);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return;  // nobody listens
    at += static_cast<size_t>(sent);
  }
}

[[noreturn]] void answer(size_t piece, int pipe, const std::function<std::string(size_t)>& work) {
  std::string text;
  try {
    text = kAnswer + work(piece) + kEnd;
  } catch (const std::exception& error) {
    text = std::string(1, kFailure) + error.what() + kEnd;
  }
  send(pipe, text);
  _exit(0);  // not exit(): the parent's buffers and files stay untouched
}

class Child {
 public:
  Child(size_t piece, const std::function<std::string(size_t)>& work) : piece_(piece) {
    int ends[2];
    if (pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
    const pid_t parent = getpid();
    std::fflush(nullptr);
    pid_ = fork();
    if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (pid_ == 0) {
      close(ends[0]);
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (getppid() != parent) _exit(0);
      answer(piece, ends[1], work);
    }
    close(ends[1]);
    pipe_ = ends[0];
  }
  Child(Child&& other) noexcept
      : piece_(other.piece_), pid_(other.pid_), pipe_(other.pipe_), text_(std::move(other.text_)) {
    other.pid_ = 0;
  }
  Child& operator=(Child&& other) noexcept {
    std::swap(piece_, other.piece_);
    std::swap(pid_, other.pid_);
    std::swap(pipe_, other.pipe_);
    std::swap(text_, other.text_);
    return *this;
  }
  ~Child() {
    if (pid_ == 0) return;
    kill(pid_, SIGKILL);
    wait();
  }

  size_t piece() const { return piece_; }
  int pipe_end() const { return pipe_; }
  /// Takes what it has sent; false at the end.
  bool read_some() {
    char part[4096];
    const ssize_t got = read(pipe_, part, sizeof part);
    if (got < 0 && errno == EINTR) return true;
    if (got > 0) text_.append(part, static_cast<size_t>(got));
    return got > 0;
  }
  Answer finish() {
    wait();
    if (text_.size() < 2 || text_.back() != kEnd)
      return {"", "its process ended without an answer"};
    const std::string text = text_.substr(1, text_.size() - 2);
    return text_[0] == kAnswer ? Answer{text, ""} : Answer{"", text};
  }

 private:
  void wait() {
    close(pipe_);
    while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
    pid_ = 0;
  }

  size_t piece_;
  pid_t pid_ = 0;
  int pipe_ = -1;
  std::string text_;
};

}  // namespace

void in_children(size_t count, size_t most, const std::function<bool(size_t)>& begins,
                 const std::function<std::string(size_t)>& work,
                 const std::function<void(size_t, const Answer&)>& done) {
  std::vector<Child> children;
  size_t next = 0;
  for (;;) {
    for (; children.size() < most && next < count; ++next) {
      if (begins(next)) children.emplace_back(next, work);
    }
    if (children.empty()) return;
    std::vector<pollfd> ends;
    for (const Child& child : children) ends.push_back({child.pipe_end(), POLLIN, 0});
    if (poll(ends.data(), ends.size(), -1) < 0 && errno != EINTR) {
      throw std::system_error(errno, std::generic_category(), "poll");
    }
    for (size_t i = children.size(); i-- > 0;) {
      if (ends[i].revents == 0 || children[i].read_some()) continue;
      const size_t piece = children[i].piece();
      const Answer answer = children[i].finish();
      children.erase(children.begin() + static_cast<std::ptrdiff_t>(i));
      done(piece, answer);
    }
  }
}

}  // namespace pineda::studies
