#pragma once

#include <filesystem>
#include <vector>

#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Takes over every dataset that the store in `folder` holds and this one does not, with all its data; one that is
/// outdated here and not there is replaced. They show up together at the end; others can write to this store while large data are copied. The other store has the same schema
/// and is left as it is. What a process left behind that died while it copied is removed after an hour.
/// Returns  the ids of what was taken over
/// Errors   sql::Failure when either store fails; this one is then as it was
std::vector<DatasetId> take_over_datasets(sql::Connection& db, const std::filesystem::path& folder);

}  // namespace floeplan::repository
