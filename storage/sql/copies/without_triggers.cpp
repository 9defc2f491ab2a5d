#include "storage/sql/copies/without_triggers.hpp"

#include <utility>

#include "storage/sql/statement.hpp"

namespace floeplan::sql {

WithoutTriggers::WithoutTriggers(Connection& db, std::vector<std::string> tables)
    : db_{db}, tables_{std::move(tables)} {
  if (db_.engine() == Engine::server) {
    for (const std::string& table : tables_) execute(db_, "ALTER TABLE " + table + " DISABLE TRIGGER USER");
    return;
  }
  std::vector<std::string> names;
  {
    Statement query{db_, "SELECT name, sql FROM main.sqlite_schema WHERE type = 'trigger' ORDER BY name"};
    while (query.step()) {
      names.push_back(query.text(0));
      definitions_.push_back(query.text(1));
    }
  }
  for (const std::string& name : names) execute(db_, "DROP TRIGGER " + name);
}

void WithoutTriggers::end() {
  for (const std::string& definition : definitions_) execute(db_, definition);
  if (db_.engine() != Engine::server) return;
  execute(db_, "SET CONSTRAINTS ALL IMMEDIATE");  // a table with references to be checked later cannot be altered
  for (const std::string& table : tables_) execute(db_, "ALTER TABLE " + table + " ENABLE TRIGGER USER");
}

}  // namespace floeplan::sql
