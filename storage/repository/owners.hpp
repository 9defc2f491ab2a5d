#pragma once

#include <cstdint>
#include <string>

#include "storage/repository/stored_things.hpp"
#include "storage/sqlite/connection.hpp"

namespace floeplan::repository {

/// Whose requests stored which datasets, plans and simulations. What the operator makes from the command line or a watched
/// folder, and what was stored before owners were known, has none.
/// Threads  as the connection: one thread at a time
class Owners {
 public:
  explicit Owners(sqlite::Connection& db) : db_{db} {}

  /// Of a thing that has no owner yet; otherwise nothing changes.
  /// `table`  dataset_table, plan_table or simulation_table
  void note(const ThingTable& table, const std::string& id, const std::string& owner);
  /// Of all things of the owner: the files of datasets as they were sent, plans and simulations as they are answered.
  [[nodiscard]] std::uint64_t bytes_of(const std::string& owner) const;

 private:
  sqlite::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
