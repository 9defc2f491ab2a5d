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

/// A finished plan, never changed after it was stored.
struct PlanRecord {
  std::int64_t row{};  // given by the store, ascending in the order of insertion: the key to page by
  PlanId id;
  std::string name;
  core::UtcTime created;
  core::UtcTime departure;
  core::UtcTime arrival;
  geo::BoundingBox bounds;
  std::string request_json;   // the inputs, as the client sent them, defaults filled in
  std::string document_json;  // the answer, as the client got it
};

/// Which plans a list wants. Everything empty: all.
struct PlanFilter {
  std::optional<geo::BoundingBox> area{};
  std::optional<core::UtcTime> from{};  // under way at some moment from here on
  std::optional<core::UtcTime> to{};
  std::optional<PlanId> id{};
};

/// Threads  as the connection: one thread at a time
class PlanRepository {
 public:
  explicit PlanRepository(sql::Connection& db) : db_{db} {}

  /// Stores the plan; a plan with the same id is left as it is (the id is a digest of inputs and data).
  /// Returns its row.
  std::int64_t insert(const PlanRecord& plan);
  [[nodiscard]] std::optional<PlanRecord> find(const PlanId& id) const;
  /// At most `limit` plans with a row above `after`, by ascending row.
  [[nodiscard]] std::vector<PlanRecord> list(const PlanFilter& filter, std::int64_t after, int limit) const;
  /// The same, past plans that are damaged. A list for one id is that plan or a failure.
  [[nodiscard]] PartialList<PlanRecord> list_past_damage(const PlanFilter& filter, std::int64_t after,
                                                         int limit) const;
  [[nodiscard]] std::int64_t count(const PlanFilter& filter) const;
  bool remove(const PlanId& id);

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
