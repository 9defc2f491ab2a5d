#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "storage/sql/connection.hpp"
#include "storage/sql/driver/failure.hpp"

/// Reading past damaged pages, as far as any page tells of a row. `schema` is "main", or the name of an attached database.
/// Errors  Failure when the database fails otherwise than by damage, or damage hides its schema
namespace floeplan::sql {

/// How much of a row is read to tell whether it can be.
enum class RowReading { whole, number };

/// The rows of a table, by number, that can be read. Tables that have another key (`has_row_numbers`) have no such list.
struct RowList {
  struct Gap {
    std::int64_t first{};
    std::int64_t last{};
  };
  std::vector<std::int64_t> readable;
  std::vector<Gap> gaps;  // where there are rows that cannot be read, and perhaps numbers that no row has
};
[[nodiscard]] RowList rows_of(Connection& db, const std::string& schema, const std::string& table,
                              RowReading reading = RowReading::whole);

/// Whether a table's rows have numbers.
[[nodiscard]] bool has_row_numbers(Connection& db, const std::string& schema, const std::string& table);

/// A query for one column of the row whose number is the first parameter, which looks at the table alone.
[[nodiscard]] std::string query_of_row(const std::string& schema, std::string_view table,
                                       std::string_view column);

/// A column as the index has it that holds no other: its values can be read without the table.
struct IndexedColumn {
  std::map<std::int64_t, std::string> by_row;  // what the index can tell no more is left out
  bool is_whole{};                             // false also where there is no such index
};
[[nodiscard]] IndexedColumn indexed_column(Connection& db, const std::string& schema, std::string_view table,
                                           std::string_view column);

/// Whether `work` ends without meeting damage; other failures are thrown.
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

/// What goes behind the name of a table in a query that reads it without its indices.
inline constexpr const char* without_indices = " NOT INDEXED ";

/// Does `work(" ")`, and where that meets damage `work(without_indices)`: what an index lists is not lost with it. The
/// text goes behind the name of a table in a query.
/// Returns  whether either went through
template <class Work>
[[nodiscard]] bool past_damaged_indices(const Work& work) {
  return meets_no_damage([&] { work(" "); }) || meets_no_damage([&] { work(without_indices); });
}

}  // namespace floeplan::sql
