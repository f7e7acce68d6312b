#include "studies/vectors/benches.h"

namespace pineda::vectors {

SetupCase run(tb::SetupBench* bench, const SetupCase& inputs) {
  SetupCase got = inputs;
  bench->set_frame(inputs.frame);
  got.out = bench->run(inputs.in).tokens;
  return got;
}

TraversalCase run(tb::TraversalBench* bench, const TraversalCase& inputs) {
  TraversalCase got = inputs;
  got.out = bench->run(inputs.in).tokens;
  return got;
}

InterpZtestCase run(tb::InterpZtestBench* bench, const InterpZtestCase& inputs) {
  InterpZtestCase got = inputs;
  auto writes = bench->run(inputs.frame, inputs.in);
  got.depth = std::move(writes.depth.tokens);
  got.color = std::move(writes.color.tokens);
  return got;
}

FrameCase run(tb::FrameBench* bench, const FrameCase& inputs) {
  FrameCase got = inputs;
  size_t next = 0;
  const auto pull = [&](spec::Triangle* triangle) {
    if (next == inputs.in.size()) return false;
    *triangle = inputs.in[next++];
    return true;
  };
  timing::Listener hits_are_counted;
  got.counters = bench->run(inputs.frame, pull, &hits_are_counted).counters;
  got.buffer = bench->buffer();
  return got;
}

}  // namespace pineda::vectors
