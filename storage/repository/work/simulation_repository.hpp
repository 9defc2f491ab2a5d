#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "storage/repository/store/partial_list.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

struct SimulationId {
  std::string value;

  friend auto operator<=>(const SimulationId&, const SimulationId&) = default;
};

/// A finished simulation of one or many flights. It is not changed after it was stored.
struct SimulationRecord {
  // assigned by the store, ascending in the order of insertion; used as the key for paging
  std::int64_t row{};
  SimulationId id;
  std::string plan_id;  // id of the plan that was flown; it may have been removed since
  std::string name;
  core::UtcTime created;
  std::string request_json;   // the inputs with every default filled in
  std::string document_json;  // the answer: a row for each run, and their statistics
};

/// The complete record of one flight.
struct SimulatedFlight {
  std::int64_t run{};  // from 0
  std::string document_json;
};

/// The stored simulations.
/// Threads  as the connection: one thread at a time
class SimulationRepository {
 public:
  explicit SimulationRepository(sql::Connection& db) : db_{db} {}

  /// Stores the simulation with those flights that are kept completely, in one transaction. An existing
  /// simulation with the same id is kept (the id is a digest of inputs and data). Returns its row.
  std::int64_t insert(const SimulationRecord& simulation, const std::vector<SimulatedFlight>& flights);
  [[nodiscard]] std::optional<SimulationRecord> find(const SimulationId& id) const;
  /// At most `limit` simulations with a row above `after`, of one plan or of all plans.
  [[nodiscard]] std::vector<SimulationRecord> list(const std::optional<std::string>& plan_id,
                                                   std::int64_t after, int limit) const;
  /// As `list`, without damaged simulations.
  [[nodiscard]] PartialList<SimulationRecord> list_past_damage(const std::optional<std::string>& plan_id,
                                                               std::int64_t after, int limit) const;
  [[nodiscard]] std::int64_t count(const std::optional<std::string>& plan_id) const;
  [[nodiscard]] std::optional<SimulatedFlight> find_flight(const SimulationId& id, std::int64_t run) const;
  /// All kept flights, sorted by run.
  [[nodiscard]] std::vector<SimulatedFlight> flights(const SimulationId& id) const;
  bool remove(const SimulationId& id);

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
