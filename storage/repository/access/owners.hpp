#pragma once

#include <cstdint>
#include <string>

#include "engine/core/units.hpp"
#include "storage/repository/store/stored_things.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Whose requests stored which datasets, plans and simulations. What the operator makes from the command line or a watched
/// folder, and what was stored before owners were known, has none.
/// Threads  as the connection: one thread at a time
class Owners {
 public:
  explicit Owners(sql::Connection& db) : db_{db} {}

  /// Of a dataset that has no owner yet; otherwise nothing changes.
  void note_dataset(const std::string& id, const std::string& owner);
  /// Of a plan or a simulation that has no owner yet and was made at that moment: one that was stored before stays whose it
  /// is.
  /// `table`  plan_table or simulation_table
  void note_made(const ThingTable& table, const std::string& id, core::UtcTime made,
                 const std::string& owner);
  /// Of all things of the owner: the files of datasets as they were sent, plans and simulations with their requests.
  [[nodiscard]] std::uint64_t bytes_of(const std::string& owner) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
