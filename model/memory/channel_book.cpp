#include "model/memory/channel_book.h"

#include <algorithm>
#include <iterator>

namespace pineda::memory {

ChannelBook::Time ChannelBook::book(Time arrival, Time duration) {
  Time start = std::max(arrival, forgotten_);
  auto next = busy_.upper_bound(start);
  if (next != busy_.begin()) start = std::max(start, std::prev(next)->second);
  for (; next != busy_.end() && next->first < start + duration; ++next) start = next->second;
  if (duration == 0) return start;
  total_ += duration;
  // Stretches that touch become one.
  Time end = start + duration;
  if (next != busy_.end() && next->first == end) {
    end = next->second;
    next = busy_.erase(next);
  }
  const bool touches = next != busy_.begin() && std::prev(next)->second == start;
  if (touches) {
    std::prev(next)->second = end;
  } else {
    busy_.emplace_hint(next, start, end);
  }
  return start;
}

void ChannelBook::forget(Time before) {
  forgotten_ = std::max(forgotten_, before);
  while (!busy_.empty() && busy_.begin()->second <= forgotten_) busy_.erase(busy_.begin());
}

}  // namespace pineda::memory
