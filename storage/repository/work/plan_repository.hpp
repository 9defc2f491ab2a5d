#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/bounding_box.hpp"
#include "storage/repository/store/partial_list.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

struct PlanId {
  std::string value;

  friend auto operator<=>(const PlanId&, const PlanId&) = default;
};

/// A finished plan. It is not changed after it was stored.
struct PlanRecord {
  // assigned by the store, ascending in the order of insertion; used as the key for paging
  std::int64_t row{};
  PlanId id;
  std::string name;
  core::UtcTime created;
  core::UtcTime departure;
  core::UtcTime arrival;
  geo::BoundingBox bounds;
  std::string request_json;   // the inputs of the client, with defaults filled in
  std::string document_json;  // the answer to the client
};

/// Conditions for a list of plans. Empty members are no condition.
struct PlanFilter {
  std::optional<geo::BoundingBox> area{};
  std::optional<core::UtcTime> from{};  // under way at some time from here on
  std::optional<core::UtcTime> to{};
  std::optional<PlanId> id{};
};

/// The stored plans.
/// Threads  as the connection: one thread at a time
class PlanRepository {
 public:
  explicit PlanRepository(sql::Connection& db) : db_{db} {}

  /// Stores the plan. An existing plan with the same id is kept (the id is a digest of inputs and data).
  /// Returns its row.
  std::int64_t insert(const PlanRecord& plan);
  [[nodiscard]] std::optional<PlanRecord> find(const PlanId& id) const;
  /// At most `limit` plans with a row above `after`, by ascending row.
  [[nodiscard]] std::vector<PlanRecord> list(const PlanFilter& filter, std::int64_t after, int limit) const;
  /// As `list`, without damaged plans. With an id in the filter, a damaged plan is an error.
  [[nodiscard]] PartialList<PlanRecord> list_past_damage(const PlanFilter& filter, std::int64_t after,
                                                         int limit) const;
  [[nodiscard]] std::int64_t count(const PlanFilter& filter) const;
  bool remove(const PlanId& id);

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
