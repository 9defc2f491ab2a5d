#include "storage/repository/stored_things.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "storage/sqlite/statement.hpp"

namespace floeplan::repository {
namespace {

constexpr std::int64_t before_all_rows = std::numeric_limits<std::int64_t>::min();
/// As far as a readable row is looked for behind a damaged one: more rows than any store has.
constexpr std::int64_t farthest = std::int64_t{1} << 40;
/// As many rows as are tried one by one, where a page is damaged: pages have a few hundred of the smallest.
constexpr std::int64_t most_tried = 65'536;

std::string qualified(const std::string& schema, std::string_view table) {
  return schema + "." + std::string{table};
}

enum class Row { readable, absent, damaged };

std::string columns_read(RowReading reading) { return reading == RowReading::whole ? "rowid, *" : "rowid"; }

/// Looks at single rows and at the next one behind a number.
class RowProbe {
 public:
  RowProbe(sqlite::Connection& db, const std::string& table, RowReading reading)
      : row_{db, "SELECT " + columns_read(reading) + " FROM " + table + " NOT INDEXED WHERE rowid = ?1"},
        next_{db, "SELECT rowid FROM " + table + " NOT INDEXED WHERE rowid > ?1 ORDER BY rowid LIMIT 1"} {}

  [[nodiscard]] Row at(std::int64_t row) {
    bool found = false;
    const bool whole = meets_no_damage([&] {
      row_.reset();
      row_.bind(1, row);
      found = row_.step();
    });
    return !whole ? Row::damaged : found ? Row::readable : Row::absent;
  }

  /// What comes behind a row, as far as the pages that lead there can be read.
  struct Next {
    bool is_known{false};
    std::optional<std::int64_t> row;  // empty: none comes
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
  sqlite::Statement row_;
  sqlite::Statement next_;
};

/// Reads on from behind `last` as far as it goes.
/// Returns  whether that was the end of the table
bool read_on(sqlite::Connection& db, const std::string& table, RowReading reading, std::int64_t& last,
             RowList& rows) {
  return meets_no_damage([&] {
    sqlite::Statement query{db, "SELECT " + columns_read(reading) + " FROM " + table +
                                    " NOT INDEXED WHERE rowid > ?1 ORDER BY rowid"};
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

/// Every row up to the first page behind `last` that can be read again, one by one.
/// Returns  the last of them
std::int64_t cross_damage(RowProbe& probe, std::int64_t last, RowList& rows) {
  if (const auto next = probe.behind(last); next.is_known && next.row) {
    add_gap(rows, *next.row, *next.row);  // its number can be read, and what it holds cannot
    return *next.row;
  }
  const std::int64_t begin = std::max<std::int64_t>(last, 0);
  std::int64_t step = 1;
  while (step < farthest && !probe.behind(begin + step).is_known) step *= 2;
  const std::int64_t end = begin + step;
  const std::int64_t tried = std::min(end, begin + most_tried);
  for (std::int64_t row = begin + 1; row <= tried; ++row) {
    const Row found = probe.at(row);
    if (found == Row::readable) rows.readable.push_back(row);
    if (found == Row::damaged) add_gap(rows, row, row);
  }
  if (tried < end) add_gap(rows, tried + 1, end);
  return end;
}

/// The index of one column of a table, by which its values can be read without the table.
std::optional<std::string> index_of(sqlite::Connection& db, const std::string& schema,
                                    const ThingTable& table) {
  sqlite::Statement query{
      db,
      "SELECT list.name FROM pragma_index_list(?1, ?2) AS list WHERE "
      "(SELECT group_concat(info.name) FROM pragma_index_info(list.name, ?2) AS info) = ?3"};
  query.bind_all(std::string{table.table}, schema, std::string{table.name});
  return query.step() ? std::optional{query.text(0)} : std::nullopt;
}

/// Names by row, as the index has them; what it can tell no more is left out.
std::map<std::int64_t, std::string> names_by_index(sqlite::Connection& db, const std::string& schema,
                                                   const ThingTable& table, bool& is_whole) {
  std::map<std::int64_t, std::string> names;
  const auto index = index_of(db, schema, table);
  is_whole = index && meets_no_damage([&] {
               sqlite::Statement query{db, "SELECT rowid, " + std::string{table.name} + " FROM " +
                                               qualified(schema, table.table) + " INDEXED BY " + *index};
               while (query.step()) names[query.integer(0)] = query.text(1);
             });
  return names;
}

/// Not by PRAGMA table_list, which reads from R*Trees and fails where one is damaged.
std::vector<std::string> names_where(sqlite::Connection& db, const std::string& schema,
                                     const std::string& condition) {
  sqlite::Statement query{db, "SELECT t.name FROM " + schema + ".sqlite_schema AS t WHERE " +
                                  ordinary_tables + " AND " + condition + " ORDER BY t.name"};
  std::vector<std::string> names;
  while (query.step()) names.push_back(query.text(0));
  return names;
}

std::string has_column(const std::string& schema, std::string_view column) {
  return "EXISTS (SELECT 1 FROM pragma_table_info(t.name, '" + schema + "') AS c WHERE c.name = '" +
         std::string{column} + "')";
}

}  // namespace

RowList rows_of(sqlite::Connection& db, const std::string& schema, const std::string& table,
                RowReading reading) {
  const std::string name = qualified(schema, table);
  RowList rows;
  std::int64_t last = before_all_rows;
  RowProbe probe{db, name, reading};
  while (!read_on(db, name, reading, last, rows) && last < farthest) last = cross_damage(probe, last, rows);
  return rows;
}

ThingList things_in(sqlite::Connection& db, const std::string& schema, const ThingTable& table,
                    RowReading reading) {
  const std::string kind{table.kind};
  const RowList rows = rows_of(db, schema, std::string{table.table}, reading);
  ThingList things;
  sqlite::Statement name{db, "SELECT " + std::string{table.name} + " FROM " + qualified(schema, table.table) +
                                 " NOT INDEXED WHERE rowid = ?1"};
  for (const std::int64_t row : rows.readable) {
    const bool whole = meets_no_damage([&] {
      name.reset();
      name.bind(1, row);
      if (name.step()) things.readable.push_back({kind, name.text(0), row});
    });
    if (!whole) things.damaged.push_back({kind, "", row});
  }
  if (rows.gaps.empty()) return things;
  bool index_is_whole = false;
  const auto names = names_by_index(db, schema, table, index_is_whole);
  for (const RowList::Gap& gap : rows.gaps) {
    auto known = names.lower_bound(gap.first);
    if (!index_is_whole && (known == names.end() || known->first > gap.last))
      things.damaged.push_back({kind, "", gap.first});
    for (; known != names.end() && known->first <= gap.last; ++known)
      things.damaged.push_back({kind, known->second, known->first});
  }
  return things;
}

std::vector<std::string> tables_below(sqlite::Connection& db, const std::string& schema,
                                      const ThingTable& table) {
  return table.key.empty() ? std::vector<std::string>{}
                           : names_where(db, schema, has_column(schema, table.key));
}

std::vector<std::string> tables_beside(sqlite::Connection& db, const std::string& schema) {
  std::string condition = "true";
  for (const ThingTable& table : thing_tables) {
    condition += " AND t.name <> '" + std::string{table.table} + "'";
    if (!table.key.empty()) condition += " AND NOT " + has_column(schema, table.key);
  }
  return names_where(db, schema, condition);
}

}  // namespace floeplan::repository
