#include "storage/sql/connection.hpp"

#include "storage/sql/postgresql/server_driver.hpp"
#include "storage/sql/sqlite/sqlite_driver.hpp"

namespace floeplan::sql {

Connection Connection::open(const std::filesystem::path& store) {
  return Connection{sqlite::SqliteDriver::open(store)};
}

Connection Connection::open_scratch(const std::filesystem::path& folder) {
  return Connection{sqlite::SqliteDriver::open_scratch(folder)};
}

Connection Connection::open_at_server(const std::string& address) {
  return Connection{postgresql::ServerDriver::open(address)};
}

Connection Connection::in_memory() { return Connection{sqlite::SqliteDriver::in_memory()}; }

}  // namespace floeplan::sql
