#pragma once

#include <cstdint>
#include <string>

#include "engine/core/units.hpp"
#include "storage/repository/store/stored_things.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// The owners of datasets, plans and simulations: whoever requested them. Data from the command line or a
/// watched folder, and data stored before owners were recorded, have no owner.
/// Threads  as the connection: one thread at a time
class Owners {
 public:
  explicit Owners(sql::Connection& db) : db_{db} {}

  /// Records the owner of a dataset that has none. Otherwise nothing changes.
  void note_dataset(const std::string& id, const std::string& owner);
  /// Records the owner of a plan or a simulation that has none and was made at this time. A result that was
  /// stored earlier keeps its owner.
  /// `table`  plan_table or simulation_table
  void note_made(const ThingTable& table, const std::string& id, core::UtcTime made,
                 const std::string& owner);
  /// Size in bytes of all that an owner has: files of datasets as sent, plans and simulations with their
  /// requests.
  [[nodiscard]] std::uint64_t bytes_of(const std::string& owner) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
