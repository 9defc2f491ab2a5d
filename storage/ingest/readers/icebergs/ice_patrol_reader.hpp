#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "storage/ingest/common/prepared_dataset.hpp"

namespace floeplan::ingest {

/// Whether a header line is that of the International Ice Patrol's sightings.
[[nodiscard]] bool is_ice_patrol_header(const std::string& line);

/// Sightings of the International Ice Patrol (NSIDC G00807): columns found by their names, dates M/D/YYYY
/// with HHMM UTC. A berg is named "<ice year>-<number>", since numbers begin anew each year. A bad row is
/// left out and counted.
/// Source   NSIDC G00807 user guide, "International Ice Patrol (IIP) Iceberg Sightings Database"
[[nodiscard]] Checked<PreparedDataset> read_ice_patrol_csv(const std::filesystem::path& file);

}  // namespace floeplan::ingest
