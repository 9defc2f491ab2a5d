#include "tests/support/empty_store.hpp"

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <functional>
#include <string>

#include "storage/repository/store/migrations.hpp"
#include "storage/sql/statement.hpp"

namespace floeplan::support {
namespace {

/// The database server beside which the tests run; null: none.
const char* test_server() { return std::getenv("FLOEPLAN_TEST_SERVER"); }

/// The address of a schema at the server, which is made if it is not there.
std::string address_of(const std::string& schema) {
  sql::Connection db = sql::Connection::open_at_server(test_server());
  sql::execute(db, "CREATE SCHEMA IF NOT EXISTS " + schema);
  return std::string{test_server()} + "&options=-csearch_path%3D" + schema;
}

}  // namespace

sql::Connection empty_store() {
  if (test_server() == nullptr) return repository::open_store_in_memory();
  static std::atomic<int> stores{0};
  return repository::open_store_at_server(
      address_of("store_" + std::to_string(getpid()) + "_" + std::to_string(++stores)));
}

std::vector<std::string> store_words(const std::filesystem::path& folder) {
  std::vector<std::string> words{"--data", folder.string()};
  if (test_server() == nullptr) return words;
  const auto number = std::hash<std::string>{}(folder.string());
  words.emplace_back("--store");
  words.push_back(address_of("folder_" + std::to_string(number)));
  return words;
}

}  // namespace floeplan::support
