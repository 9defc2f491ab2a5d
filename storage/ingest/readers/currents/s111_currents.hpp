#pragma once

#include <filesystem>

#include "engine/core/progress.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"

namespace floeplan::ingest {

/// Surface currents of IHO S-111 on a regular grid, at separate places or on a triangulated mesh: a speed, and the
/// direction towards which the water goes.
/// Depth    as the file says: that of the currents below the surface, or the middle of the layer that they are means of
/// Errors   as s100_coverage and s100_points; no time of a record; a unit that is no speed; a height above the sea bed
/// Source   IHO S-111 edition 2.0.0, clause 12 with table 12-11, and edition 1.0.1, table 12.1
[[nodiscard]] Checked<PreparedDataset> read_s111_currents(const std::filesystem::path& file,
                                                          const core::ProgressCallback& progress);

}  // namespace floeplan::ingest
