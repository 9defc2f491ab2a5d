#pragma once

#include <string>

#include "api/routes/features/feature_collection.hpp"
#include "storage/repository/datasets/dataset.hpp"

namespace floeplan::routes {

/// Features that people make over the service are a dataset of their own for each kind (icebergs, zones), which plans
/// obey beside those that were ingested, and cite with a digest of what it held.

/// Its id; it is made when it is not there yet.
[[nodiscard]] repository::DatasetId hand_made_dataset(sql::Connection& db, repository::DatasetKind kind,
                                                      core::UtcTime now);
/// States its bounds, period and digest anew after a change; removes it when nothing is left in it.
void refresh_hand_made(sql::Connection& db, repository::DatasetKind kind, core::UtcTime now);

/// Why features of the dataset cannot be changed: they are what a file says. Empty: they can.
[[nodiscard]] std::string objection_to_editing(const repository::DatasetId& dataset);

/// Box and period of all datasets of a kind; the whole world when there are none.
[[nodiscard]] FeatureExtent extent_of_kind(sql::Connection& db, repository::DatasetKind kind);

}  // namespace floeplan::routes
