#pragma once

#include <string>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/bounding_box.hpp"
#include "storage/repository/datasets/dataset.hpp"

namespace floeplan::repository {

/// Which datasets of a kind to use. Default: the newest; for zones all of them.
struct DatasetChoice {
  enum class How { newest, none, named } how{How::newest};
  std::vector<DatasetId> ids;  // used with How::named
};

/// The datasets that a choice allows: those named, in the given order; or all of the kind that intersect the
/// area, in the order of `stored` (newest first), but kinds with time steps by the newest model run.
/// Errors  adds a violation for each named dataset that does not exist, is of another kind or does not
///         intersect the area; the field is "/<kind>"
[[nodiscard]] std::vector<Dataset> candidates(const std::vector<Dataset>& stored, DatasetKind kind,
                                              const DatasetChoice& choice, const geo::BoundingBox& area,
                                              core::Violations& violations);

/// The name of a dataset in messages: "Disko Bay model (currents-0123abcd)".
[[nodiscard]] std::string title(const Dataset& dataset);

}  // namespace floeplan::repository
