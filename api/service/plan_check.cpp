#include "api/service/plan_check.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "api/codec/bytes/document_values.hpp"
#include "api/codec/documents/plan_document.hpp"
#include "api/service/export_sea.hpp"
#include "api/service/low_water.hpp"
#include "api/service/mission_service.hpp"
#include "engine/messages/export_messages.hpp"
#include "engine/messages/sentence.hpp"
#include "engine/mission/checking/route_check.hpp"
#include "engine/mission/writing/below_ice.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/environment/environment_loader.hpp"

namespace floeplan::service {
namespace {

using nlohmann::json;
using ocean::DatasetRef;

const char* name_of(DataChange change) {
  switch (change) {
    case DataChange::removed: return "removed";
    case DataChange::replaced: return "replaced";
    case DataChange::superseded: return "superseded";
    case DataChange::added: return "added";
  }
  throw std::logic_error{"DataChange without a name"};
}

bool holds(const std::vector<DatasetRef>& datasets, const DatasetRef& wanted) {
  return std::ranges::any_of(datasets, [&](const DatasetRef& dataset) {
    return dataset.id == wanted.id && dataset.sha256 == wanted.sha256;
  });
}

/// The change of a dataset since the plan was made; empty if it is stored unchanged.
std::optional<DataChange> fate_of(const DatasetRef& used, const repository::DatasetRepository& datasets) {
  const auto stored = datasets.find({used.id});
  if (!stored) return DataChange::removed;
  if (stored->provenance.sha256 != used.sha256) return DataChange::replaced;
  return std::nullopt;
}

/// The changes of the data. `now`: the datasets that the plan's request selects today.
std::vector<ChangedData> changes(sql::Connection& db, const std::vector<DatasetRef>& used,
                                 const std::vector<DatasetRef>& now) {
  const repository::DatasetRepository datasets{db};
  std::vector<ChangedData> result;
  for (const DatasetRef& dataset : used) {
    if (!holds(now, dataset))
      result.push_back({dataset, fate_of(dataset, datasets).value_or(DataChange::superseded)});
  }
  for (const DatasetRef& dataset : now) {
    const bool known = std::ranges::find(used, dataset.id, &DatasetRef::id) != used.end();
    if (!known) result.push_back({dataset, DataChange::added});
  }
  return result;
}

/// The result if the request cannot be evaluated today: the missing datasets, and why the rest is unknown.
PlanCheck not_checkable(sql::Connection& db, const std::vector<DatasetRef>& used, messages::Message why) {
  const repository::DatasetRepository datasets{db};
  PlanCheck check;
  for (const DatasetRef& dataset : used) {
    if (const auto fate = fate_of(dataset, datasets)) check.changed_data.push_back({dataset, *fate});
  }
  check.besides.push_back(std::move(why));
  return check;
}

/// The plan's own message that this kind of data was left out or is missing.
const messages::Message* own_message_of_gap(const planning::Plan& plan, const std::string& kind) {
  const auto own = std::ranges::find_if(plan.messages, [&](const messages::Message& message) {
    return message.code == kind + "-left-out" || message.code == kind + "-missing";
  });
  return own == plan.messages.end() ? nullptr : &*own;
}

/// Messages about kinds of data that the plan was made without. The plan's own message says why, and shown
/// beside the plan's messages it is not told twice.
std::vector<messages::Message> gaps_of(const planning::Plan& plan) {
  std::vector<messages::Message> told;
  const auto tell = [&](const char* kind, messages::Message otherwise) {
    if (std::ranges::find(plan.datasets, kind, &DatasetRef::kind) != plan.datasets.end()) return;
    const auto* const own = own_message_of_gap(plan, kind);
    told.push_back(own != nullptr ? *own : std::move(otherwise));
  };
  tell("bathymetry", messages::export_message<"made-without-bathymetry">());
  tell("ice", messages::export_message<"made-without-ice">());
  tell("icebergs", messages::export_message<"made-without-icebergs">());
  return told;
}

/// Checks the plan in the newest data.
PlanCheck in_newest_data(sql::Connection& db, const repository::PlanRecord& record,
                         const planning::Plan& plan) {
  auto inputs = inputs_of(record);
  if (!inputs) {
    return not_checkable(db, plan.datasets, messages::export_message<"not-checked-by-this-version">());
  }
  const auto environment = repository::load_environment(db, inputs->data);
  if (!environment) {
    return not_checkable(db, plan.datasets,
                         messages::export_message<"not-checked-in-data">(environment.error().front().rule));
  }
  PlanCheck check;
  check.changed_data = changes(db, plan.datasets, environment->datasets);
  std::ranges::copy_if(environment->messages, std::back_inserter(check.dangers), messages::is_grave);
  const auto too_old = std::ranges::count_if(environment->icebergs, [&](const ocean::Iceberg& berg) {
    return ocean::is_too_old(berg, plan.departure);
  });
  if (too_old > 0) check.dangers.push_back(messages::export_message<"sightings-too-old-for-plan">(too_old));
  // A plan does not name the water levels, so new ones do not make it stale.
  if (auto caution = low_water_caution(db, *environment, inputs->request.vehicle, plan))
    check.besides.push_back(std::move(*caution));
  if (!check.stale()) return check;

  inputs->request.depart = plan.departure;  // for a window of departures the best one
  const auto found =
      mission::check_route(*environment, codec::route_of(json::parse(record.document_json)), inputs->request);
  for (const auto& finding : found.findings) {
    if (finding.dangerous) {
      check.dangers.push_back(messages::export_message<"closed-in-newest-data">(finding.place, finding.text));
    } else {
      check.besides.push_back(
          messages::export_message<"unknown-in-newest-data">(finding.place, finding.text));
    }
  }
  if (found.timing) {
    for (const std::string& closed : mission::closed_above_since(plan, *found.timing))
      check.dangers.push_back(messages::export_message<"ice-above-in-newest-data">(closed));
  }
  if (found.findings.empty() && check.dangers.empty()) {
    check.besides.push_back(messages::export_message<"clear-in-newest-data">());
  }
  return check;
}

/// Whether the check reports the same message with present values. Messages of older plans have only text.
bool tells_again(const std::vector<messages::Message>& newest, const messages::Message& message) {
  return std::ranges::any_of(newest, [&](const messages::Message& other) {
    return other.code == message.code || messages::whole_text(other) == messages::whole_text(message);
  });
}

}  // namespace

std::vector<messages::Message> PlanCheck::to_confirm() const {
  std::vector<messages::Message> all = dangers;
  all.insert(all.end(), dangers_of_plan.begin(), dangers_of_plan.end());
  return all;
}

PlanCheck check_plan(sql::Connection& db, const repository::PlanRecord& record) {
  const planning::Plan plan = codec::parse_plan_document(json::parse(record.document_json));
  PlanCheck check = in_newest_data(db, record, plan);
  std::ranges::copy_if(plan.messages, std::back_inserter(check.dangers_of_plan),
                       [&](const messages::Message& message) {
                         return messages::is_grave(message) && !tells_again(check.dangers, message);
                       });
  std::ranges::move(gaps_of(plan), std::back_inserter(check.besides));
  return check;
}

std::vector<messages::Message> all_of(const PlanCheck& check) {
  std::vector<messages::Message> all = check.to_confirm();
  all.insert(all.end(), check.besides.begin(), check.besides.end());
  return all;
}

json plan_check_document(const repository::PlanRecord& record, const PlanCheck& check) {
  json changed = json::array();
  for (const auto& [dataset, change] : check.changed_data) {
    changed.push_back({{"id", dataset.id},
                       {"kind", dataset.kind},
                       {"name", dataset.name},
                       {"sha256", dataset.sha256},
                       {"change", name_of(change)}});
  }
  json dangers = json::array();
  for (const messages::Message& danger : check.dangers) dangers.push_back(messages::whole_text(danger));
  std::vector<messages::Message> others = check.dangers_of_plan;
  others.insert(others.end(), check.besides.begin(), check.besides.end());
  return {{"plan_id", record.id.value},         {"stale", check.stale()},
          {"changed_data", std::move(changed)}, {"messages", codec::messages_json(all_of(check))},
          {"dangers", std::move(dangers)},      {"warnings", messages::sentences(others)}};
}

}  // namespace floeplan::service
