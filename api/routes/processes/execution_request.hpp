#pragma once

#include <string>
#include <tl/expected.hpp>

#include "api/routes/processes/process_catalogue.hpp"
#include "api/routes/request/message.hpp"
#include "storage/json/json.hpp"

namespace floeplan::routes {

/// The body of an execute request (OGC API - Processes, Part 1, 7.11.2).
struct ExecutionRequest {
  nlohmann::json inputs;   // bare, also where they came as {"value": ...}
  bool force{false};       // do the work again even where its result is there
  std::string reply_json;  // which outputs the client wants, in which form; kept with the job
};

/// Errors   the problem to answer with, with every fault of the body but those of its inputs
[[nodiscard]] tl::expected<ExecutionRequest, Response> read_execution(const Request& request,
                                                                      const ProcessEntry& process);

}  // namespace floeplan::routes
