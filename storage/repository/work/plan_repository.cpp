#include "storage/repository/work/plan_repository.hpp"

#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

// The documents are the last columns, so that they are not read for rows that do not meet the filter.
constexpr const char* select_plan =
    "SELECT row, west_deg, south_deg, east_deg, north_deg, id, name, created_s, departure_s, arrival_s, "
    "request_json, "
    "document_json FROM plan ";

geo::BoundingBox read_bounds(const sql::Row& row) {
  return {row.real(1), row.real(2), row.real(3), row.real(4)};
}

PlanRecord read_plan(const sql::Row& row) {
  return {.row = row.integer(0),
          .id = {row.text(5)},
          .name = row.text(6),
          .created = row.time(7),
          .departure = row.time(8),
          .arrival = row.time(9),
          .bounds = read_bounds(row),
          .request_json = row.text(10),
          .document_json = row.text(11)};
}

/// Prepares a query of plans. `rows`: a condition that compares the row with parameter ?1.
sql::Statement select_plans(sql::Connection& db, const std::string& what, const std::string& rows,
                            std::int64_t row, const PlanFilter& filter) {
  std::string sql = what + "WHERE " + rows;
  if (filter.from) sql += " AND arrival_s >= ?2";
  if (filter.to) sql += " AND departure_s <= ?3";
  if (filter.id) sql += " AND id = ?4";
  sql::Statement query{db, sql + " ORDER BY row"};
  query.bind(1, row);
  if (filter.from) query.bind(2, *filter.from);
  if (filter.to) query.bind(3, *filter.to);
  if (filter.id) query.bind(4, filter.id->value);
  return query;
}

bool is_wanted_plan(const sql::Row& row, const PlanFilter& filter) {
  return !filter.area || geo::intersects(*filter.area, read_bounds(row));
}

}  // namespace

std::int64_t PlanRepository::insert(const PlanRecord& plan) {
  sql::Transaction transaction{db_};
  sql::Statement insert{db_,
                        "INSERT INTO plan (id, name, created_s, departure_s, arrival_s, west_deg, "
                        "south_deg, east_deg, north_deg, "
                        "request_json, document_json, stored_bytes) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, "
                        "?8, ?9, ?10, ?11, ?12) ON CONFLICT (id) DO NOTHING"};
  insert.bind_all(plan.id.value, plan.name, plan.created, plan.departure, plan.arrival, plan.bounds.west_deg,
                  plan.bounds.south_deg, plan.bounds.east_deg, plan.bounds.north_deg, plan.request_json,
                  plan.document_json, std::ssize(plan.request_json) + std::ssize(plan.document_json));
  insert.run();

  sql::Statement query{db_, "SELECT row FROM plan WHERE id = ?1"};
  query.bind(1, plan.id.value);
  const std::int64_t row = query.step() ? query.integer(0) : 0;
  transaction.commit();
  return row;
}

std::optional<PlanRecord> PlanRepository::find(const PlanId& id) const {
  sql::Statement query{db_, std::string{select_plan} + "WHERE id = ?1"};
  query.bind(1, id.value);
  if (!query.step()) return std::nullopt;
  return read_plan(query);
}

std::vector<PlanRecord> PlanRepository::list(const PlanFilter& filter, std::int64_t after, int limit) const {
  sql::Statement query = select_plans(db_, select_plan, "row > ?1", after, filter);
  std::vector<PlanRecord> plans;
  while (std::ssize(plans) < limit && query.step()) {
    if (is_wanted_plan(query, filter)) plans.push_back(read_plan(query));
  }
  return plans;
}

PartialList<PlanRecord> PlanRepository::list_past_damage(const PlanFilter& filter, std::int64_t after,
                                                         int limit) const {
  if (filter.id) return {list(filter, after, limit), {}};
  const auto of_row = [&](std::int64_t row) {
    sql::Statement query = select_plans(db_, select_plan, "row = ?1", row, filter);
    const bool wanted = query.step() && is_wanted_plan(query, filter);
    return wanted ? std::optional{read_plan(query)} : std::nullopt;
  };
  return repository::list_past_damage(
      db_, plan_table, {.behind = after, .limit = limit}, [&] { return list(filter, after, limit); }, of_row);
}

std::int64_t PlanRepository::count(const PlanFilter& filter) const {
  sql::Statement query = select_plans(db_, "SELECT row, west_deg, south_deg, east_deg, north_deg FROM plan ",
                                      "row > ?1", 0, filter);
  std::int64_t plans = 0;
  while (query.step()) plans += is_wanted_plan(query, filter) ? 1 : 0;
  return plans;
}

bool PlanRepository::remove(const PlanId& id) {
  sql::Statement remove{db_, "DELETE FROM plan WHERE id = ?1"};
  remove.bind(1, id.value);
  return remove.run() > 0;
}

}  // namespace floeplan::repository
