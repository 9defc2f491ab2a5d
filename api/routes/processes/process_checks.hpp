#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "api/routes/request/context.hpp"
#include "api/routes/request/message.hpp"
#include "engine/core/violation.hpp"
#include "storage/json/json.hpp"

namespace floeplan::routes {

/// The inputs of a process of the catalogue in canonical form, ready for the queue: read, and checked against what is
/// stored. Of uploads those alone are there that the caller may see.
/// Errors   every violation, with its JSON pointer inside the inputs
[[nodiscard]] tl::expected<nlohmann::json, core::Violations> checked_inputs(const Context& context,
                                                                            const Request& request,
                                                                            const std::string& process,
                                                                            const nlohmann::json& inputs);

/// Digest of everything that the result of a process follows from: the version, the inputs in canonical form and the
/// stored data.
[[nodiscard]] std::string result_digest(const Context& context, const std::string& process,
                                        const std::string& canonical_inputs);

/// Whether what a finished job made is still there: a plan may have been removed since.
[[nodiscard]] bool result_stands(const Context& context, const repository::JobRecord& job);

}  // namespace floeplan::routes
