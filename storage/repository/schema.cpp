#include "storage/repository/schema.hpp"

#include <stdexcept>
#include <string>

#include "storage/repository/schema_scripts.hpp"
#include "storage/sqlite/statement.hpp"
#include "storage/sqlite/transaction.hpp"

namespace floeplan::repository {
namespace {

/// Dropping a table that others refer to would empty them too. The setting cannot be changed inside a transaction.
class WithoutForeignKeys {
 public:
  explicit WithoutForeignKeys(sqlite::Connection& db) : db_{db} {
    sqlite::execute(db_, "PRAGMA foreign_keys = OFF");
  }
  WithoutForeignKeys(const WithoutForeignKeys&) = delete;
  WithoutForeignKeys& operator=(const WithoutForeignKeys&) = delete;
  ~WithoutForeignKeys() {
    try {
      sqlite::execute(db_, "PRAGMA foreign_keys = ON");
      // NOLINTNEXTLINE(bugprone-empty-catch): the store is not handed out, because opening it failed already
    } catch (const std::runtime_error&) {
    }
  }

 private:
  sqlite::Connection& db_;  // borrowed
};

void refuse_broken_references(sqlite::Connection& db) {
  sqlite::Statement check{db, "PRAGMA foreign_key_check"};
  if (check.step())
    throw std::runtime_error{"the store refers to a dataset that it does not hold; it is damaged"};
}

}  // namespace

std::int64_t newest_schema() { return static_cast<std::int64_t>(schema_scripts().size()); }

std::int64_t schema_of(sqlite::Connection& db) {
  sqlite::Statement query{db, "PRAGMA user_version"};
  return query.step() ? query.integer(0) : 0;
}

void refuse_newer_schema(std::int64_t schema) {
  if (schema <= newest_schema()) return;
  throw std::runtime_error{"the store was written by a newer Floeplan (schema " + std::to_string(schema) +
                           ", this program knows " + std::to_string(newest_schema()) +
                           "); update the program, or choose another folder"};
}

void bring_to_newest_schema(sqlite::Connection& db) {
  const std::int64_t before = schema_of(db);
  refuse_newer_schema(before);
  if (before == newest_schema()) return;

  const WithoutForeignKeys no_foreign_keys{db};
  sqlite::Transaction transaction{db};
  // Asked again: another program may have migrated the store in the meantime.
  const std::int64_t found = schema_of(db);
  refuse_newer_schema(found);
  for (auto schema = static_cast<std::size_t>(found); schema < schema_scripts().size(); ++schema) {
    sqlite::execute(db, schema_scripts()[schema]);
  }
  refuse_broken_references(db);
  sqlite::execute(db, "PRAGMA application_id = " + std::to_string(sqlite::application_id));
  sqlite::execute(db, "PRAGMA user_version = " + std::to_string(newest_schema()));
  transaction.commit();
}

}  // namespace floeplan::repository
