#pragma once

#include <vector>

#include "storage/ingest/data_format.hpp"

namespace floeplan::ingest {

/// All formats that this program reads: the one table for recognition, for the choice of the reader, for the
/// warning about a last line without an end, for `floeplan formats` and for the guide. Rows with the same
/// kind of encoding are asked in this order; the first that recognises the file is its format.
[[nodiscard]] const std::vector<DataFormat>& data_formats();

}  // namespace floeplan::ingest
