#pragma once

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// The faults of a file for a refusal: of more than fifty only the first, and the number of the others.
[[nodiscard]] Messages report_of(Messages faults);

}  // namespace floeplan::ingest
