#include "storage/repository/work/simulation_repository.hpp"

#include <algorithm>

#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

constexpr const char* select_simulation =
    "SELECT row, id, plan_id, name, created_s, request_json, document_json FROM simulation ";

constexpr const char* select_flight =
    "SELECT run, document_json FROM simulation_flight WHERE simulation_row = (SELECT row FROM simulation "
    "WHERE id = ?1) ";

SimulationRecord read_simulation(const sql::Row& row) {
  return {.row = row.integer(0),
          .id = {row.text(1)},
          .plan_id = row.text(2),
          .name = row.text(3),
          .created = row.time(4),
          .request_json = row.text(5),
          .document_json = row.text(6)};
}

}  // namespace

std::int64_t SimulationRepository::insert(const SimulationRecord& simulation,
                                          const std::vector<SimulatedFlight>& flights) {
  sql::Transaction transaction{db_};
  sql::Statement insert{
      db_,
      "INSERT INTO simulation (id, plan_id, name, created_s, request_json, document_json, stored_bytes) "
      "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7) ON CONFLICT (id) DO NOTHING"};
  std::int64_t bytes = std::ssize(simulation.request_json) + std::ssize(simulation.document_json);
  for (const SimulatedFlight& flight : flights) bytes += std::ssize(flight.document_json);
  insert.bind_all(simulation.id.value, simulation.plan_id, simulation.name, simulation.created,
                  simulation.request_json, simulation.document_json, bytes);
  const bool fresh = insert.run() > 0;

  std::int64_t row = 0;
  {
    sql::Statement query{db_, "SELECT row FROM simulation WHERE id = ?1"};
    query.bind(1, simulation.id.value);
    if (query.step()) row = query.integer(0);
  }
  if (fresh) {
    sql::Statement insert_flight{
        db_, "INSERT INTO simulation_flight (simulation_row, run, document_json) VALUES (?1, ?2, ?3)"};
    for (const SimulatedFlight& flight : flights) {
      insert_flight.bind_all(row, flight.run, flight.document_json);
      insert_flight.run();
    }
  }
  transaction.commit();
  return row;
}

std::optional<SimulationRecord> SimulationRepository::find(const SimulationId& id) const {
  sql::Statement query{db_, std::string{select_simulation} + "WHERE id = ?1"};
  query.bind(1, id.value);
  if (!query.step()) return std::nullopt;
  return read_simulation(query);
}

std::vector<SimulationRecord> SimulationRepository::list(const std::optional<std::string>& plan_id,
                                                         std::int64_t after, int limit) const {
  sql::Statement query{db_, std::string{select_simulation} +
                                "WHERE row > ?1 AND (?2 IS NULL OR plan_id = ?2) ORDER BY row LIMIT ?3"};
  query.bind_all(after, plan_id, std::max(limit, 0));
  std::vector<SimulationRecord> simulations;
  while (query.step()) simulations.push_back(read_simulation(query));
  return simulations;
}

PartialList<SimulationRecord> SimulationRepository::list_past_damage(
    const std::optional<std::string>& plan_id, std::int64_t after, int limit) const {
  const auto of_row = [&](std::int64_t row) -> std::optional<SimulationRecord> {
    sql::Statement query{db_,
                         std::string{select_simulation} + "WHERE row = ?1 AND (?2 IS NULL OR plan_id = ?2)"};
    query.bind_all(row, plan_id);
    return query.step() ? std::optional{read_simulation(query)} : std::nullopt;
  };
  return repository::list_past_damage(
      db_, simulation_table, {.behind = after, .limit = limit}, [&] { return list(plan_id, after, limit); },
      of_row);
}

std::int64_t SimulationRepository::count(const std::optional<std::string>& plan_id) const {
  sql::Statement query{db_, "SELECT count(*) FROM simulation WHERE ?1 IS NULL OR plan_id = ?1"};
  query.bind_all(plan_id);
  return query.step() ? query.integer(0) : 0;
}

std::optional<SimulatedFlight> SimulationRepository::find_flight(const SimulationId& id,
                                                                 std::int64_t run) const {
  sql::Statement query{db_, std::string{select_flight} + "AND run = ?2"};
  query.bind_all(id.value, run);
  if (!query.step()) return std::nullopt;
  return SimulatedFlight{query.integer(0), query.text(1)};
}

std::vector<SimulatedFlight> SimulationRepository::flights(const SimulationId& id) const {
  sql::Statement query{db_, std::string{select_flight} + "ORDER BY run"};
  query.bind(1, id.value);
  std::vector<SimulatedFlight> flights;
  while (query.step()) flights.push_back({query.integer(0), query.text(1)});
  return flights;
}

bool SimulationRepository::remove(const SimulationId& id) {
  sql::Statement remove{db_, "DELETE FROM simulation WHERE id = ?1"};
  remove.bind(1, id.value);
  return remove.run() > 0;
}

}  // namespace floeplan::repository
