#include "storage/repository/store/stored_things.hpp"

#include <algorithm>
#include <iterator>

#include "storage/sql/statement.hpp"
#include "storage/sql/tables.hpp"

namespace floeplan::repository {

ThingList things_in(sql::Connection& db, const std::string& schema, const ThingTable& table,
                    sql::RowReading reading) {
  const std::string kind{table.kind};
  const sql::RowList rows = sql::rows_of(db, schema, std::string{table.table}, reading);
  ThingList things;
  sql::Statement name{db, sql::query_of_row(schema, table.table, table.name)};
  for (const std::int64_t row : rows.readable) {
    const bool whole = sql::meets_no_damage([&] {
      name.reset();
      name.bind(1, row);
      if (name.step()) things.readable.push_back({kind, name.text(0), row});
    });
    if (!whole) things.damaged.push_back({kind, "", row});
  }
  if (rows.gaps.empty()) return things;
  const sql::IndexedColumn names = sql::indexed_column(db, schema, table.table, table.name);
  for (const sql::RowList::Gap& gap : rows.gaps) {
    auto known = names.by_row.lower_bound(gap.first);
    if (!names.is_whole && (known == names.by_row.end() || known->first > gap.last))
      things.damaged.push_back({kind, "", gap.first});
    for (; known != names.by_row.end() && known->first <= gap.last; ++known)
      things.damaged.push_back({kind, known->second, known->first});
  }
  return things;
}

std::vector<std::string> tables_below(sql::Connection& db, const std::string& schema,
                                      const ThingTable& table) {
  return table.key.empty() ? std::vector<std::string>{} : sql::tables_of(db, schema, table.key);
}

std::vector<std::string> tables_beside(sql::Connection& db, const std::string& schema) {
  std::vector<std::string> keys;
  for (const ThingTable& table : thing_tables)
    if (!table.key.empty()) keys.emplace_back(table.key);
  std::vector<std::string> tables = sql::tables_of(db, schema, "", keys);
  std::erase_if(tables, [](const std::string& name) {
    return std::ranges::find(thing_tables, name, &ThingTable::table) != std::end(thing_tables);
  });
  return tables;
}

}  // namespace floeplan::repository
