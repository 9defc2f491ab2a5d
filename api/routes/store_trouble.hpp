#pragma once

#include "api/routes/message.hpp"
#include "storage/sqlite/failure.hpp"

namespace floeplan::routes {

/// What a client is told when the store does not do its part: that nothing of the request was done, and whether to come
/// again. Where the store lies, and the rest of what the failure says, is for the log alone.
[[nodiscard]] Response store_trouble_reply(const Request& request, const sqlite::Failure& failure);

}  // namespace floeplan::routes
