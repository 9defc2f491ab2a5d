#pragma once

#include <filesystem>

#include "storage/ingest/common/prepared_dataset.hpp"

namespace floeplan::ingest {

/// The stations of a TCD file (XTide, TICON) that have harmonic constants of the water level, phases turned from their
/// zone's standard time to Greenwich: g = epoch - speed * zone. Stations of tidal currents, and those that are stated as
/// differences from another, are left out and counted, as are constituents that are unknown or have another speed.
/// Errors   no station left; an amplitude over 20 m; a place that is not on the Earth; damage
/// Source   libtcd.html of libtcd 2.2.2, zone_offset: "the standard time to which epochs are adjusted"
[[nodiscard]] Checked<PreparedDataset> read_tcd_stations(const std::filesystem::path& file);

}  // namespace floeplan::ingest
