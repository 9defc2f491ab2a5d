#pragma once

#include <filesystem>
#include <vector>

#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Copies every dataset of the store in `folder` that this store does not have, with all its data. A dataset
/// that is outdated here but not there is replaced. All appear together at the end; others can write to this
/// store while large data are copied. The other store has the same schema and is not changed. Incomplete data
/// of a process that died while copying are removed after an hour.
/// Returns  the ids of the copied datasets
/// Errors   sql::Failure when either store fails; this store is then unchanged
std::vector<DatasetId> take_over_datasets(sql::Connection& db, const std::filesystem::path& folder);

}  // namespace floeplan::repository
