#pragma once

#include <cstdint>
#include <optional>

#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// The number by which the other tables refer to a dataset.
[[nodiscard]] std::optional<std::int64_t> find_dataset_row(sql::Connection& db, const DatasetId& id);

/// The same where data are to be written.
/// Errors  std::invalid_argument when the dataset is not in the list yet
[[nodiscard]] std::int64_t dataset_row(sql::Connection& db, const DatasetId& id);

}  // namespace floeplan::repository
