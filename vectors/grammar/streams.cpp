#include "vectors/grammar/streams.h"

#include <type_traits>

#include "model/spec/fields.h"

namespace pineda::vectors {

using spec::Contract;

namespace {

// Columns that are not of a struct, the first in the top bits.
StreamShape shape(const std::string& name, std::vector<StreamColumn> columns) {
  StreamShape made{name, std::move(columns), 0};
  for (auto column = made.columns.rbegin(); column != made.columns.rend(); ++column) {
    column->position = made.bits;
    made.bits += column->bits;
  }
  return made;
}

template <class T>
StreamShape shape_of(const Contract& c) {
  StreamShape made{spec::struct_name<T>(), {}, 0};
  const auto table = spec::fields<T>(c);
  for (const auto& field : table) made.bits += field.bits * field.count;
  int position = made.bits;
  for (const auto& field : table) {
    position -= field.bits * field.count;
    for (int i = 0; i < field.count; ++i) {
      const std::string element = field.count > 1 ? "[" + std::to_string(i) + "]" : "";
      made.columns.push_back(
          {field.name + element, field.bits, field.is_signed, position + i * field.bits});
    }
  }
  return made;
}

template <class T>
std::vector<int64_t> values_of(const Contract& c, const T& token) {
  std::vector<int64_t> values;
  for (const auto& field : spec::fields<T>(c)) {
    for (int i = 0; i < field.count; ++i) values.push_back(field.get(c, token, i));
  }
  return values;
}

// State, then which ports stall, and the seed in two words.
StreamShape case_shape(const Contract& c) {
  StreamShape made = shape_of<spec::FrameState>(c);
  std::vector<StreamColumn> columns = made.columns;
  columns.push_back({"stalls", 2, false, 0});
  columns.push_back({"stall_seed_high", 32, false, 0});
  columns.push_back({"stall_seed_low", 32, false, 0});
  return shape("case", columns);
}
template <class Case>
std::vector<int64_t> case_values(const Contract& c, const Case& value) {
  std::vector<int64_t> values = values_of(c, value.frame);
  values.push_back(static_cast<int64_t>(value.ports.mode));
  values.push_back(static_cast<int64_t>(value.ports.seed >> 32));
  values.push_back(static_cast<int64_t>(value.ports.seed & 0xffffffff));
  return values;
}

StreamShape drop_shape() { return shape("drop", {{"cause", 3, false, 0}}); }

StreamShape counter_shape() {
  std::vector<StreamColumn> columns;
  for (const Counter& counter : counters())
    columns.push_back({counter.name, kCounterBits, false, 0});
  return shape("counters", columns);
}

StreamShape sample_shape(const Contract& c) {
  std::vector<StreamColumn> columns{{"x", kPlaceBits, false, 0},
                                    {"y", kPlaceBits, false, 0},
                                    {"depth", c.design.depth_bits, false, 0}};
  for (int i = 0; i < spec::channels(c.design); ++i) {
    columns.push_back({"color[" + std::to_string(i) + "]", c.design.attribute_bits, false, 0});
  }
  columns.push_back({"hits", kHitBits, false, 0});
  return shape("sample", columns);
}

// Rows of one case, stream by stream.
class Rows {
 public:
  Rows(const Contract& c, const std::function<void(size_t, const std::vector<int64_t>&)>& visit)
      : c_(c), visit_(visit) {}

  void row(const std::vector<int64_t>& values) { visit_(stream_, values); }
  void end_stream() { ++stream_; }
  template <class T>
  void tokens(const std::vector<T>& all) {
    for (const T& token : all) row(values_of(c_, token));
    end_stream();
  }

  void body(const SetupCase& value) {
    tokens(value.in);
    tokens(value.out);
    for (const core::Drop drop : value.drops) row({static_cast<int64_t>(drop)});
  }
  void body(const TraversalCase& value) {
    tokens(value.in);
    tokens(value.out);
  }
  void body(const InterpZtestCase& value) {
    tokens(value.in);
    tokens(value.depth);
    tokens(value.color);
  }
  void body(const FrameCase& value) {
    tokens(value.in);
    std::vector<int64_t> numbers;
    for (const Counter& counter : counters()) {
      numbers.push_back(static_cast<int64_t>(counter.row->of(value.counters)));
    }
    row(numbers);
    end_stream();
    for (const Sample& sample : value.samples) {
      std::vector<int64_t> values{sample.x, sample.y, sample.depth};
      for (size_t i = 0; i < static_cast<size_t>(spec::channels(c_.design)); ++i) {
        values.push_back(sample.color[i]);
      }
      values.push_back(sample.hits);
      row(values);
    }
  }

 private:
  const Contract& c_;
  const std::function<void(size_t, const std::vector<int64_t>&)>& visit_;
  size_t stream_ = 0;
};

}  // namespace

template <class Case>
std::vector<StreamShape> stream_shapes(const Contract& c) {
  std::vector<StreamShape> all{case_shape(c)};
  if constexpr (std::is_same_v<Case, SetupCase>) {
    all.push_back(shape_of<spec::Triangle>(c));
    all.push_back(shape_of<spec::SetupPrim>(c));
    all.push_back(drop_shape());
  } else if constexpr (std::is_same_v<Case, TraversalCase>) {
    all.push_back(shape_of<spec::SetupPrim>(c));
    all.push_back(shape_of<spec::Stamp>(c));
  } else if constexpr (std::is_same_v<Case, InterpZtestCase>) {
    all.push_back(shape_of<spec::Stamp>(c));
    all.push_back(shape_of<spec::DepthWrite>(c));
    all.push_back(shape_of<spec::ColorWrite>(c));
  } else {
    all.push_back(shape_of<spec::Triangle>(c));
    all.push_back(counter_shape());
    all.push_back(sample_shape(c));
  }
  return all;
}

template <class Case>
void for_each_row(const Contract& c, const Case& value,
                  const std::function<void(size_t, const std::vector<int64_t>&)>& visit) {
  Rows rows(c, visit);
  rows.row(case_values(c, value));
  rows.end_stream();
  rows.body(value);
}

#define PINEDA_INSTANTIATE(Case)                                          \
  template std::vector<StreamShape> stream_shapes<Case>(const Contract&); \
  template void for_each_row<Case>(                                       \
      const Contract&, const Case&,                                       \
      const std::function<void(size_t, const std::vector<int64_t>&)>&);
PINEDA_INSTANTIATE(SetupCase)
PINEDA_INSTANTIATE(TraversalCase)
PINEDA_INSTANTIATE(InterpZtestCase)
PINEDA_INSTANTIATE(FrameCase)
#undef PINEDA_INSTANTIATE

}  // namespace pineda::vectors
