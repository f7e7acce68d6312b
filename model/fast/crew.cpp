#include "model/fast/crew.h"

#include <utility>

namespace pineda::fast {

Crew::Crew(int threads) {
  for (int i = 1; i < threads; ++i) others_.emplace_back([this] { serve(); });
}

Crew::~Crew() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stops_ = true;
  }
  begun_.notify_all();
  for (std::thread& other : others_) other.join();
}

void Crew::each(size_t count, const std::function<void(size_t)>& work) {
  std::unique_lock<std::mutex> lock(mutex_);
  work_ = &work;
  next_ = 0;
  count_ = count;
  if (count > 1) begun_.notify_all();
  take_all(&lock);
  ended_.wait(lock, [this] { return running_ == 0; });
  count_ = 0;
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

void Crew::serve() {
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    begun_.wait(lock, [this] { return stops_ || next_ < count_; });
    if (stops_) return;
    take_all(&lock);
    if (running_ == 0) ended_.notify_one();
  }
}

void Crew::take_all(std::unique_lock<std::mutex>* lock) {
  while (next_ < count_) {
    const size_t mine = next_++;
    ++running_;
    lock->unlock();
    std::exception_ptr thrown;
    try {
      (*work_)(mine);
    } catch (...) {
      thrown = std::current_exception();
    }
    lock->lock();
    if (thrown) thrown_ = thrown;
    --running_;
  }
}

}  // namespace pineda::fast
