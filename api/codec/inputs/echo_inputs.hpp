#pragma once

#include <tl/expected.hpp>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {

/// Inputs of the process "echo", which returns them. For tests of clients.
struct EchoInputs {
  nlohmann::json values;  // the inputs by their names, in the form in which they are returned
  core::Seconds pause{0.0};
};

/// A value may be given alone or as {"value": ...}, as OGC API - Processes allows.
/// Errors   every violation, with its JSON pointer
[[nodiscard]] tl::expected<EchoInputs, core::Violations> parse_echo_inputs(const nlohmann::json& inputs);
[[nodiscard]] nlohmann::json to_json(const EchoInputs& inputs);

}  // namespace floeplan::codec
