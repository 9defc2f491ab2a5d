#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/core/progress.hpp"
#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// Harmonic constants of a tide model on a grid: elevations and currents of the first file. Transports are
/// divided by the depth of the water column, from this file or another one. Components between the nodes (C
/// grid) are interpolated to the nodes of the elevations.
/// Errors   those of find_tides, tide_layout_of and tide_names; a constituent that this program does not
///          know; transports without depths; elevations over 20 m or currents over 10 m/s; nothing but missing values
[[nodiscard]] Checked<PreparedDataset> read_tides(const NetcdfFiles& files, const std::filesystem::path& path,
                                                  const IngestOptions& options,
                                                  const core::ProgressCallback& progress);

/// Whether a text file begins like one of harmonic constants: JSON of NOAA's stations (with
/// harmonic_constituents or HarmonicConstituents), a table with columns for names, amplitudes and phases, or
/// an extract from a model by OTPS.
[[nodiscard]] bool is_tide_json(std::string_view head);
[[nodiscard]] bool is_tide_table(std::string_view head);
[[nodiscard]] bool is_otps_extract(std::string_view head);

/// Harmonic constants of stations, elevations only. A list without a position needs --at; one without a unit
/// needs --unit. Phases are lags at Greenwich; a stated speed must be that of the constituent within 0.001
/// degrees per hour.
/// Errors   no constituent, an amplitude over 20 m, a speed that belongs to another constituent, no place or no unit
[[nodiscard]] Checked<PreparedDataset> read_tide_json(const std::filesystem::path& file,
                                                      const IngestOptions& options);
[[nodiscard]] Checked<PreparedDataset> read_tide_table(const std::filesystem::path& file,
                                                       const IngestOptions& options);
[[nodiscard]] Checked<PreparedDataset> read_otps_extract(const std::filesystem::path& file);

/// The stations of a TCD file (XTide, TICON) with harmonic constants of the water level. Phases are converted
/// from the zone's standard time to Greenwich: g = epoch - speed * zone. Ignored and counted: stations of
/// tidal currents, stations given as differences from another, and constituents that are unknown or have
/// another speed.
/// Errors   no station is left; an amplitude over 20 m; a position that is not on the Earth; damage
/// Source   libtcd.html of libtcd 2.2.2, zone_offset: "the standard time to which epochs are adjusted"
[[nodiscard]] Checked<PreparedDataset> read_tcd_stations(const std::filesystem::path& file);

/// Water levels of IHO S-104 over time: on a regular grid (data coding format 2), at separate places or on a triangulated
/// mesh (3 and 7), or at fixed stations (1 and 8).
/// Sign    heights of the sea surface above the file's vertical datum, upwards; a file whose vertical axis is another is
///         refused
/// Errors  those of s100_coverage and s100_points; no datum; a unit that is no length; a level beyond 99.99 m; a record
///         without a time; nothing but missing values
/// Source  IHO S-104 edition 2.0.0, tables 10-3, 12-1 to 12-3 and 12-8; S-100 edition 5.2.0, part 10c, tables 10c-6 to
///         10c-16
[[nodiscard]] Checked<PreparedDataset> read_s104_levels(const std::filesystem::path& file,
                                                        const core::ProgressCallback& progress);

}  // namespace floeplan::ingest
