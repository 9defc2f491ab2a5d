#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/core/progress.hpp"
#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// Harmonic constants of a tide model on a grid, elevations and currents, in the first of the files. Transports are
/// divided by the depth of the water column, there or in another of the files; components between the nodes (C-grid)
/// are brought to the nodes of the elevations.
/// Errors   see the refusals of find_tides, tide_layout_of and tide_names; a constituent that this program does not
///          know; transports without depths; elevations over 20 m or currents over 10 m/s; nothing but missing values
[[nodiscard]] Checked<PreparedDataset> read_tides(const NetcdfFiles& files, const std::filesystem::path& path,
                                                  const IngestOptions& options,
                                                  const core::ProgressCallback& progress);

/// Whether the beginning of a text file is that of harmonic constants: JSON of NOAA's stations (with
/// harmonic_constituents or HarmonicConstituents), a table with columns of names, amplitudes and phases, or what OTPS
/// extracts from a model.
[[nodiscard]] bool is_tide_json(std::string_view head);
[[nodiscard]] bool is_tide_table(std::string_view head);
[[nodiscard]] bool is_otps_extract(std::string_view head);

/// Harmonic constants of stations, elevations only. A list without a place needs --at; one without a unit --unit.
/// Phases are behind Greenwich; a stated speed has to be that of the constituent within 0.001 degrees an hour.
/// Errors   no constituent, an amplitude over 20 m, a speed that belongs to another constituent, no place or no unit
[[nodiscard]] Checked<PreparedDataset> read_tide_json(const std::filesystem::path& file,
                                                      const IngestOptions& options);
[[nodiscard]] Checked<PreparedDataset> read_tide_table(const std::filesystem::path& file,
                                                       const IngestOptions& options);
[[nodiscard]] Checked<PreparedDataset> read_otps_extract(const std::filesystem::path& file);

/// The stations of a TCD file (XTide, TICON) that have harmonic constants of the water level, phases turned from their
/// zone's standard time to Greenwich: g = epoch - speed * zone. Stations of tidal currents, and those that are stated as
/// differences from another, are left out and counted, as are constituents that are unknown or have another speed.
/// Errors   no station left; an amplitude over 20 m; a place that is not on the Earth; damage
/// Source   libtcd.html of libtcd 2.2.2, zone_offset: "the standard time to which epochs are adjusted"
[[nodiscard]] Checked<PreparedDataset> read_tcd_stations(const std::filesystem::path& file);

}  // namespace floeplan::ingest
