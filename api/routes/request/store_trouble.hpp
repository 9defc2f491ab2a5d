#pragma once

#include <vector>

#include "api/routes/request/message.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/store/stored_things.hpp"
#include "storage/sql/driver/failure.hpp"

namespace floeplan::routes {

/// The response when the store fails. It tells the client that nothing was changed and whether to try again.
/// Details, such as the path of the store, are only for the log.
[[nodiscard]] Response store_trouble_reply(const Request& request, const sql::Failure& failure);

/// Adds the member "damaged" to a list: the names of entries that cannot be read. Nothing is added if there
/// are none.
void name_damaged(nlohmann::json& list, const std::vector<repository::StoredThing>& damaged);

}  // namespace floeplan::routes
