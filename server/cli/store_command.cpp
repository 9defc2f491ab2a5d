#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "server/cli/program/command.hpp"
#include "server/cli/program/flag_values.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/repository/store/store_copy.hpp"
#include "storage/repository/store/store_lock.hpp"
#include "storage/sql/schema_number.hpp"
#include "storage/sql/shared/roles.hpp"
#include "storage/sql/shared/use_of_store.hpp"
#include "storage/sql/store_address.hpp"
#include "storage/sql/store_file.hpp"

namespace floeplan::cli {
namespace {

namespace fs = std::filesystem;

/// One end of a copy: a store that nobody serves meanwhile.
class QuietStore {
 public:
  /// Errors   std::runtime_error where somebody serves it
  explicit QuietStore(const sql::StoreAddress& address) {
    if (address.folder) {
      lock_.emplace(*address.folder);
      store_.emplace(repository::open_store(*address.folder));
      return;
    }
    store_.emplace(repository::open_store_at_server(*address.server));
    if (!sql::take_store_alone(*store_))
      throw std::runtime_error{messages::command_text<"store-used-by-nodes">()};
  }

  [[nodiscard]] sql::Connection& store() { return *store_; }

 private:
  std::optional<repository::StoreLock> lock_;
  std::optional<sql::Connection> store_;
};

/// Why there is no store to copy; nothing where there is one.
std::optional<std::string> why_none(const sql::StoreAddress& address) {
  if (address.folder) {
    if (fs::exists(sql::database_in(*address.folder))) return std::nullopt;
    return messages::command_text<"no-store-to-keep">(address.folder->string());
  }
  sql::Connection db = sql::Connection::open_at_server(*address.server);
  if (sql::schema_number(db) > 0) return std::nullopt;
  return messages::command_text<"no-store-at-server">();
}

sql::StoreAddress address_of(const std::string& name, const std::string& text) {
  const auto address = sql::parse_store_address(text);
  if (!address) throw flag_fault<"no-store-address">(name, text, sql::store_address_forms);
  return *address;
}

int copy(const sql::StoreAddress& from, const sql::StoreAddress& to) {
  if (const auto none = why_none(from)) return complain(could_not, *none);
  QuietStore source{from};
  QuietStore target{to};
  const repository::CopiedStore copied =
      repository::copy_store(source.store(), target.store(), terminal_progress());
  std::cout << "copied " << copied.datasets << " datasets, " << copied.plans << " plans and " << copied.jobs
            << " jobs, " << copied.rows << " rows in all; both stores were read and are equal\n";
  return done;
}

int prepare(const std::optional<std::string>& role, const Program& program) {
  if (!program.server) return complain<"only-at-database-server">(wrong_usage, "store prepare");
  sql::Connection db = repository::open_store_at_server(*program.server);
  if (role) sql::admit_role(db, *role);
  std::cout << "the store has schema " << sql::schema_number(db)
            << (role ? ", and the role " + *role + " may use it" : "") << '\n';
  return done;
}

}  // namespace

void add_store(CLI::App& app, Program& program) {
  auto* store = app.add_subcommand("store", "Copy a whole store, or prepare one at a database server");
  store->require_subcommand(1);

  auto from = std::make_shared<std::string>();
  auto to = std::make_shared<std::string>();
  auto* copying =
      store->add_subcommand("copy", "Copy a whole store into an empty one; nobody may serve either");
  copying->add_option("FROM", *from, std::string{"The store to copy: "} + sql::store_address_forms)
      ->required();
  copying->add_option("TO", *to, "The new store, in the same form")->required();
  copying->callback(
      [from, to, &program] { program.exit_code = copy(address_of("FROM", *from), address_of("TO", *to)); });

  auto role = std::make_shared<std::optional<std::string>>();
  auto* preparing = store->add_subcommand(
      "prepare", "Make the tables of the store that --store names, or bring them up to date, as their owner");
  preparing->add_option("--for", *role,
                        "Role that may then use the store, but change no table, for example floeplan_node");
  preparing->callback([role, &program] { program.exit_code = prepare(*role, program); });
}

}  // namespace floeplan::cli
