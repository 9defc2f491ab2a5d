#include "storage/repository/store/schema.hpp"

#include <iterator>
#include <stdexcept>
#include <string>

#include "engine/messages/store_messages.hpp"
#include "storage/sql/driver/failure.hpp"
#include "storage/sql/references.hpp"
#include "storage/sql/schema_number.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

void refuse_broken_references(sql::Connection& db) {
  if (sql::has_broken_references(db)) throw std::runtime_error{messages::store_text<"references-broken">()};
}

/// Whether a store at a server has the newest schema, or a newer one that this program may work on.
/// Errors  std::runtime_error for a newer one on which it may not
bool is_up_to_date(sql::Connection& db) {
  constexpr auto engine = sql::Engine::server;
  const std::int64_t schema = sql::schema_number(db);
  if (schema > newest_schema(engine) && sql::schema_usable_from(db) > newest_schema(engine))
    refuse_newer_schema(schema, engine);
  return schema >= newest_schema(engine);
}

/// Runs the scripts that a store at a server lacks. Nodes that start at the same time wait for the first of them.
void set_up_at_server(sql::Connection& db) {
  if (is_up_to_date(db)) return;
  sql::Transaction transaction{db};
  if (is_up_to_date(db)) return;
  const std::int64_t found = sql::schema_number(db);
  const std::int64_t done = found == 0 ? 0 : found - first_server_schema + 1;
  try {
    for (const char* script : server_scripts().subspan(static_cast<std::size_t>(done)))
      sql::execute(db, script);
  } catch (const sql::Failure& failure) {
    if (failure.trouble() != sql::Trouble::not_writable) throw;
    throw std::runtime_error{
        messages::store_text<"store-needs-its-owner">(found, newest_schema(sql::Engine::server))};
  }
  sql::set_schema_number(db, newest_schema(sql::Engine::server), server_schema_usable_from);
  transaction.commit();
}

}  // namespace

std::int64_t newest_schema(sql::Engine engine) {
  return engine == sql::Engine::server ? first_server_schema + std::ssize(server_scripts()) - 1
                                       : std::ssize(schema_scripts());
}

void refuse_newer_schema(std::int64_t schema, sql::Engine engine) {
  const std::int64_t newest = newest_schema(engine);
  if (schema > newest) throw std::runtime_error{messages::store_text<"store-newer">(schema, newest)};
}

void bring_to_newest_schema(sql::Connection& db) {
  if (db.engine() == sql::Engine::server) return set_up_at_server(db);
  const std::int64_t before = sql::schema_number(db);
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
  sql::set_schema_number(db, newest_schema(), newest_schema());
  transaction.commit();
}

}  // namespace floeplan::repository
