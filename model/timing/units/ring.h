// A queue whose memory is used again.
#pragma once

#include <cstddef>
#include <vector>

namespace pineda::timing {

/// A queue of at most `capacity` elements. push() gives the next one as it was left: elements are
/// neither cleared nor moved, for they may be large.
template <class T>
class Ring {
 public:
  /// Empties it.
  void reset(size_t capacity) {
    elements_.resize(capacity);
    first_ = count_ = 0;
  }
  bool empty() const { return count_ == 0; }
  T& front() { return elements_[first_]; }
  /// The queue must not be full.
  T& push() {
    const size_t next = first_ + count_++;
    return elements_[next < elements_.size() ? next : next - elements_.size()];
  }
  void pop() {
    first_ = first_ + 1 == elements_.size() ? 0 : first_ + 1;
    --count_;
  }

 private:
  std::vector<T> elements_;
  size_t first_ = 0;
  size_t count_ = 0;
};

}  // namespace pineda::timing
