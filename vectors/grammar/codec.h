// A case's state, and its body: the lines between that and `end`, one codec a unit. For file.cpp.
#pragma once

#include <string>

#include "vectors/grammar/cases.h"
#include "vectors/grammar/text.h"

namespace pineda::vectors {

/// The state of a case: its `frame` line, and behind it a line `clear_depth` where depth is not
/// cleared to the greatest code.
class FrameCodec {
 public:
  explicit FrameCodec(const spec::Contract& c);
  std::string columns() const { return row_.columns(); }
  std::string write(const spec::FrameState& frame) const;
  /// From the current line on; goes to the line behind it.
  spec::FrameState read(Lines* lines) const;

 private:
  spec::Contract contract_;
  Row<spec::FrameState> row_;
};

/// columns(): the lines that name the columns. write(): the body. read(): fills all but name and
/// frame from the current line on, stops at the first line that is not the body's.
template <class Case>
class Codec;

template <>
class Codec<SetupCase> {
 public:
  explicit Codec(const spec::Contract& c) : triangle_(c), prim_(c) {}
  std::string columns() const;
  std::string write(const SetupCase& value) const;
  void read(Lines* lines, SetupCase* value) const;

 private:
  Row<spec::Triangle> triangle_;
  Row<spec::SetupPrim> prim_;
};

template <>
class Codec<TraversalCase> {
 public:
  explicit Codec(const spec::Contract& c) : prim_(c), stamp_(c) {}
  std::string columns() const;
  std::string write(const TraversalCase& value) const;
  void read(Lines* lines, TraversalCase* value) const;

 private:
  Row<spec::SetupPrim> prim_;
  Row<spec::Stamp> stamp_;
};

template <>
class Codec<InterpZtestCase> {
 public:
  explicit Codec(const spec::Contract& c) : contract_(c), stamp_(c), depth_(c), color_(c) {}
  std::string columns() const;
  std::string write(const InterpZtestCase& value) const;
  void read(Lines* lines, InterpZtestCase* value) const;

 private:
  bool covers_frame(const spec::Stamp& stamp, const spec::FrameState& frame) const;

  spec::Contract contract_;
  Row<spec::Stamp> stamp_;
  Row<spec::DepthWrite> depth_;
  Row<spec::ColorWrite> color_;
};

template <>
class Codec<FrameCase> {
 public:
  explicit Codec(const spec::Contract& c) : contract_(c), triangle_(c) {}
  std::string columns() const;
  std::string write(const FrameCase& value) const;
  void read(Lines* lines, FrameCase* value) const;

 private:
  std::string write_sample(const Sample& sample) const;
  Sample read_sample(const Lines& lines) const;

  spec::Contract contract_;
  Row<spec::Triangle> triangle_;
};

}  // namespace pineda::vectors
