#include "storage/sql/salvage.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "storage/sql/statement.hpp"

namespace floeplan::sql {
namespace {

constexpr std::int64_t before_all_rows = std::numeric_limits<std::int64_t>::min();
/// How far after a damaged row a readable one is searched, in row numbers: more than the rows of any store.
constexpr std::int64_t farthest = std::int64_t{1} << 40;
/// How many rows are tried one by one at a damaged page. A page has at most a few hundred rows.
constexpr std::int64_t most_tried = 65'536;

std::string qualified(const std::string& schema, std::string_view table) {
  return schema + "." + std::string{table};
}

enum class RowState { readable, absent, damaged };

std::string columns_read(RowReading reading) { return reading == RowReading::whole ? "rowid, *" : "rowid"; }

/// Tests single rows, and finds the next row after a number.
class RowProbe {
 public:
  RowProbe(Connection& db, const std::string& table, RowReading reading)
      : row_{db, "SELECT " + columns_read(reading) + " FROM " + table + without_indices + "WHERE rowid = ?1"},
        next_{db,
              "SELECT rowid FROM " + table + without_indices + "WHERE rowid > ?1 ORDER BY rowid LIMIT 1"} {}

  [[nodiscard]] RowState at(std::int64_t row) {
    bool found = false;
    const bool whole = meets_no_damage([&] {
      row_.reset();
      row_.bind(1, row);
      found = row_.step();
    });
    return !whole ? RowState::damaged : found ? RowState::readable : RowState::absent;
  }

  /// The next row after a number. It is found only if the pages that lead to it can be read.
  struct Next {
    bool is_known{false};
    std::optional<std::int64_t> row;  // empty: there is no further row
  };
  [[nodiscard]] Next behind(std::int64_t row) {
    Next next;
    next.is_known = meets_no_damage([&] {
      next_.reset();
      next_.bind(1, row);
      if (next_.step()) next.row = next_.integer(0);
    });
    return next;
  }

 private:
  Statement row_;
  Statement next_;
};

/// Reads rows after `last` until one cannot be read.
/// Returns  whether the end of the table was reached
bool read_on(Connection& db, const std::string& table, RowReading reading, std::int64_t& last,
             RowList& rows) {
  return meets_no_damage([&] {
    Statement query{db, "SELECT " + columns_read(reading) + " FROM " + table + without_indices +
                            "WHERE rowid > ?1 ORDER BY rowid"};
    query.bind(1, last);
    while (query.step()) {
      last = query.integer(0);
      rows.readable.push_back(last);
    }
  });
}

void add_gap(RowList& rows, std::int64_t first, std::int64_t last) {
  if (!rows.gaps.empty() && rows.gaps.back().last + 1 == first)
    rows.gaps.back().last = last;
  else
    rows.gaps.push_back({first, last});
}

/// Tries single rows after `last`, up to the first page that can be read again.
/// Returns  the last row tried
std::int64_t cross_damage(RowProbe& probe, std::int64_t last, RowList& rows) {
  if (const auto next = probe.behind(last); next.is_known && next.row) {
    add_gap(rows, *next.row, *next.row);  // its number can be read, but not its content
    return *next.row;
  }
  const std::int64_t begin = std::max<std::int64_t>(last, 0);
  std::int64_t step = 1;
  while (step < farthest && !probe.behind(begin + step).is_known) step *= 2;
  const std::int64_t end = begin + step;
  const std::int64_t tried = std::min(end, begin + most_tried);
  for (std::int64_t row = begin + 1; row <= tried; ++row) {
    const RowState found = probe.at(row);
    if (found == RowState::readable) rows.readable.push_back(row);
    if (found == RowState::damaged) add_gap(rows, row, row);
  }
  if (tried < end) add_gap(rows, tried + 1, end);
  return end;
}

std::optional<std::string> index_of(Connection& db, const std::string& schema, std::string_view table,
                                    std::string_view column) {
  Statement query{db,
                  "SELECT list.name FROM pragma_index_list(?1, ?2) AS list WHERE "
                  "(SELECT group_concat(info.name) FROM pragma_index_info(list.name, ?2) AS info) = ?3"};
  query.bind_all(std::string{table}, schema, std::string{column});
  return query.step() ? std::optional{query.text(0)} : std::nullopt;
}

}  // namespace

RowList rows_of(Connection& db, const std::string& schema, const std::string& table, RowReading reading) {
  const std::string name = qualified(schema, table);
  RowList rows;
  std::int64_t last = before_all_rows;
  RowProbe probe{db, name, reading};
  while (!read_on(db, name, reading, last, rows) && last < farthest) last = cross_damage(probe, last, rows);
  return rows;
}

bool has_row_numbers(Connection& db, const std::string& schema, const std::string& table) {
  Statement query{db, "SELECT 1 FROM " + schema +
                          ".sqlite_schema WHERE name = ?1 AND type = 'table' AND sql LIKE '%WITHOUT ROWID%'"};
  query.bind(1, table);
  return !query.step();
}

std::string query_of_row(const std::string& schema, std::string_view table, std::string_view column) {
  return "SELECT " + std::string{column} + " FROM " + qualified(schema, table) + without_indices +
         "WHERE rowid = ?1";
}

IndexedColumn indexed_column(Connection& db, const std::string& schema, std::string_view table,
                             std::string_view column) {
  IndexedColumn values;
  const auto index = index_of(db, schema, table, column);
  values.is_whole = index && meets_no_damage([&] {
                      Statement query{db, "SELECT rowid, " + std::string{column} + " FROM " +
                                              qualified(schema, table) + " INDEXED BY " + *index};
                      while (query.step()) values.by_row[query.integer(0)] = query.text(1);
                    });
  return values;
}

}  // namespace floeplan::sql
