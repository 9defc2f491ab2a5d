#pragma once

#include <filesystem>
#include <string_view>

#include "storage/ingest/common/prepared_dataset.hpp"

namespace floeplan::ingest {

/// Whether the first line names the columns of somebody's own table of icebergs: what identifies a berg, its latitude,
/// its longitude and when it was seen. Tracks of ships and gliders have these, too: unless the user has `stated` that the
/// file holds icebergs, there has to be a length, draft or size, or an identifier called a berg's, or no column but an
/// id and those of a sighting.
[[nodiscard]] bool is_own_iceberg_table_header(std::string_view line, bool stated);

/// Icebergs out of a table with the columns that a GeoJSON point has as properties:
///  id (name, berg, iceberg, berg_id, iceberg_id)                 required
///  lat (latitude), lon (long, longitude)                         required, degrees
///  observed (time, timestamp, datetime, date, last_seen)         required; ISO 8601 with its zone or a day alone;
///  times in
///                                                                a column whose name ends in "_utc" may leave it out
///  length_m, draft_m, size, shape, method                       optional; lengths also in other units of length_factor
///                                                                (length_ft, length_km) and in nautical miles (_nm)
///  position_uncertainty_m                                        optional; all that PositionErrors understands
/// Fields are parted by commas, semicolons or tabs. A bad row is left out and counted.
[[nodiscard]] Checked<PreparedDataset> read_own_iceberg_table(const std::filesystem::path& file);

}  // namespace floeplan::ingest
