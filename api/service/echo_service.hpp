#pragma once

#include <stop_token>

#include "api/codec/inputs/echo_inputs.hpp"
#include "engine/core/progress.hpp"
#include "storage/json/json.hpp"

namespace floeplan::service {

/// Returns each input under its name, after the requested pause.
/// Stops    the pause ends on `stop`
[[nodiscard]] nlohmann::json echo_results(const codec::EchoInputs& inputs, const std::stop_token& stop,
                                          const core::ProgressCallback& progress);

}  // namespace floeplan::service
