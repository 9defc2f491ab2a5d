#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <stop_token>

#include "api/codec/inputs/scenario_inputs.hpp"
#include "engine/core/progress.hpp"

namespace floeplan::service {

/// One function for API and command line: flies so many seas full of icebergs that the plan does not know
/// (simulation::random_icebergs), each with a seed of its own; stores nothing.
/// Returns  how the flights ended, a row for each, and their statistics; the same with any number of workers. With the
///          system on board, collisions that full knowledge could not have prevented are counted apart (`beyond_help`),
///          and each run that gave up tells why and whether it arrives in the same water without icebergs;
///          {"status": "cancelled"} when `stop` was requested meanwhile
[[nodiscard]] nlohmann::json fly_scenario_document(const codec::ScenarioInputs& asked, std::size_t workers,
                                                   const std::stop_token& stop,
                                                   const core::ProgressCallback& progress);

}  // namespace floeplan::service
