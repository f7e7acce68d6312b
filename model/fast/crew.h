// Threads that work together, again and again.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace pineda::fast {

/// Some threads, one of which is the caller's.
class Crew {
 public:
  /// threads >= 1
  explicit Crew(int threads);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  int size() const { return static_cast<int>(others_.size()) + 1; }
  /// Calls work(0) to work(count - 1), each by the first thread that is free, and waits for all of them.
  /// Throws what one of them threw.
  void each(size_t count, const std::function<void(size_t)>& work);

 private:
  void serve();
  void take_all(std::unique_lock<std::mutex>* lock);

  std::mutex mutex_;
  std::condition_variable begun_, ended_;
  const std::function<void(size_t)>* work_ = nullptr;
  size_t next_ = 0, count_ = 0;  // of the calls: the first one that nobody has taken
  size_t running_ = 0;
  std::exception_ptr thrown_;
  bool stops_ = false;
  std::vector<std::thread> others_;
};

}  // namespace pineda::fast
