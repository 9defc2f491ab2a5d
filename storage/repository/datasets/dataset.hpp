#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/bounding_box.hpp"

namespace floeplan::repository {

/// Kinds of data in the store.
enum class DatasetKind {
  bathymetry,
  currents,
  wind,
  ice,
  icebergs,
  coastline,
  tides,
  water_levels,
  zones,
  glider_tracks
};

[[nodiscard]] std::string kind_name(DatasetKind kind);
[[nodiscard]] std::optional<DatasetKind> parse_kind(const std::string& name);
/// A count of rows of a dataset, in words: "1 sighting", "276480 grid nodes".
[[nodiscard]] std::string rows_text(DatasetKind kind, std::int64_t count);

/// Whether data of the kind are fields at time steps.
[[nodiscard]] bool has_steps(DatasetKind kind);

/// Identifies a dataset: "<kind>-<eight hexadecimal digits of the SHA-256 of its file and of the options that
/// it was read with>".
struct DatasetId {
  std::string value;

  friend auto operator<=>(const DatasetId&, const DatasetId&) = default;
};

/// Origin of the data.
struct Provenance {
  std::string file_name;  // the last component only
  std::int64_t file_size_bytes{};
  std::string sha256;  // lower-case hexadecimal
  core::UtcTime ingested;
  std::string tool_version;  // "floeplan 0.1.0, GDAL 3.6.2"
};

/// An entry in the list of datasets. The data themselves are in the repositories of fields, icebergs, coasts,
/// zones and tracks.
struct Dataset {
  DatasetId id;
  DatasetKind kind{};
  std::string name;                    // given by the user, or the file's name without its ending
  std::vector<std::string> variables;  // as the file names them
  geo::BoundingBox bounds;
  std::optional<core::UtcTime> time_start;  // empty: data without time
  std::optional<core::UtcTime> time_end;
  std::optional<core::UtcTime> run{};  // start of the model run; empty: unknown
  std::int64_t rows_accepted{};        // grid nodes, sightings, polygons, zones or points
  std::int64_t rows_refused{};
  std::vector<std::string> warnings;
  Provenance provenance;
  bool outdated{false};  // an earlier program misread the file; ingesting it again replaces the data
};

/// Sorts datasets by precedence: the newest model run first. If a file does not state its run, its time of
/// ingestion counts. Among files of the same command, which have the same time of ingestion: the latest begin
/// of the data, then the latest end, then data that no older version resampled (`was_resampled`), then the
/// latest time of ingestion (the same file read with other options), then the id.
void sort_newest_run_first(std::vector<Dataset>& datasets);

/// What to do about a dataset that an earlier version misread or resampled.
struct StaleMark {
  std::string text;
  std::optional<DatasetId>
      better;  // that has the values of the same file at its own points; empty: not stored yet
};

/// nullopt: the dataset is as this version reads its file.
/// `all`  the stored datasets
[[nodiscard]] std::optional<StaleMark> stale_mark(const Dataset& dataset, std::span<const Dataset> all);

/// The dataset of the objects of a kind that users entered over the service; there is at most one.
[[nodiscard]] inline DatasetId hand_made_id(DatasetKind kind) { return {kind_name(kind) + "-by-hand"}; }

}  // namespace floeplan::repository
