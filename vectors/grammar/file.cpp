#include "vectors/grammar/file.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "model/spec/design_file.h"
#include "model/spec/package.h"
#include "vectors/grammar/codec.h"

namespace pineda::vectors {
namespace {

constexpr const char* kMagic = "pineda-vectors 1";
constexpr const char* kParameter = "parameter";
constexpr int kHashBits = 64;

std::string hash_text(uint64_t hash) { return hex(static_cast<int64_t>(hash), kHashBits); }

std::string load(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) throw Refused(path + ": expected a vector file, got none that can be read");
  return text;
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

// The header's first lines; the last one read is `seed`.
Header read_identity(Lines* lines) {
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
  return header;
}

// The formats' hash, then the count of cases.
uint64_t read_count(Lines* lines, const spec::Contract& c) {
  const std::string formats = next_value(lines, "formats");
  const std::string present = hash_text(spec::formats_hash(c));
  if (formats != present) {
    lines->refuse(fmt::format("the formats {} of the present design {}; generate the file anew",
                              present, c.design.name),
                  formats);
  }
  return parse_decimal(*lines, next_value(lines, "cases"), "cases");
}

template <class Case>
Case read_case(Lines* lines, const FrameCodec& frame, const Codec<Case>& codec) {
  if (!lines->starts_with("case") || lines->words() != 2) lines->refuse("'case' and its name");
  Case value{};
  value.name = lines->word(1, "case");
  lines->next();
  value.frame = frame.read(lines);
  codec.read(lines, &value);
  if (!lines->starts_with("end") || lines->words() != 1) {
    lines->refuse(fmt::format("'end' of case {}", value.name));
  }
  lines->next();
  return value;
}

// The lines that name the columns, which must be those of the present formats.
void expect_columns(Lines* lines, const std::string& columns) {
  Lines expected("", columns);
  while (expected.next()) {
    if (!lines->next() || lines->line() != expected.line()) {
      lines->refuse("'" + expected.line() + "'");
    }
  }
}

}  // namespace

Header read_header(const std::string& path) {
  Lines lines(path, load(path));
  Header header = read_identity(&lines);
  header.cases = read_count(&lines, header.contract);
  return header;
}

template <class Case>
File<Case> read_text(const std::string& path, const std::string& text) {
  Lines lines(path, text);
  const Header header = read_identity(&lines);
  constexpr int kUnitLine = 2;
  if (header.unit != Case::kUnit) {
    lines.refuse_at(kUnitLine, fmt::format("the unit {}", spec::name_of(Case::kUnit)),
                    spec::name_of(header.unit));
  }
  File<Case> file{header.contract, header.level, header.seed, {}};
  const uint64_t count = read_count(&lines, file.contract);
  const int count_line = lines.number();
  const uint64_t hash = parse_hex(lines, next_value(&lines, "content"), kHashBits, "content");
  const int hash_line = lines.number();
  const uint64_t content = spec::text_hash(lines.rest());

  const FrameCodec frame(file.contract);
  const Codec<Case> codec(file.contract);
  expect_columns(&lines, frame.columns() + codec.columns());
  lines.next();
  while (!lines.at_end()) file.cases.push_back(read_case(&lines, frame, codec));

  // Checked last, so that a malformed line is reported as such.
  if (file.cases.size() != count) {
    lines.refuse_at(count_line, fmt::format("{} cases, as the file holds", file.cases.size()),
                    fmt::format("{}", count));
  }
  if (content != hash) {
    lines.refuse_at(hash_line, fmt::format("the hash {} of the content", hash_text(content)),
                    hash_text(hash));
  }
  return file;
}

template <class Case>
File<Case> read(const std::string& path) {
  return read_text<Case>(path, load(path));
}

template <class Case>
std::string write_text(const File<Case>& file) {
  const FrameCodec frame(file.contract);
  const Codec<Case> codec(file.contract);
  std::string body = frame.columns() + codec.columns();
  for (const Case& c : file.cases) {
    body += fmt::format("\ncase {}\n{}{}end\n", c.name, frame.write(c.frame), codec.write(c));
  }
  return fmt::format("{}\nunit {}\n{}level {}\nseed {}\nformats {}\ncases {}\ncontent {}\n", kMagic,
                     spec::name_of(Case::kUnit), design_lines(file.contract.design), file.level,
                     file.seed, hash_text(spec::formats_hash(file.contract)), file.cases.size(),
                     hash_text(spec::text_hash(body))) +
         body;
}

template <class Case>
void write(const std::string& path, const File<Case>& file) {
  const std::string name = file.contract.design.name;
  if (name.empty() || name.find_first_of(" \t'") != std::string::npos) {
    throw Refused(
        fmt::format("{}: expected a design whose name is one word, got '{}'", path, name));
  }
  const std::string temporary = path + ".part";
  std::ofstream stream(temporary, std::ios::binary);
  stream << write_text(file);
  stream.close();
  std::error_code error;
  if (stream) std::filesystem::rename(temporary, path, error);
  if (!stream || error) {
    std::remove(temporary.c_str());
    throw Refused(path + ": expected a file that can be written");
  }
}

#define PINEDA_INSTANTIATE(Case)                                               \
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
