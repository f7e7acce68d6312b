// Combines what units and FIFOs report during a frame into spans and levels for display.
#pragma once

#include <algorithm>
#include <deque>
#include <limits>

#include "model/timing/counted/listener.h"

namespace pineda::studies {

/// The cycles that are shown: from `from` on, before `until`.
struct Window {
  timing::Cycle from = 0;
  timing::Cycle until = std::numeric_limits<timing::Cycle>::max();

  timing::Cycle clamped(timing::Cycle cycle) const { return std::clamp(cycle, from, until); }
};

/// The cycles [from, until), spent on triangle `id`.
struct Span {
  timing::Cause cause = timing::Cause::kBusy;
  timing::Cycle from = 0;
  timing::Cycle until = 0;
  uint32_t id = 0;

  timing::Cycle cycles() const { return until - from; }
};

/// Joins a unit's spans: neighbours of one cause and triangle become one.
class SpanJoiner {
 public:
  /// Takes spans in order and cuts them to the window. Calls whole(span) for the joined span so far
  /// if this one does not continue it.
  template <class Whole>
  void add(Span span, const Window& window, Whole whole) {
    span.from = window.clamped(span.from);
    span.until = window.clamped(span.until);
    if (span.cycles() <= 0) return;
    if (span.from == last_.until && span.cause == last_.cause && span.id == last_.id) {
      last_.until = span.until;
      return;
    }
    finish(whole);
    last_ = span;
  }

  /// After the last span.
  template <class Whole>
  void finish(Whole whole) {
    if (last_.cycles() > 0) whole(last_);
    last_ = {};
  }

 private:
  Span last_;
};

/// The level of a FIFO as each cycle begins: a slot taken in t counts from t + 1 to the cycle in
/// which it is freed. Keeps no more slots than the FIFO has.
class FifoLevel {
 public:
  /// Slots in order. Calls changed(cycle, level) for each change that is known by now, in order.
  template <class Changed>
  void slot(timing::Cycle inserted, timing::Cycle freed, Changed changed) {
    for (; !freed_.empty() && freed_.front() <= inserted; freed_.pop_front()) {
      step(freed_.front() + 1, -1, changed);
    }
    step(inserted + 1, 1, changed);
    freed_.push_back(freed);
  }

  /// After the last slot.
  template <class Changed>
  void finish(Changed changed) {
    for (; !freed_.empty(); freed_.pop_front()) step(freed_.front() + 1, -1, changed);
    report(changed);
  }

 private:
  template <class Changed>
  void step(timing::Cycle cycle, int by, Changed changed) {
    if (cycle != cycle_) report(changed);
    cycle_ = cycle;
    level_ += by;
  }
  template <class Changed>
  void report(Changed changed) {
    if (level_ != reported_) changed(cycle_, level_);
    reported_ = level_;
  }

  std::deque<timing::Cycle> freed_;  // when the slots still taken are freed
  timing::Cycle cycle_ = 0;          // of the last change; more may follow in the same cycle
  int level_ = 0;
  int reported_ = 0;
};

}  // namespace pineda::studies
