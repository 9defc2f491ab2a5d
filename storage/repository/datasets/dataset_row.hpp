#pragma once

#include <cstdint>
#include <optional>

#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// The row number by which other tables refer to a dataset; nullopt if there is no such dataset.
[[nodiscard]] std::optional<std::int64_t> find_dataset_row(sql::Connection& db, const DatasetId& id);

/// The row number of a dataset that must exist, because its data are being written.
/// Errors  std::invalid_argument when the dataset is not in the list
[[nodiscard]] std::int64_t dataset_row(sql::Connection& db, const DatasetId& id);

}  // namespace floeplan::repository
