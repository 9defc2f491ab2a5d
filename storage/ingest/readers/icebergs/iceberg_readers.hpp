#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "storage/ingest/common/prepared_dataset.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Whether a header line is that of the International Ice Patrol's sightings.
[[nodiscard]] bool is_ice_patrol_header(const std::string& line);

/// Sightings of the International Ice Patrol (NSIDC G00807): columns found by their names, dates M/D/YYYY
/// with HHMM UTC. A berg is named "<ice year>-<number>", since numbers begin anew each year. A bad row is
/// left out and counted.
/// Source   NSIDC G00807 user guide, "International Ice Patrol (IIP) Iceberg Sightings Database"
[[nodiscard]] Checked<PreparedDataset> read_ice_patrol_csv(const std::filesystem::path& file);

/// Whether a header line is that of a table of icebergs other than the International Ice Patrol's.
[[nodiscard]] bool is_iceberg_table_header(const std::string& line);
/// Whether a JSON text begins like the list of positions of Brigham Young University (BYU).
[[nodiscard]] bool is_iceberg_list_json(std::string_view head);

/// Icebergs out of a table, told by its columns:
///  - the list of the US National Ice Center, with and without areas and remarks: lengths in nautical miles, one
///  position
///    for each berg, dates M/D/YYYY. A berg that its remarks call grounded has the shape "grounded"
///  - a consolidated track of BYU and the Ice Center: one berg, named by the file; days YYYYDDD; for each sensor
///  latitude,
///    longitude and whether it was seen (1) or interpolated (0), all zero where missing. A day makes one sighting: seen
///    before interpolated, then in the order of the sensors. A size holds until the next one is stated
///  - a beacon's track of the Canadian Ice Service: times with their zone, and the class of the Argos position
/// A bad row is left out and counted.
/// Source   accuracy of Argos classes 3, 2 and 1: Argos User's Manual (CLS), 250, 500 and 1500 m; worse ones count as
///          1500 m, the least they can be
[[nodiscard]] Checked<PreparedDataset> read_iceberg_table(const std::filesystem::path& file);

/// The list of current positions of BYU: degrees and minutes as text, dates MM/DD/YY. It states no sizes; its bergs are
/// those that the US National Ice Center names, at least 10 nautical miles long, and are taken to be that long.
[[nodiscard]] Checked<PreparedDataset> read_iceberg_list_json(const std::filesystem::path& file);

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

/// Icebergs from features, GeoJSON or another vector file: points, or outlines, whose place is the middle of their box
/// and whose length, where none is stated, is twice the way from there to the farthest corner. Layers in a projection
/// are turned into degrees. Properties: `id` or `name`; `observed`, `time`, `timestamp`, `begin` or `date` (ISO 8601
/// with a zone, a time with a zone as the file keeps it, or a day, which counts from its beginning); optional
/// `length_m`, `draft_m`, `position_uncertainty_m` (or what else PositionErrors understands), `size` (growler, bergy_bit, small, medium, large, very_large,
/// unknown, radar_target), `shape`, `method`. A bad feature is left out and counted.
[[nodiscard]] Checked<PreparedDataset> read_geojson_icebergs(GDALDataset& dataset);

}  // namespace floeplan::ingest
