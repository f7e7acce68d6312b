// Compares the tokens at every unit boundary, in order, with those that core defines.
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "model/spec/difference.h"
#include "tb/frame_bench.h"

namespace pineda::tb {

/// The sequences of a frame that core defines, made triangle by triangle when they are asked for,
/// so that memory stays bounded whatever the scene.
class Reference {
 public:
  Reference(const spec::Contract& contract, const spec::FrameState& frame, NextTriangle next)
      : renderer_(contract, frame), next_(std::move(next)) {}

  /// The next token of a boundary, or nullptr when the frame has no more.
  const spec::SetupPrim* prim() { return front(&prims_); }
  const spec::Stamp* stamp() {
    const SentStamp* sent = front(&stamps_);
    return sent == nullptr ? nullptr : &sent->stamp;
  }
  /// No sample of that stamp passes the depth test.
  bool stamp_is_hidden() { return !front(&stamps_)->is_seen; }
  const spec::DepthWrite* depth() { return front(&depths_); }
  const spec::ColorWrite* color() { return front(&colors_); }
  void pop_prim() { prims_.pop_front(); }
  void pop_stamp() { stamps_.pop_front(); }
  void pop_depth() { depths_.pop_front(); }
  void pop_color() { colors_.pop_front(); }

  /// Draws one more triangle than was asked for; false at the end of what there is so far.
  bool draw();

  const core::Renderer& renderer() const { return renderer_; }

 private:
  friend struct Recorder;
  struct SentStamp {
    spec::Stamp stamp;
    bool is_seen;
  };
  template <class T>
  const T* front(std::deque<T>* queue);

  core::Renderer renderer_;
  NextTriangle next_;
  std::deque<spec::SetupPrim> prims_;
  std::deque<SentStamp> stamps_;
  std::deque<spec::DepthWrite> depths_;
  std::deque<spec::ColorWrite> colors_;
};

/// Listens to a run and compares. `who` names the side under test: "RTL" or "SystemC". A design
/// with hierarchical z need not send stamps of which no sample passes the depth test: which it
/// leaves out depends on time, so those are counted, and the sides must agree.
class Scoreboard : public Listener {
 public:
  Scoreboard(std::string who, const spec::Contract& contract, const spec::FrameState& frame,
             NextTriangle next);

  void prim(Cycle cycle, const spec::SetupPrim& got) override;
  void stamp(Cycle cycle, const spec::Stamp& got) override;
  void depth(Cycle cycle, const spec::DepthWrite& got) override;
  void color(Cycle cycle, const spec::ColorWrite& got) override;

  /// Draws one triangle before its tokens are asked for. Whoever feeds the scoreboard calls this
  /// now and then: triangles that are dropped send no tokens, so nothing asks for them, and a long
  /// run of them would pile up.
  void draw_ahead() { reference_.draw(); }

  /// Call once at the end of the run: counts the tokens that never came.
  void finish();

  uint64_t compared() const { return compared_; }
  uint64_t left_out() const { return left_out_; }
  uint64_t mismatches() const { return mismatches_; }
  /// "RTL setup: triangle 12, cycle 345: e[1]: expected 0x.. (..), got 0x.. (..)"; empty if none.
  const std::string& first_divergence() const { return first_; }
  /// Its cycle; none where a token never came.
  std::optional<Cycle> first_cycle() const { return first_cycle_; }
  /// The frame as core drew it; whole after finish().
  const core::Renderer& renderer() const { return reference_.renderer(); }

 private:
  template <class T>
  bool compare(const char* unit, Cycle cycle, const T* expected, const T& got,
               const spec::Comparer<T>& comparer);
  void diverge(const std::string& text, std::optional<Cycle> cycle = {});
  void pass_over_hidden(const spec::Stamp* got);

  std::string who_;
  bool may_leave_out_;
  Reference reference_;
  spec::Comparer<spec::SetupPrim> prims_;
  spec::Comparer<spec::Stamp> stamps_;
  spec::Comparer<spec::DepthWrite> depths_;
  spec::Comparer<spec::ColorWrite> colors_;
  uint64_t compared_ = 0;
  uint64_t left_out_ = 0;
  uint64_t mismatches_ = 0;
  std::string first_;
  std::optional<Cycle> first_cycle_;
};

}  // namespace pineda::tb
