// pineda vectors export: the streams of a file in forms that others read.
#include <filesystem>
#include <list>

#include "cli/commands/vectors.h"
#include "model/spec/pack.h"
#include "vectors/grammar/streams.h"

namespace pineda::cli {
namespace {

using vectors::StreamColumn;
using vectors::StreamShape;
using Values = std::vector<int64_t>;

/// A row's hex word, as $readmemh reads it.
std::string packed_hex(const StreamShape& shape, const Values& values) {
  std::vector<uint32_t> words(static_cast<size_t>(shape.bits + 31) / 32 + 2);
  for (size_t i = 0; i < values.size(); ++i) {
    const StreamColumn& column = shape.columns[i];
    spec::set_bits(words.data(), column.position, column.bits, static_cast<uint64_t>(values[i]));
  }
  std::string text;
  for (int digit = (shape.bits + 3) / 4 - 1; digit >= 0; --digit) {
    text += "0123456789abcdef"[spec::get_bits(words.data(), 4 * digit, 4)];
  }
  return text;
}

/// A folder with a file a stream: rows of all cases, in order. Without keep() nothing of it is left.
class Folder {
 public:
  Folder(const std::string& path, const std::vector<StreamShape>& shapes, const char* ending)
      : path_(path) {
    std::error_code ignored;
    is_made_ = std::filesystem::create_directories(path, ignored);
    for (const StreamShape& shape : shapes) files_.emplace_back(name(shape.name + ending));
  }
  ~Folder() {
    files_.clear();
    std::error_code ignored;
    if (is_made_) std::filesystem::remove(path_, ignored);  // where it is empty
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string name(const std::string& file) const {
    return (std::filesystem::path(path_) / file).string();
  }
  std::ostream& stream(size_t i) {
    return *std::next(files_.begin(), static_cast<std::ptrdiff_t>(i))->stream();
  }
  /// One more file.
  std::ostream& more(const std::string& file) { return *files_.emplace_back(name(file)).stream(); }
  void keep() {
    for (vectors::WholeFile& file : files_) file.keep();
  }

 private:
  std::string path_;
  bool is_made_ = false;
  std::list<vectors::WholeFile> files_;
};

/// Calls visit(number, case) for each.
template <class Case, class Visitor>
uint64_t for_each_case(vectors::Reader<Case>* reader, Visitor&& visit) {
  uint64_t cases = 0;
  for (Case c; reader->next(&c); ++cases) visit(cases, c);
  return cases;
}

// A file a stream; rows.hex: of each case, how many rows each stream has; vectors.svh: the sizes.
template <class Case>
uint64_t export_readmemh(const std::string& path, vectors::Reader<Case>* reader) {
  const spec::Contract& contract = reader->header().contract;
  const auto shapes = vectors::stream_shapes<Case>(contract);
  Folder folder(path, shapes, ".hex");
  std::ostream& counts = folder.more("rows.hex");
  std::vector<uint64_t> total(shapes.size());
  const uint64_t cases = for_each_case(reader, [&](uint64_t, const Case& value) {
    std::vector<uint64_t> count(shapes.size());
    vectors::for_each_row(contract, value, [&](size_t stream, const Values& values) {
      folder.stream(stream) << packed_hex(shapes[stream], values) << "\n";
      ++count[stream];
    });
    for (size_t i = 0; i < count.size(); ++i) {
      counts << fmt::format("{:08x}{}", count[i], i + 1 < count.size() ? " " : "\n");
      total[i] += count[i];
    }
  });
  std::ostream& sizes = folder.more("vectors.svh");
  sizes << fmt::format("// {} cases of {}, {}: memories for $readmemh.\n", cases,
                       spec::name_of(Case::kUnit), contract.design.name);
  sizes << fmt::format("localparam int Cases = {};\nlocalparam int Streams = {};\n", cases,
                       shapes.size());
  for (size_t i = 0; i < shapes.size(); ++i) {
    sizes << fmt::format("localparam int {0}_bits = {1};\nlocalparam int {0}_rows = {2};\n",
                         shapes[i].name, shapes[i].bits, total[i]);
  }
  folder.keep();
  return cases;
}

std::string csv_columns(const StreamShape& shape) {
  std::string text = "case,row";
  for (const StreamColumn& column : shape.columns) text += "," + column.name;
  return text + "\n";
}

template <class Case>
uint64_t export_csv(const std::string& path, vectors::Reader<Case>* reader) {
  const spec::Contract& contract = reader->header().contract;
  const auto shapes = vectors::stream_shapes<Case>(contract);
  Folder folder(path, shapes, ".csv");
  for (size_t i = 0; i < shapes.size(); ++i) folder.stream(i) << csv_columns(shapes[i]);
  const uint64_t cases = for_each_case(reader, [&](uint64_t, const Case& value) {
    std::vector<uint64_t> row(shapes.size());
    vectors::for_each_row(contract, value, [&](size_t stream, const Values& values) {
      folder.stream(stream) << value.name << "," << row[stream]++;
      for (const int64_t number : values) folder.stream(stream) << "," << number;
      folder.stream(stream) << "\n";
    });
  });
  folder.keep();
  return cases;
}

// {"columns": {STREAM: [NAME...]}, "cases": [{"name": .., STREAM: [[NUMBER...]...]}...]}, a case a line.
template <class Case>
uint64_t export_json(const std::string& path, const Json& header, vectors::Reader<Case>* reader) {
  const spec::Contract& contract = reader->header().contract;
  const auto shapes = vectors::stream_shapes<Case>(contract);
  vectors::WholeFile file(path);
  Json head = header;
  head.erase("file");
  for (const StreamShape& shape : shapes) {
    for (const StreamColumn& column : shape.columns)
      head["columns"][shape.name].push_back(column.name);
  }
  std::string text = head.dump();
  text.pop_back();
  *file.stream() << text << ",\"cases\":[";
  const uint64_t cases = for_each_case(reader, [&](uint64_t number, const Case& value) {
    Json one{{"name", value.name}};
    for (const StreamShape& shape : shapes) one[shape.name] = Json::array();
    vectors::for_each_row(contract, value, [&](size_t stream, const Values& values) {
      one[shapes[stream].name].push_back(values);
    });
    *file.stream() << (number > 0 ? ",\n" : "\n") << one.dump();
  });
  *file.stream() << "\n]}\n";
  file.keep();
  return cases;
}

}  // namespace

int export_vectors(const VectorOptions& options) {
  const Output output(options);
  const VectorForm form = *spec::named<VectorForm>(options.form);
  if (form == VectorForm::kPortable || form == VectorForm::kTri) {
    (form == VectorForm::kTri ? export_scenes : export_portable)(options, output);
    return kHolds;
  }
  with_case(vectors::read_header(options.file).unit, [&](auto kind) {
    using Case = decltype(kind);
    vectors::Reader<Case> reader(options.file);
    const uint64_t cases =
        form == VectorForm::kReadmemh ? export_readmemh(options.result, &reader)
        : form == VectorForm::kCsv
            ? export_csv(options.result, &reader)
            : export_json(options.result, header_json(options, reader.header()), &reader);
    output.line("{}: {} cases of {}, {}", options.result, grouped(cases),
                spec::name_of(Case::kUnit), reader.header().contract.design.name);
  });
  return kHolds;
}

}  // namespace pineda::cli
