#pragma once

#include <filesystem>

#include "storage/ingest/common/prepared_dataset.hpp"

namespace floeplan::ingest {

/// Depths of IHO S-102, positive down, with the uncertainty of each: the bed may lie as much higher.
/// Errors   as s100_coverage; a unit that is no length
/// Source   IHO S-102 edition 3.0.0, tables 10-2 to 10-8
[[nodiscard]] Checked<PreparedDataset> read_s102_bathymetry(const std::filesystem::path& file);

}  // namespace floeplan::ingest
