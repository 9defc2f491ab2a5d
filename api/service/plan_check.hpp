#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/messages/message.hpp"
#include "engine/ocean/dataset_ref.hpp"
#include "storage/repository/work/plan_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::service {

/// What became of a dataset between the making of a plan and now.
enum class DataChange {
  removed,     // the plan was made with it, and it is no longer in the store
  replaced,    // it has other contents under the same name, as features have that people report
  superseded,  // it is in the store, and the same request would take others
  added,       // the same request would take it, and the plan was made without it
};

struct ChangedData {
  ocean::DatasetRef dataset;
  DataChange change{};
};

/// What newer data than those it was made with say of a stored plan.
struct PlanCheck {
  std::vector<ChangedData> changed_data;   // empty: the same request would give the same plan
  std::vector<messages::Message> dangers;  // the plan must not be flown as it is
  /// The dangers that the plan was made with, without those of a code that the newest data tell anew.
  std::vector<messages::Message> dangers_of_plan;
  /// What could not be found out, and what the plan knows nothing of.
  std::vector<messages::Message> besides;

  [[nodiscard]] bool stale() const { return !changed_data.empty(); }
  /// What a pilot confirms before any file of the plan is handed out. A danger of the plan stays one although newer data
  /// do not repeat it: they need not look at what it was found in.
  [[nodiscard]] std::vector<messages::Message> to_confirm() const;
};

/// Follows a stored plan once more through the newest data of its choice, from its own departure. A plan whose data are
/// unchanged has been checked when it was made. One function for API and command line.
[[nodiscard]] PlanCheck check_plan(sql::Connection& db, const repository::PlanRecord& record);

/// The dangers first.
[[nodiscard]] std::vector<messages::Message> all_of(const PlanCheck& check);

/// The check as a document, for the API and the command line.
[[nodiscard]] nlohmann::json plan_check_document(const repository::PlanRecord& record,
                                                 const PlanCheck& check);

}  // namespace floeplan::service
