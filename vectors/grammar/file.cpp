#include "vectors/grammar/file.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "model/spec/design_file.h"
#include "model/spec/package.h"

namespace pineda::vectors {
namespace {

constexpr const char* kMagic = "pineda-vectors 2";
constexpr const char* kParameter = "parameter";
constexpr const char* kCases = "cases";
constexpr const char* kStalls = "stalls";
constexpr int kSeedBits = 64;
constexpr int kHashBits = 64;

std::string hash_text(uint64_t hash) { return hex(static_cast<int64_t>(hash), kHashBits); }

std::unique_ptr<std::istream> open(const std::string& path) {
  auto stream = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*stream || stream->peek() == std::ifstream::traits_type::eof()) {
    // A folder opens, and cannot be read.
    if (!std::filesystem::is_regular_file(path)) {
      throw Refused(path + ": expected a vector file, got none that can be read");
    }
    stream->clear();
  }
  return stream;
}

// The value of the current line, which must be "KEYWORD VALUE".
std::string value(const Lines& lines, const char* keyword) {
  if (!lines.starts_with(keyword) || lines.words() != 2) {
    lines.refuse(fmt::format("'{}' and its value", keyword));
  }
  return lines.word(1, keyword);
}

std::string next_value(Lines* lines, const char* keyword) {
  lines->next();
  return value(*lines, keyword);
}

bool is_named(const spec::Design& design) {
  const spec::Design* const known = spec::find_design(design.name);
  return known != nullptr && spec::differences(design, *known).empty();
}

// "design NAME"; of a design that is not of this build also its parameters, as a design file has
// them.
std::string design_lines(const spec::Design& design) {
  std::string text = fmt::format("design {}\n", design.name);
  if (is_named(design)) return text;
  std::istringstream parameters(spec::design_toml(design));
  for (std::string line; std::getline(parameters, line);) {
    const bool is_parameter = line.rfind("name", 0) != 0 && line.rfind("summary", 0) != 0;
    if (is_parameter) text += fmt::format("{} {}\n", kParameter, line);
  }
  return text;
}

// From the line "design NAME" on; goes to the line behind the parameters.
spec::Design read_design(Lines* lines) {
  const std::string name = next_value(lines, "design");
  const int line = lines->number();
  std::string toml = fmt::format("name = '{}'\n", name);
  bool has_parameters = false;
  while (lines->next() && lines->starts_with(kParameter)) {
    toml += lines->line().substr(std::string(kParameter).size() + 1) + "\n";
    has_parameters = true;
  }
  const spec::Design* const known = spec::find_design(name);
  if (!has_parameters && known == nullptr) {
    lines->refuse_at(line, "the name of a design of this build, or its parameters", name);
  }
  if (!has_parameters) return *known;
  try {
    return spec::parse_design(toml, name);
  } catch (const spec::DesignFileError& error) {
    lines->refuse_at(line, "the parameters of a design", error.what());
  }
}

// The last line read is `formats`.
Header header_of(Lines* lines) {
  if (!lines->next() || lines->line() != kMagic) {
    lines->refuse(fmt::format("'{}'", kMagic));
  }
  Header header;
  const std::string unit = next_value(lines, "unit");
  const auto known = spec::named<Unit>(unit);
  if (!known) lines->refuse("a unit: " + spec::alternatives<Unit>(), unit);
  header.unit = *known;
  header.contract = spec::contract(read_design(lines));
  header.level = static_cast<int>(parse_decimal(*lines, value(*lines, "level"), "level"));
  header.seed = parse_decimal(*lines, next_value(lines, "seed"), "seed");
  const std::string formats = next_value(lines, "formats");
  const std::string present = hash_text(spec::formats_hash(header.contract));
  if (formats != present) {
    lines->refuse(fmt::format("the formats {} of the present design {}; generate the file anew",
                              present, header.contract.design.name),
                  formats);
  }
  return header;
}

// "stalls MODE SEED", where ports stall.
std::string stall_line(const PortStalls& ports) {
  if (ports.mode == memory::StallMode::kNone) return "";
  return fmt::format("{} {} {}\n", kStalls, spec::name_of(ports.mode),
                     hex(static_cast<int64_t>(ports.seed), kSeedBits));
}

PortStalls read_stalls(Lines* lines) {
  if (!lines->starts_with(kStalls)) return {};
  const auto mode = spec::named<memory::StallMode>(lines->word(1, kStalls));
  if (!mode || *mode == memory::StallMode::kNone || lines->words() != 3) {
    lines->refuse("'stalls', source, sink or both, and a seed");
  }
  const PortStalls ports{*mode, parse_hex(*lines, lines->word(2, kStalls), kSeedBits, kStalls)};
  lines->next();
  return ports;
}

template <class Case>
Case read_case(Lines* lines, const FrameCodec& frame, const Codec<Case>& codec) {
  if (!lines->starts_with("case") || lines->words() != 2) lines->refuse("'case' and its name");
  Case value{};
  value.name = lines->word(1, "case");
  lines->next();
  value.frame = frame.read(lines);
  value.ports = read_stalls(lines);
  codec.read(lines, &value);
  if (!lines->starts_with("end") || lines->words() != 1) {
    lines->refuse(fmt::format("'end' of case {}", value.name));
  }
  lines->next();
  return value;
}

// The lines that name the columns, which must be those of the present formats.
void expect_columns(Lines* lines, const std::string& columns) {
  Lines expected("", std::make_unique<std::istringstream>(columns));
  while (expected.next()) {
    if (!lines->next() || lines->line() != expected.line()) {
      lines->refuse("'" + expected.line() + "'");
    }
  }
}

}  // namespace

Header read_header(const std::string& path) {
  Lines lines(path, open(path));
  return header_of(&lines);
}

template <class Case>
Reader<Case>::Reader(const std::string& path) : Reader(path, open(path)) {}

template <class Case>
Reader<Case>::Reader(const std::string& path, std::unique_ptr<std::istream> stream)
    : lines_(path, std::move(stream)),
      header_(header_of(&lines_)),
      frame_(header_.contract),
      codec_(header_.contract) {
  constexpr int kUnitLine = 2;
  if (header_.unit != Case::kUnit) {
    lines_.refuse_at(kUnitLine, fmt::format("the unit {}", spec::name_of(Case::kUnit)),
                     spec::name_of(header_.unit));
  }
  lines_.begin_content();
  expect_columns(&lines_, frame_.columns() + codec_.columns());
  lines_.next();
}

template <class Case>
bool Reader<Case>::next(Case* value) {
  if (lines_.starts_with(kCases)) {
    end();
    return false;
  }
  *value = read_case(&lines_, frame_, codec_);
  ++cases_;
  return true;
}

template <class Case>
void Reader<Case>::end() {
  const std::string content = hash_text(lines_.content_hash());
  if (parse_decimal(lines_, value(lines_, kCases), kCases) != cases_) {
    lines_.refuse(fmt::format("'{} {}', as the file holds", kCases, cases_));
  }
  if (next_value(&lines_, "content") != content) {
    lines_.refuse(fmt::format("'content {}', the hash of the content", content));
  }
  if (lines_.next()) lines_.refuse("the end of the file");
}

template <class Case>
Writer<Case>::Writer(const Header& header, std::ostream* stream)
    : stream_(stream),
      frame_(header.contract),
      codec_(header.contract),
      hash_(spec::text_hash("")) {
  const std::string& name = header.contract.design.name;
  if (name.empty() || name.find_first_of(" \t'") != std::string::npos) {
    throw Refused(fmt::format("expected a design whose name is one word, got '{}'", name));
  }
  *stream_ << fmt::format("{}\nunit {}\n{}level {}\nseed {}\nformats {}\n", kMagic,
                          spec::name_of(Case::kUnit), design_lines(header.contract.design),
                          header.level, header.seed,
                          hash_text(spec::formats_hash(header.contract)));
  content(frame_.columns() + codec_.columns());
}

template <class Case>
void Writer<Case>::content(const std::string& text) {
  hash_ = spec::text_hash(text, hash_);
  *stream_ << text;
}

template <class Case>
void Writer<Case>::write(const Case& value) {
  content(fmt::format("\ncase {}\n{}{}{}end\n", value.name, frame_.write(value.frame),
                      stall_line(value.ports), codec_.write(value)));
  ++cases_;
}

template <class Case>
void Writer<Case>::end() {
  content("\n");
  *stream_ << fmt::format("{} {}\ncontent {}\n", kCases, cases_, hash_text(hash_));
}

WholeFile::WholeFile(const std::string& path)
    : path_(path),
      temporary_(path + ".part"),
      unfinished_(temporary_),
      stream_(temporary_, std::ios::binary) {
  if (!stream_) throw Refused(path_ + ": expected a file that can be written");
}

WholeFile::~WholeFile() {
  if (stream_.is_open()) std::remove(temporary_.c_str());
}

void WholeFile::keep() {
  stream_.close();
  std::error_code error;
  if (stream_) std::filesystem::rename(temporary_, path_, error);
  if (stream_ && !error) return;
  std::remove(temporary_.c_str());
  throw Refused(path_ + ": expected a file that can be written");
}

namespace {

template <class Case>
File<Case> read_all(Reader<Case> reader) {
  const Header& header = reader.header();
  File<Case> file{header.contract, header.level, header.seed, {}};
  for (Case value; reader.next(&value); value = {}) file.cases.push_back(std::move(value));
  return file;
}

template <class Case>
void write_all(const File<Case>& file, std::ostream* stream) {
  Writer<Case> writer({Case::kUnit, file.contract, file.level, file.seed}, stream);
  for (const Case& value : file.cases) writer.write(value);
  writer.end();
}

}  // namespace

template <class Case>
File<Case> read(const std::string& path) {
  return read_all(Reader<Case>(path));
}

template <class Case>
File<Case> read_text(const std::string& path, const std::string& text) {
  return read_all(Reader<Case>(path, std::make_unique<std::istringstream>(text)));
}

template <class Case>
std::string write_text(const File<Case>& file) {
  std::ostringstream stream;
  write_all(file, &stream);
  return stream.str();
}

template <class Case>
void write(const std::string& path, const File<Case>& file) {
  WholeFile whole(path);
  write_all(file, whole.stream());
  whole.keep();
}

#define PINEDA_INSTANTIATE(Case)                                               \
  template class Reader<Case>;                                                 \
  template class Writer<Case>;                                                 \
  template File<Case> read<Case>(const std::string&);                          \
  template File<Case> read_text<Case>(const std::string&, const std::string&); \
  template std::string write_text<Case>(const File<Case>&);                    \
  template void write<Case>(const std::string&, const File<Case>&);
PINEDA_INSTANTIATE(SetupCase)
PINEDA_INSTANTIATE(TraversalCase)
PINEDA_INSTANTIATE(InterpZtestCase)
PINEDA_INSTANTIATE(FrameCase)
#undef PINEDA_INSTANTIATE

}  // namespace pineda::vectors
