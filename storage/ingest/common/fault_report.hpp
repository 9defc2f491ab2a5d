#pragma once

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// The faults of a file as a refusal tells them: of a great many the first, and how many more.
[[nodiscard]] Messages report_of(Messages faults);

}  // namespace floeplan::ingest
