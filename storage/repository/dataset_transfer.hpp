#pragma once

#include <filesystem>
#include <vector>

#include "storage/repository/dataset.hpp"
#include "storage/sqlite/connection.hpp"

namespace floeplan::repository {

/// Takes over every dataset that the store in `folder` holds and this one does not, with all its data, in one
/// transaction. The other store has the same schema and is left as it is.
/// Returns  the ids of what was taken over
/// Errors   sqlite::Failure when either store fails; this one is then as it was
std::vector<DatasetId> take_over_datasets(sqlite::Connection& db, const std::filesystem::path& folder);

}  // namespace floeplan::repository
