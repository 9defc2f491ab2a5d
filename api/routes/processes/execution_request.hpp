#pragma once

#include <string>
#include <tl/expected.hpp>

#include "api/routes/processes/process_catalogue.hpp"
#include "api/routes/request/message.hpp"
#include "storage/json/json.hpp"

namespace floeplan::routes {

/// The body of an execute request (OGC API - Processes, Part 1, 7.11.2).
struct ExecutionRequest {
  nlohmann::json inputs;   // the values, also if they were given as {"value": ...}
  bool force{false};       // do the work even if its result exists
  std::string reply_json;  // outputs and their form as requested; stored with the job
};

/// Errors   the problem for the answer, with all faults of the body except those of its inputs
[[nodiscard]] tl::expected<ExecutionRequest, Response> read_execution(const Request& request,
                                                                      const ProcessEntry& process);

}  // namespace floeplan::routes
