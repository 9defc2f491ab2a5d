#pragma once

#include <filesystem>

#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// Bathymetry from a cell of an electronic chart (S-57 ENC), with its updates, on a grid of half a millimetre at the
/// chart's scale: at each node the middle of its depth area, and beside it the least depth that anything charted in the
/// cell may have. Outside the cell's coverage and where the chart gives no depth area nothing is known.
/// Errors   as read_s57_cell; a coverage of more nodes than this program accepts
[[nodiscard]] Checked<PreparedDataset> read_s57_bathymetry(const std::filesystem::path& base);

}  // namespace floeplan::ingest
