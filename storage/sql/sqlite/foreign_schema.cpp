#include "storage/sql/sqlite/foreign_schema.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <sqlite3.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include "storage/sql/sqlite/library_failure.hpp"

namespace floeplan::sql::sqlite {
namespace {

void distrust_schema_of(sqlite3* db) {
  sqlite3_db_config(db, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(db, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
}

int when_a_connection_opens(sqlite3* db, const char** /*message*/, const sqlite3_api_routines* /*calls*/) {
  distrust_schema_of(db);
  return SQLITE_OK;
}

/// A path as a URI for SQLite, to read a file that nobody changes.
std::string uri_of(const std::filesystem::path& file) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string uri = "file://";
  for (const char c : std::filesystem::absolute(file).string()) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || c == '/' || c == '.' || c == '_' || c == '-') {
      uri += c;
    } else {
      uri += {'%', digits[byte >> 4U], digits[byte & 15U]};
    }
  }
  return uri + "?immutable=1";
}

/// The words and signs of a statement, without comments. Words are in capitals; quoted names are without
/// quotes and marked, so that they are not mistaken for keywords.
class Words {
 public:
  explicit Words(std::string_view sql) : rest_{sql} {
    for (std::string word = next(); !word.empty(); word = next()) words_.push_back(std::move(word));
  }

  [[nodiscard]] std::string at(std::size_t index) const { return index < words_.size() ? words_[index] : ""; }
  [[nodiscard]] bool follow_each_other(std::string_view first, std::string_view second) const {
    return std::ranges::adjacent_find(words_, [&](const std::string& one, const std::string& next) {
             return one == first && next == second;
           }) != words_.end();
  }
  [[nodiscard]] std::string behind(std::string_view word) const {
    const auto found = std::ranges::find(words_, word);
    return found == words_.end() || found + 1 == words_.end() ? "" : *(found + 1);
  }

 private:
  static bool is_part_of_a_word(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return std::isalnum(byte) != 0 || byte >= 128 || c == '_' || c == '$';
  }

  std::string_view cut(std::size_t count) {
    const std::string_view first = rest_.substr(0, count);
    rest_.remove_prefix(first.size());
    return first;
  }

  void skip_blanks_and_comments() {
    while (!rest_.empty()) {
      if (std::isspace(static_cast<unsigned char>(rest_.front())) != 0) {
        cut(1);
      } else if (rest_.starts_with("--")) {
        cut(rest_.find('\n'));
      } else if (rest_.starts_with("/*")) {
        const std::size_t end = rest_.find("*/", 2);
        cut(end == std::string_view::npos ? end : end + 2);
      } else {
        return;
      }
    }
  }

  std::string next() {
    skip_blanks_and_comments();
    if (rest_.empty()) return "";
    const char first = rest_.front();
    if (first == '"' || first == '\'' || first == '`' || first == '[') {
      cut(1);
      const std::string_view name = cut(rest_.find(first == '[' ? ']' : first));
      cut(1);
      return "\"" + capitals(name);
    }
    if (!is_part_of_a_word(first)) return std::string{cut(1)};
    return capitals(
        cut(static_cast<std::size_t>(std::ranges::find_if_not(rest_, is_part_of_a_word) - rest_.begin())));
  }

  static std::string capitals(std::string_view text) {
    std::string result{text};
    std::ranges::transform(result, result.begin(), [](unsigned char c) { return std::toupper(c); });
    return result;
  }

  std::string_view rest_;
  std::vector<std::string> words_;
};

}  // namespace

void distrust_schemas() { sqlite3_auto_extension(reinterpret_cast<void (*)()>(&when_a_connection_opens)); }

std::optional<std::string> active_part_of_statement(const std::string& sql) {
  const Words words{sql};
  const std::string what = words.at(0) == "CREATE" ? words.at(1) : "";
  if (what == "INDEX" || what == "UNIQUE" || what == "TRIGGER") return std::nullopt;
  // "total REAL AS (...)" is a generated column; in a cast, AS is followed by a type, not by a bracket
  if (what == "TABLE")
    return words.follow_each_other("AS", "(") ? std::optional{"a computed column"} : std::nullopt;
  if (what == "VIEW") return "a view";
  if (what != "VIRTUAL") return "something that is no table";
  std::string module = words.behind("USING");
  if (module.starts_with('"')) module.erase(0, 1);
  if (module == "RTREE" || module == "RTREE_I32") return std::nullopt;
  return "a virtual table that is no R*Tree";
}

std::optional<std::string> active_part_of(const std::filesystem::path& file) {
  try {
    SQLite::Database database{uri_of(file), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX};
    distrust_schema_of(database.getHandle());
    SQLite::Statement statements{database, "SELECT sql FROM sqlite_schema WHERE sql IS NOT NULL"};
    while (statements.executeStep())
      if (auto found = active_part_of_statement(statements.getColumn(0).getString())) return found;
    return std::nullopt;
  } catch (const SQLite::Exception& cause) {
    throw failure_of(cause, file.filename().string());
  }
}

}  // namespace floeplan::sql::sqlite
