#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/bounding_box.hpp"

namespace floeplan::repository {

/// Kinds of data the store holds.
enum class DatasetKind { bathymetry, currents, wind, ice, icebergs, coastline, tides, zones, glider_tracks };

[[nodiscard]] std::string kind_name(DatasetKind kind);
[[nodiscard]] std::optional<DatasetKind> parse_kind(const std::string& name);

/// Whether data of the kind are fields at steps of time.
[[nodiscard]] bool has_steps(DatasetKind kind);

/// Names one dataset: "<kind>-<eight hexadecimal digits of the SHA-256 of its file, and of the options that it was read with>".
struct DatasetId {
  std::string value;

  friend auto operator<=>(const DatasetId&, const DatasetId&) = default;
};

/// Where the data came from.
struct Provenance {
  std::string file_name;  // the last component only
  std::int64_t file_size_bytes{};
  std::string sha256;  // lower-case hexadecimal
  core::UtcTime ingested;
  std::string tool_version;  // "floeplan 0.1.0, GDAL 3.6.2"
};

/// What a list of datasets shows; the data themselves are in the repositories of fields, icebergs, coasts,
/// zones and tracks.
struct Dataset {
  DatasetId id;
  DatasetKind kind{};
  std::string name;                    // the user's, or the file's name without its ending
  std::vector<std::string> variables;  // as the file names them
  geo::BoundingBox bounds;
  std::optional<core::UtcTime> time_start;  // empty: the data have no time
  std::optional<core::UtcTime> time_end;
  std::optional<core::UtcTime>
      run{};                     // when the model run began that made the data; empty: the file does not say
  std::int64_t rows_accepted{};  // grid nodes, sightings, polygons, zones or points
  std::int64_t rows_refused{};
  std::vector<std::string> warnings;
  Provenance provenance;
  bool outdated{false};  // misread by an earlier program: the same file, given again, replaces it
};

/// The order in which datasets win: the model run that began last first. A file that does not state its run counts as
/// run when it was ingested. Of several files of one command, which are ingested at the same time, that whose data begin
/// last, then that whose data end last; then that which no older version resampled (`was_resampled`), then that which was
/// ingested last, as the same file read with other options; ties by id.
void sort_newest_run_first(std::vector<Dataset>& datasets);

/// The dataset of what people made of a kind over the service; there is one at most.
[[nodiscard]] inline DatasetId hand_made_id(DatasetKind kind) { return {kind_name(kind) + "-by-hand"}; }

}  // namespace floeplan::repository
