#include "api/routes/processes/process_checks.hpp"

#include <set>
#include <stdexcept>

#include "api/codec/bytes/sha256.hpp"
#include "api/codec/documents/flight_comparison.hpp"
#include "api/codec/inputs/echo_inputs.hpp"
#include "api/codec/inputs/ingest_inputs.hpp"
#include "api/codec/inputs/plan_inputs.hpp"
#include "api/codec/inputs/reach_inputs.hpp"
#include "api/codec/inputs/scenario_inputs.hpp"
#include "api/codec/inputs/simulate_inputs.hpp"
#include "api/routes/request/owner.hpp"
#include "engine/core/version.hpp"
#include "engine/messages/fault.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/work/plan_repository.hpp"
#include "storage/repository/work/simulation_repository.hpp"
#include "storage/repository/work/uploads_of.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using repository::DatasetKind;

/// Adds a violation for each named dataset that does not exist or is of another kind.
void check_choice(sql::Connection& db, const repository::DatasetChoice& choice, const std::string& key,
                  DatasetKind kind, messages::Faults& faults) {
  for (const auto& id : choice.ids) {
    const auto dataset = repository::DatasetRepository{db}.find(id);
    if (!dataset) faults.refuse<"no-such-dataset">("/" + key, id.value);
    if (dataset && dataset->kind != kind)
      faults.refuse<"dataset-of-another-kind">("/" + key, id.value, kind_name(dataset->kind),
                                               kind_name(kind));
  }
}

core::Violations check_data(sql::Connection& db, const repository::EnvironmentQuery& data) {
  messages::Faults faults;
  check_choice(db, data.currents, "currents", DatasetKind::currents, faults);
  check_choice(db, data.tides.choice, "tides", DatasetKind::tides, faults);
  check_choice(db, data.wind, "wind", DatasetKind::wind, faults);
  check_choice(db, data.bathymetry, "bathymetry", DatasetKind::bathymetry, faults);
  check_choice(db, data.ice, "ice", DatasetKind::ice, faults);
  check_choice(db, data.icebergs, "icebergs", DatasetKind::icebergs, faults);
  check_choice(db, data.coastline, "coastline", DatasetKind::coastline, faults);
  check_choice(db, data.zones, "zones", DatasetKind::zones, faults);
  return faults.found();
}

tl::expected<json, core::Violations> checked_plan_inputs(const Context& context, const json& inputs) {
  const auto parsed = codec::parse_plan_inputs(inputs);
  if (!parsed) return tl::unexpected(parsed.error());
  auto violations = check_data(context.db, parsed->data);
  if (!violations.empty()) return tl::unexpected(std::move(violations));
  return codec::to_json(*parsed);
}

tl::expected<json, core::Violations> checked_evaluate_inputs(const Context& context, const json& inputs) {
  const auto parsed = codec::parse_evaluate_inputs(inputs);
  if (!parsed) return tl::unexpected(parsed.error());
  auto violations = check_data(context.db, parsed->data);
  if (parsed->plan_id && !repository::PlanRepository{context.db}.find({*parsed->plan_id})) {
    violations.push_back(messages::fault<"no-such-plan">("/plan_id", *parsed->plan_id));
  }
  if (!violations.empty()) return tl::unexpected(std::move(violations));
  return codec::to_json(*parsed);
}

tl::expected<json, core::Violations> checked_reach_inputs(const Context& context, const json& inputs) {
  const auto parsed = codec::parse_reach_inputs(inputs);
  if (!parsed) return tl::unexpected(parsed.error());
  auto violations = check_data(context.db, parsed->data);
  if (!violations.empty()) return tl::unexpected(std::move(violations));
  return codec::to_json(*parsed);
}

tl::expected<json, core::Violations> checked_ingest_inputs(const Context& context, const Request& request,
                                                           const json& inputs) {
  const auto parsed = codec::parse_ingest_inputs(inputs);
  if (!parsed) return tl::unexpected(parsed.error());
  const auto uploads = repository::uploads_of(context.db, context.service.uploads);
  messages::Faults faults;
  std::set<std::string> names;
  for (std::size_t i = 0; i < parsed->uploads.size() && !faults.is_full(); ++i) {
    const std::string pointer = "/uploads/" + std::to_string(i);
    const auto upload = uploads->find(parsed->uploads[i]);
    if (!upload || !may_see_of(request, upload->owner)) {
      faults.refuse<"no-such-upload">(pointer, parsed->uploads[i]);
    } else if (!names.insert(upload->name).second) {
      faults.refuse<"upload-of-the-same-name">(pointer, upload->name);
    }
  }
  if (!faults.found().empty()) return tl::unexpected(faults.found());
  return codec::to_json(*parsed);
}

tl::expected<json, core::Violations> checked_simulate_inputs(const Context& context, const json& inputs) {
  const auto parsed = codec::parse_simulate_inputs(inputs);
  if (!parsed) return tl::unexpected(parsed.error());
  if (!repository::PlanRepository{context.db}.find({parsed->plan_id}))
    return tl::unexpected(core::Violations{messages::fault<"no-such-plan">("/plan_id", parsed->plan_id)});
  return codec::to_json(*parsed);
}

tl::expected<json, core::Violations> checked_scenario_inputs(const Context&, const json& inputs) {
  const auto parsed = codec::parse_scenario_inputs(inputs);
  if (!parsed) return tl::unexpected(parsed.error());
  return codec::to_json(*parsed);
}

tl::expected<json, core::Violations> checked_compare_flight_inputs(const Context&, const json& inputs) {
  const auto parsed = codec::parse_compare_flight_inputs(inputs);
  if (!parsed) return tl::unexpected(parsed.error());
  return codec::to_json(*parsed);
}

tl::expected<json, core::Violations> checked_echo_inputs(const Context&, const json& inputs) {
  const auto parsed = codec::parse_echo_inputs(inputs);
  if (!parsed) return tl::unexpected(parsed.error());
  return codec::to_json(*parsed);
}

}  // namespace

tl::expected<json, core::Violations> checked_inputs(const Context& context, const Request& request,
                                                    const std::string& process, const json& inputs) {
  if (process == "plan-route") return checked_plan_inputs(context, inputs);
  if (process == "evaluate-route") return checked_evaluate_inputs(context, inputs);
  if (process == "reach") return checked_reach_inputs(context, inputs);
  if (process == "ingest") return checked_ingest_inputs(context, request, inputs);
  if (process == "simulate-plan") return checked_simulate_inputs(context, inputs);
  if (process == "fly-scenario") return checked_scenario_inputs(context, inputs);
  if (process == "compare-flight") return checked_compare_flight_inputs(context, inputs);
  if (process == "echo") return checked_echo_inputs(context, inputs);
  throw std::logic_error{"the process " + process + " is in the catalogue and has no check"};
}

std::string result_digest(const Context& context, const std::string& process,
                          const std::string& canonical_inputs) {
  return codec::sha256(std::string{core::version()} + "\n" + process + "\n" + canonical_inputs + "\n" +
                       repository::DatasetRepository{context.db}.contents());
}

bool result_stands(const Context& context, const repository::JobRecord& job) {
  if (!job.result_json) return true;  // not ended yet
  const json result = json::parse(*job.result_json);
  const auto id_of = [&](const char* output, const char* key) {
    return result.contains(output) ? result.at(output).value(key, "") : "";
  };
  const std::string plan = id_of("plan", "plan_id");
  const std::string simulation = id_of("simulation", "simulation_id");
  if (!plan.empty()) return repository::PlanRepository{context.db}.find({plan}).has_value();
  if (!simulation.empty()) return repository::SimulationRepository{context.db}.find({simulation}).has_value();
  return true;
}

}  // namespace floeplan::routes
