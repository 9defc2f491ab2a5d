#pragma once

#include "storage/repository/dataset.hpp"

namespace floeplan::repository {

/// The dataset of what people made of a kind over the service; there is one at most.
[[nodiscard]] inline DatasetId hand_made_id(DatasetKind kind) { return {kind_name(kind) + "-by-hand"}; }

}  // namespace floeplan::repository
