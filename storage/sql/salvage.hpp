#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "storage/sql/connection.hpp"
#include "storage/sql/driver/failure.hpp"

/// Functions that read rows after damaged pages, as far as the pages can be found. `schema` is "main", or the
/// name of an attached database.
/// Errors  Failure when the database fails for another reason than damage, or damage makes the schema
///         unreadable
namespace floeplan::sql {

/// How much of a row is read to test whether it is readable.
enum class RowReading { whole, number };

/// Numbers of the readable rows of a table. Only for tables whose rows have numbers (`has_row_numbers`).
struct RowList {
  struct Gap {
    std::int64_t first{};
    std::int64_t last{};
  };
  std::vector<std::int64_t> readable;
  std::vector<Gap> gaps;  // ranges with rows that cannot be read; some numbers in them may be unused
};
[[nodiscard]] RowList rows_of(Connection& db, const std::string& schema, const std::string& table,
                              RowReading reading = RowReading::whole);

/// Whether a table's rows have numbers.
[[nodiscard]] bool has_row_numbers(Connection& db, const std::string& schema, const std::string& table);

/// SQL that reads one column of the row whose number is the first parameter, from the table only, without an
/// index.
[[nodiscard]] std::string query_of_row(const std::string& schema, std::string_view table,
                                       std::string_view column);

/// The values of a column, read from an index on this column only, without the table.
struct IndexedColumn {
  std::map<std::int64_t, std::string> by_row;  // values that cannot be read from the index are missing
  bool is_whole{};                             // false also if there is no such index
};
[[nodiscard]] IndexedColumn indexed_column(Connection& db, const std::string& schema, std::string_view table,
                                           std::string_view column);

/// Runs `work`. Returns whether it met no damage; other failures are thrown.
template <class Work>
[[nodiscard]] bool meets_no_damage(const Work& work) {
  try {
    work();
    return true;
  } catch (const Failure& failure) {
    if (failure.trouble() != Trouble::damaged) throw;
    return false;
  }
}

/// Text to put after a table's name in a query, so that it uses no index.
inline constexpr const char* without_indices = " NOT INDEXED ";

/// Runs `work(" ")`, and, if that meets damage, `work(without_indices)`, because a table can be read without
/// a damaged index. `work` puts the text after the name of a table in its query.
/// Returns  whether one of the two met no damage
template <class Work>
[[nodiscard]] bool past_damaged_indices(const Work& work) {
  return meets_no_damage([&] { work(" "); }) || meets_no_damage([&] { work(without_indices); });
}

}  // namespace floeplan::sql
