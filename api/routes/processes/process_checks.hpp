#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "api/routes/request/context.hpp"
#include "api/routes/request/message.hpp"
#include "engine/core/violation.hpp"
#include "storage/json/json.hpp"

namespace floeplan::routes {

/// The inputs of a process in canonical form for the queue. They are parsed and checked against the store;
/// uploads that the caller may not see count as missing.
/// Errors   all violations, with their JSON pointers inside the inputs
[[nodiscard]] tl::expected<nlohmann::json, core::Violations> checked_inputs(const Context& context,
                                                                            const Request& request,
                                                                            const std::string& process,
                                                                            const nlohmann::json& inputs);

/// Digest of everything that determines the result of a process: the version, the inputs in canonical form
/// and the stored data.
[[nodiscard]] std::string result_digest(const Context& context, const std::string& process,
                                        const std::string& canonical_inputs);

/// Whether the result of a finished job still exists; its plan may have been removed.
[[nodiscard]] bool result_stands(const Context& context, const repository::JobRecord& job);

}  // namespace floeplan::routes
