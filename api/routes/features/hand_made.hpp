#pragma once

#include <string>

#include "api/routes/features/feature_collection.hpp"
#include "storage/repository/datasets/dataset.hpp"

namespace floeplan::routes {

/// Features that users enter over the service are one dataset for each kind (icebergs, zones). Plans obey it
/// together with ingested datasets, and cite it with a digest of its content at the time.

/// The id of this dataset, which is created if it does not exist.
[[nodiscard]] repository::DatasetId hand_made_dataset(sql::Connection& db, repository::DatasetKind kind,
                                                      core::UtcTime now);
/// Updates the dataset's bounds, period and digest after a change; removes the dataset if it is empty.
void refresh_hand_made(sql::Connection& db, repository::DatasetKind kind, core::UtcTime now);

/// Why features of a dataset cannot be changed (they come from a file); empty if they can.
[[nodiscard]] std::string objection_to_editing(const repository::DatasetId& dataset);

/// Box and period of all datasets of a kind; the whole world if there are none.
[[nodiscard]] FeatureExtent extent_of_kind(sql::Connection& db, repository::DatasetKind kind);

}  // namespace floeplan::routes
