#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/messages/message.hpp"
#include "engine/ocean/dataset_ref.hpp"
#include "storage/repository/work/plan_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::service {

/// Kinds of changes of a dataset since a plan was made.
enum class DataChange {
  removed,     // it was used for the plan and is no longer stored
  replaced,    // its content has changed, as when features are reported by hand
  superseded,  // it is still stored, but the same request would now use others
  added,       // the same request would now use it; the plan did not
};

struct ChangedData {
  ocean::DatasetRef dataset;
  DataChange change{};
};

/// The result of checking a stored plan in newer data.
struct PlanCheck {
  std::vector<ChangedData> changed_data;   // empty: the same request would give the same plan
  std::vector<messages::Message> dangers;  // the plan must not be flown unchanged
  /// Dangers in the plan itself, except those that the check in the newest data reports with new values.
  std::vector<messages::Message> dangers_of_plan;
  /// Checks that were not possible, and data that the plan did not have.
  std::vector<messages::Message> besides;

  [[nodiscard]] bool stale() const { return !changed_data.empty(); }
  /// The dangers that the pilot has to confirm before any file of the plan is written. A danger of the plan
  /// is included even if the check does not repeat it, because the newer data may not cover its cause.
  [[nodiscard]] std::vector<messages::Message> to_confirm() const;
};

/// Follows a stored plan through the newest data of its request, from its own departure. If the data are
/// unchanged, no check is needed. Common to API and command line.
[[nodiscard]] PlanCheck check_plan(sql::Connection& db, const repository::PlanRecord& record);

/// All messages of the check, dangers first.
[[nodiscard]] std::vector<messages::Message> all_of(const PlanCheck& check);

/// The check as a document, for the API and the command line.
[[nodiscard]] nlohmann::json plan_check_document(const repository::PlanRecord& record,
                                                 const PlanCheck& check);

}  // namespace floeplan::service
