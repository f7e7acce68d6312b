// Reads ahead in a thread of its own, while the caller works on what was read before.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace pineda::scene {

/// A ring of items that a thread fills, in order, and the caller takes. Items are reused, so memory
/// is bounded and nothing is copied.
///
/// In       fill(&item), called by the thread only, and never again after it has returned false (there
///          is no more) or thrown.
/// Errors   what fill() threw: by next(), after the items before.
template <class Item>
class ReadAhead {
 public:
  using Fill = std::function<bool(Item*)>;

  /// `items` >= 2: one that the caller has, the others are read meanwhile. All begin as `item`.
  ReadAhead(size_t items, Fill fill, const Item& item = {})
      : items_(items, item), fill_(std::move(fill)) {
    thread_ = std::thread([this] { run(); });
  }
  /// Waits until a fill() that runs has returned.
  ~ReadAhead() {
    change([this] { is_left_ = true; });
    thread_.join();
  }
  ReadAhead(const ReadAhead&) = delete;
  ReadAhead& operator=(const ReadAhead&) = delete;

  /// The next item, the caller's until the next call; nullptr at the end. From then on the thread
  /// touches nothing.
  Item* next() {
    if (has_one_) change([this] { ++returned_; });
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return returned_ < filled_ || has_ended_; });
    has_one_ = returned_ < filled_;
    if (has_one_) return &items_[returned_ % items_.size()];
    if (error_) std::rethrow_exception(error_);
    return nullptr;
  }

 private:
  // The other side is woken when the lock is free, so that it need not wait again.
  template <class Change>
  void change(Change make_change) {
    {
      const std::lock_guard lock(mutex_);
      make_change();
    }
    changed_.notify_one();
  }

  // An item to fill; nullptr once the caller has left.
  Item* room() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return filled_ - returned_ < items_.size() || is_left_; });
    return is_left_ ? nullptr : &items_[filled_ % items_.size()];
  }

  void run() {
    std::exception_ptr error;
    try {
      for (Item* item = room(); item != nullptr && fill_(item); item = room()) {
        change([this] { ++filled_; });
      }
    } catch (...) {
      error = std::current_exception();
    }
    change([&] {
      error_ = error;
      has_ended_ = true;
    });
  }

  std::vector<Item> items_;
  Fill fill_;
  std::mutex mutex_;
  std::condition_variable changed_;
  size_t filled_ = 0;     // items so far
  size_t returned_ = 0;   // of them, those that may be filled again
  bool has_one_ = false;  // the caller
  bool has_ended_ = false;
  bool is_left_ = false;
  std::exception_ptr error_;
  std::thread thread_;
};

}  // namespace pineda::scene
