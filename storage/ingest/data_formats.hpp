#pragma once

#include <vector>

#include "storage/ingest/data_format.hpp"

namespace floeplan::ingest {

/// All formats that this program reads: the one table that recognition, dispatch to the readers, the warning of a line
/// without an end, `floeplan formats` and the guide use. Of the formats that are written alike the first row that says it
/// is it counts.
[[nodiscard]] const std::vector<DataFormat>& data_formats();

}  // namespace floeplan::ingest
