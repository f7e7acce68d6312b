#include "studies/run/results.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <filesystem>

namespace pineda::studies {
namespace {

constexpr int kApplication = 0x70696e65;  // "pine", in the file's header
constexpr int kVersion = 1;               // of the tables
constexpr int kPatienceMs = 60'000;       // while another program writes

constexpr const char* kTables =
    "CREATE TABLE result (key TEXT PRIMARY KEY NOT NULL, scene TEXT NOT NULL, design TEXT NOT NULL,"
    " memory TEXT NOT NULL, measure TEXT NOT NULL, made_by TEXT NOT NULL) WITHOUT ROWID;"
    "CREATE TABLE figure (key TEXT NOT NULL REFERENCES result, place INTEGER NOT NULL,"
    " name TEXT NOT NULL, value REAL NOT NULL, PRIMARY KEY (key, place)) WITHOUT ROWID;";

}  // namespace

std::string place_of(const Row& row) {
  std::string text;
  for (const std::string& part : {row.scene, row.design, row.memory}) {
    if (!part.empty()) text += (text.empty() ? "" : ", ") + part;
  }
  return text;
}

/// A prepared statement: bound, then stepped through.
class Results::Statement {
 public:
  Statement(const Results& results, const char* sql) : results_(results) {
    if (sqlite3_prepare_v2(results.database_.get(), sql, -1, &statement_, nullptr) != SQLITE_OK) {
      results.fail();
    }
  }
  ~Statement() { sqlite3_finalize(statement_); }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  void bind(const std::string& text) {
    check(sqlite3_bind_text(statement_, ++bound_, text.data(), static_cast<int>(text.size()),
                            SQLITE_TRANSIENT));
  }
  void bind(int64_t number) { check(sqlite3_bind_int64(statement_, ++bound_, number)); }
  void bind(double value) { check(sqlite3_bind_double(statement_, ++bound_, value)); }
  template <class... Values>
  void run(const Values&... values) {
    (bind(values), ...);
    step();
    check(sqlite3_reset(statement_));
    bound_ = 0;
  }
  /// The next row of the answer; false at its end.
  bool step() {
    const int code = sqlite3_step(statement_);
    if (code != SQLITE_ROW && code != SQLITE_DONE) results_.fail();
    return code == SQLITE_ROW;
  }
  std::string text(int column) const {
    return {reinterpret_cast<const char*>(sqlite3_column_text(statement_, column)),
            static_cast<size_t>(sqlite3_column_bytes(statement_, column))};
  }
  double value(int column) const { return sqlite3_column_double(statement_, column); }
  int64_t number(int column) const { return sqlite3_column_int64(statement_, column); }

 private:
  void check(int code) const {
    if (code != SQLITE_OK) results_.fail();
  }

  const Results& results_;
  sqlite3_stmt* statement_ = nullptr;
  int bound_ = 0;
};

void Results::Close::operator()(sqlite3* database) const { sqlite3_close(database); }

Results::Results(const std::string& file, bool may_make) : file_(file) {
  if (!may_make && !std::filesystem::exists(file)) {
    throw ResultsError(file + ": expected a database of results, there is no such file");
  }
  sqlite3* database = nullptr;
  const int code =
      sqlite3_open_v2(file.c_str(), &database,
                      SQLITE_OPEN_READWRITE | (may_make ? SQLITE_OPEN_CREATE : 0), nullptr);
  database_.reset(database);
  if (code != SQLITE_OK) fail();
  sqlite3_busy_timeout(database, kPatienceMs);
  sqlite3_extended_result_codes(database, 1);
  execute("PRAGMA synchronous = FULL");
  execute(may_make ? "BEGIN IMMEDIATE" : "BEGIN");
  const int64_t application = number("PRAGMA application_id");
  const int64_t version = number("PRAGMA user_version");
  const bool is_empty = number("SELECT count(*) FROM sqlite_master") == 0;
  if (is_empty && may_make) {
    execute(kTables);
    execute(
        fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", kApplication, kVersion)
            .c_str());
  } else if (application != kApplication) {
    throw ResultsError(file + ": expected a database of results, got another one");
  } else if (version != kVersion) {
    throw ResultsError(
        fmt::format("{}: expected results of version {}, got version {}", file, kVersion, version));
  }
  execute("COMMIT");
}

void Results::fail() const {
  throw ResultsError(file_ +
                     ": expected a database of results: " + sqlite3_errmsg(database_.get()));
}

void Results::execute(const char* sql) const {
  if (sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

int64_t Results::number(const char* sql) const {
  Statement statement(*this, sql);
  statement.step();
  return statement.number(0);
}

std::set<std::string> Results::keys() const {
  std::set<std::string> keys;
  Statement all(*this, "SELECT key FROM result");
  while (all.step()) keys.insert(all.text(0));
  return keys;
}

bool Results::has(const std::string& key) const {
  Statement one(*this, "SELECT 1 FROM result WHERE key = ?");
  one.bind(key);
  return one.step();
}

size_t Results::add(const std::vector<Row>& rows) {
  size_t added = 0;
  execute("BEGIN IMMEDIATE");
  try {
    Statement row(*this, "INSERT OR IGNORE INTO result VALUES (?, ?, ?, ?, ?, ?)");
    Statement figure(*this, "INSERT INTO figure VALUES (?, ?, ?, ?)");
    for (const Row& r : rows) {
      row.run(r.key, r.scene, r.design, r.memory, r.measure, r.made_by);
      if (sqlite3_changes(database_.get()) == 0) continue;
      ++added;
      int64_t place = 0;
      for (const Figure& f : r.figures) figure.run(r.key, place++, f.name, f.value);
    }
    execute("COMMIT");
  } catch (...) {
    sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
    throw;
  }
  return added;
}

std::vector<Row> Results::rows() const {
  std::vector<Row> rows;
  Statement all(*this,
                "SELECT key, scene, design, memory, measure, made_by, name, value FROM result "
                "JOIN figure USING (key) ORDER BY scene, design, memory, measure, key, place");
  while (all.step()) {
    if (rows.empty() || rows.back().key != all.text(0)) {
      rows.push_back(
          {all.text(0), all.text(1), all.text(2), all.text(3), all.text(4), all.text(5), {}});
    }
    rows.back().figures.push_back({all.text(6), all.value(7)});
  }
  return rows;
}

}  // namespace pineda::studies
