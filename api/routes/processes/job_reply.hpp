#pragma once

#include <string>

#include "api/routes/request/context.hpp"
#include "api/routes/request/message.hpp"
#include "storage/repository/work/job_repository.hpp"

namespace floeplan::routes {

/// The results document of a job, or the problem that explains why there is none.
[[nodiscard]] Response results_reply(const Request& request, const repository::JobRecord& job);

/// A response that makes the server call the handler again, with `token`, when the job changes or the time is
/// up.
[[nodiscard]] Response waiting_for(const Context& context, const repository::JobId& id,
                                   const std::string& token, core::Seconds at_most);

}  // namespace floeplan::routes
