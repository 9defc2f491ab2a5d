#pragma once

#include <filesystem>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/bounding_box.hpp"
#include "engine/geo/polygon.hpp"

namespace floeplan::ingest {

/// Whether a file is a GSHHG shoreline as GMT bins it ("binned_GSHHS_f.nc"), by the names of its arrays.
/// Errors   none: a file that cannot be opened is not one
[[nodiscard]] bool is_gshhg(const std::filesystem::path& file);

/// Land around an area from a GSHHG shoreline as GMT bins it (NetCDF of the Debian package gmt-gshhg-full).
/// Shape    every bin (1 degree at full resolution) that meets the area, whole: the polygons are cut at bin
///          borders, and their union is the land; lakes are holes or bays, islands in lakes are land.
///          Antarctica ends at its ice front
/// Order    bins from north to south, each band eastwards from Greenwich
/// Frame    WGS84, longitudes in [-180, 180]; no ring crosses the antimeridian
/// Errors   a violation when the file is not such a shoreline or contradicts itself Memory about 16 bytes a
///          vertex: 11 million vertices in the whole world at full resolution; read it in latitude bands
/// Threads  may be called from several threads at once
/// Source   Wessel and Smith 1996, J. Geophys. Res. 101, 8741-8743, doi:10.1029/96JB00104
[[nodiscard]] tl::expected<std::vector<geo::Polygon>, core::Violation> read_gshhg(
    const std::filesystem::path& file, const geo::BoundingBox& area);

}  // namespace floeplan::ingest
