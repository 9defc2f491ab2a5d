#pragma once

#include <filesystem>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/bounding_box.hpp"
#include "engine/geo/polygon.hpp"

namespace floeplan::ingest {

/// Whether a file is a GSHHG shoreline in GMT's bins ("binned_GSHHS_f.nc"); the names of its arrays decide.
/// Errors   none: a file that cannot be opened is not one
[[nodiscard]] bool is_gshhg(const std::filesystem::path& file);

/// Land around an area from a GSHHG shoreline in GMT's bins (NetCDF of the Debian package gmt-gshhg-full).
/// Shape    the land of every bin that meets the area (1 degree at full resolution), not cut to the area.
///          Polygons are cut at the borders of bins. Lakes are holes or bays, islands in lakes are land.
///          Antarctica ends at its ice front
/// Order    bins from north to south; each band of latitude eastwards from Greenwich
/// Frame    WGS84, longitudes in [-180, 180]; no ring crosses the antimeridian
/// Errors   a violation when the file is not such a shoreline or contradicts itself
/// Memory   about 16 bytes per vertex. The whole world has 11 million vertices at full resolution; read it in
///          bands of latitude
/// Threads  may be called from several threads at once
/// Source   Wessel and Smith 1996, J. Geophys. Res. 101, 8741-8743, doi:10.1029/96JB00104
[[nodiscard]] tl::expected<std::vector<geo::Polygon>, core::Violation> read_gshhg(
    const std::filesystem::path& file, const geo::BoundingBox& area);

}  // namespace floeplan::ingest
