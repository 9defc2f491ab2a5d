#include "api/service/reach_service.hpp"

#include <chrono>
#include <utility>

#include "api/codec/documents/plan_document.hpp"
#include "api/codec/documents/reach_document.hpp"
#include "api/service/coverage_checks.hpp"
#include "engine/messages/plan_messages.hpp"
#include "engine/planning/find_isochrones.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/environment/environment_loader.hpp"

namespace floeplan::service {

tl::expected<nlohmann::json, core::Violations> reach_document(sql::Connection& db,
                                                              const codec::ReachInputs& inputs,
                                                              const std::stop_token& stop,
                                                              const core::ProgressCallback& progress,
                                                              KeptWork* kept) {
  if (progress) progress("loading data", 0.0);
  const bool from = inputs.request.direction == planning::IsochroneRequest::Direction::from;
  if (auto swapped = swapped_places(db, {{from ? "from" : "to", inputs.request.place}}, inputs.data);
      !swapped.empty())
    return tl::unexpected(std::move(swapped));
  if (auto elsewhere = depths_elsewhere(db, inputs.data); !elsewhere.empty())
    return tl::unexpected(std::move(elsewhere));
  const auto environment =
      repository::load_environment(db, inputs.data, {stop, kept != nullptr ? &kept->currents : nullptr});
  if (!environment) return tl::unexpected(environment.error());

  const auto begin = std::chrono::steady_clock::now();
  auto reach = planning::find_isochrones(*environment, inputs.request, stop, progress);
  if (!reach) return codec::infeasible_document(reach.error(), *environment);
  for (const std::string& remark : inputs.warnings)
    reach->messages.push_back(messages::plan_message<"remark">(remark));
  reach->search.duration = std::chrono::steady_clock::now() - begin;
  return codec::reach_document(*reach, inputs.request, inputs.name);
}

}  // namespace floeplan::service
