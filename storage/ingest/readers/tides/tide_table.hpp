#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"

namespace floeplan::ingest {

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

}  // namespace floeplan::ingest
