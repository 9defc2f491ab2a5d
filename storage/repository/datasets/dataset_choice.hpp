#pragma once

#include <string>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/bounding_box.hpp"
#include "storage/repository/datasets/dataset.hpp"

namespace floeplan::repository {

/// Which dataset of a kind to use. Without a word: the newest, of zones all that there are.
struct DatasetChoice {
  enum class How { newest, none, named } how{How::newest};
  std::vector<DatasetId> ids;  // when named
};

/// The datasets that a choice leaves: those named, in the order they were named, or all of the kind that
/// meet the area, in the order of `stored` (newest first); those with steps of time the newest model run first.
/// Errors  adds a violation for each named one that does not exist, is of another kind or shares nothing
///         with the area; the field is "/<kind>"
[[nodiscard]] std::vector<Dataset> candidates(const std::vector<Dataset>& stored, DatasetKind kind,
                                              const DatasetChoice& choice, const geo::BoundingBox& area,
                                              core::Violations& violations);

/// "Disko Bay model (currents-0123abcd)": how messages name a dataset.
[[nodiscard]] std::string title(const Dataset& dataset);

}  // namespace floeplan::repository
