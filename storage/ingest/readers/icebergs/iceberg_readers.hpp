#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "storage/ingest/common/prepared_dataset.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Whether a header line is that of a table of the International Ice Patrol.
[[nodiscard]] bool is_ice_patrol_header(const std::string& line);

/// Sightings of the International Ice Patrol (NSIDC G00807). Columns are found by their names; dates are
/// M/D/YYYY with HHMM UTC. A berg is named "<ice year>-<number>", because numbers restart each year. A bad
/// row is skipped and counted.
/// Source   NSIDC G00807 user guide, "International Ice Patrol (IIP) Iceberg Sightings Database"
[[nodiscard]] Checked<PreparedDataset> read_ice_patrol_csv(const std::filesystem::path& file);

/// Whether a header line is that of a known table of icebergs, except the International Ice Patrol's.
[[nodiscard]] bool is_iceberg_table_header(const std::string& line);
/// Whether a JSON text begins like the list of iceberg positions of Brigham Young University (BYU).
[[nodiscard]] bool is_iceberg_list_json(std::string_view head);

/// Icebergs from a table; its columns show which one it is:
///  - the list of the US National Ice Center, with or without areas and remarks: lengths in nautical miles,
///    one position for each berg, dates M/D/YYYY. A berg that is grounded according to its remarks gets the
///    shape "grounded"
///  - a consolidated track of BYU and the Ice Center: one berg, named by the file; days YYYYDDD; for each
///    sensor latitude, longitude and whether the berg was seen (1) or the position interpolated (0); all zero
///    if missing. A day gives one sighting: seen before interpolated, then in the order of the sensors. A
///    size applies until the next one is stated
///  - a track of a beacon of the Canadian Ice Service: times with their zone, and the class of the Argos
///    position
/// A bad row is skipped and counted.
/// Source   accuracy of Argos classes 3, 2 and 1: Argos User's Manual (CLS), 250, 500 and 1500 m; worse
///          classes, which are less accurate than 1500 m, count as 1500 m
[[nodiscard]] Checked<PreparedDataset> read_iceberg_table(const std::filesystem::path& file);

/// BYU's list of current positions: degrees and minutes as text, dates MM/DD/YY. It states no sizes. The US
/// National Ice Center names its bergs, which are at least 10 nautical miles long, and this length is used.
[[nodiscard]] Checked<PreparedDataset> read_iceberg_list_json(const std::filesystem::path& file);

/// Whether the first line names the columns of a user's own table of icebergs: an identifier, latitude,
/// longitude and the time of the sighting. Tracks of ships and gliders have these columns too. So, unless the
/// user has `stated` that the file holds icebergs, there must be a length, draft or size, an identifier with
/// "berg" in its name, or no columns other than an id and those of a sighting.
[[nodiscard]] bool is_own_iceberg_table_header(std::string_view line, bool stated);

/// Icebergs from a table whose columns have the names of the GeoJSON properties. Fields are separated by
/// commas, semicolons or tabs. A bad row is skipped and counted.
///  id        required; also name, berg, iceberg, berg_id, iceberg_id
///  lat, lon  required, degrees; also latitude, long, longitude
///  observed  required: a day, or ISO 8601 with its zone; also time, timestamp, datetime, date, last_seen. A
///            time in a column whose name ends in "_utc" needs no zone
///  length_m, draft_m, size, shape, method  optional; lengths also in other units of length_factor
///            (length_ft, length_km) and in nautical miles (_nm)
///  position_uncertainty_m  optional; also other names that PositionErrors knows
[[nodiscard]] Checked<PreparedDataset> read_own_iceberg_table(const std::filesystem::path& file);

/// Icebergs from features, GeoJSON or another vector file: points or outlines. The position of an outline is
/// the middle of its box; its length, if not stated, is twice the distance from there to the farthest corner.
/// Projected layers are converted to degrees. Properties: `id` or `name`; `observed`, `time`, `timestamp`,
/// `begin` or `date` (ISO 8601 with a zone, a field of type time with a zone, or a day, which counts from its
/// beginning); optional `length_m`, `draft_m`, `position_uncertainty_m` (or other names that PositionErrors
/// knows), `size` (growler, bergy_bit, small, medium, large, very_large, unknown, radar_target), `shape`,
/// `method`. A bad feature is skipped and counted.
[[nodiscard]] Checked<PreparedDataset> read_geojson_icebergs(GDALDataset& dataset);

}  // namespace floeplan::ingest
