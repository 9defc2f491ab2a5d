#pragma once

#include <cstdint>
#include <string>

#include "engine/core/units.hpp"
#include "storage/repository/store/stored_things.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// The owners whose requests stored datasets, plans and simulations. What the operator makes from the command line or
/// a watched folder, and what was stored before owners were known, has none.
/// Threads  as the connection: one thread at a time
class Owners {
 public:
  explicit Owners(sql::Connection& db) : db_{db} {}

  /// Records the owner of a dataset that has none yet; otherwise nothing changes.
  void note_dataset(const std::string& id, const std::string& owner);
  /// Records the owner of a plan or a simulation that has none yet and was made at that moment: one stored before
  /// stays whose it is.
  /// `table`  plan_table or simulation_table
  void note_made(const ThingTable& table, const std::string& id, core::UtcTime made,
                 const std::string& owner);
  /// Bytes of everything the owner has: files of datasets as they were sent, plans and simulations with their requests.
  [[nodiscard]] std::uint64_t bytes_of(const std::string& owner) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
