#include "storage/repository/store/schema.hpp"

#include <stdexcept>
#include <string>

#include "engine/messages/store_messages.hpp"
#include "storage/sql/references.hpp"
#include "storage/sql/schema_number.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

void refuse_broken_references(sql::Connection& db) {
  if (sql::has_broken_references(db)) throw std::runtime_error{messages::store_text<"references-broken">()};
}

/// Stores at servers begin with this program's schema: there is no older one yet.
void set_up_at_server(sql::Connection& db, std::int64_t before) {
  refuse_newer_schema(before);
  if (before == newest_schema()) return;
  sql::Transaction transaction{db};
  // Asked again: another node may have set up the store in the meantime.
  if (sql::schema_number(db) != newest_schema()) {
    sql::execute(db, server_schema());
    sql::set_schema_number(db, newest_schema());
  }
  transaction.commit();
}

}  // namespace

std::int64_t newest_schema() { return static_cast<std::int64_t>(schema_scripts().size()); }

void refuse_newer_schema(std::int64_t schema) {
  if (schema <= newest_schema()) return;
  throw std::runtime_error{messages::store_text<"store-newer">(schema, newest_schema())};
}

void bring_to_newest_schema(sql::Connection& db) {
  const std::int64_t before = sql::schema_number(db);
  if (db.engine() == sql::Engine::server) return set_up_at_server(db, before);
  refuse_newer_schema(before);
  if (before == newest_schema()) return;

  // With references enforced, dropping a table would also delete the rows that refer to it.
  const sql::WithoutReferences without_references{db};
  sql::Transaction transaction{db};
  // Read again, because another program may have migrated the store meanwhile.
  const std::int64_t found = sql::schema_number(db);
  refuse_newer_schema(found);
  for (auto schema = static_cast<std::size_t>(found); schema < schema_scripts().size(); ++schema) {
    sql::execute(db, schema_scripts()[schema]);
  }
  refuse_broken_references(db);
  sql::set_schema_number(db, newest_schema());
  transaction.commit();
}

}  // namespace floeplan::repository
