#pragma once

#include <vector>

#include "api/routes/request/message.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/store/stored_things.hpp"
#include "storage/sql/driver/failure.hpp"

namespace floeplan::routes {

/// What a client is told when the store does not do its part: that nothing of the request was done, and whether to come
/// again. Where the store lies, and the rest of what the failure says, is for the log alone.
[[nodiscard]] Response store_trouble_reply(const Request& request, const sql::Failure& failure);

/// Names in a list, as its member "damaged", what it lacks because it cannot be read; a list that lacks nothing has no such
/// member.
void name_damaged(nlohmann::json& list, const std::vector<repository::StoredThing>& damaged);

}  // namespace floeplan::routes
