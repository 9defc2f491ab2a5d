#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

class OGRSpatialReference;

namespace floeplan::ingest {

/// Positions of the nodes of a GRIB2 field, independent of the order in which its messages scan them.
struct GribGrid {
  std::vector<double> x;  // from west to east, or ascending along the x axis of the projection
  std::vector<double> y;  // from south to north, or ascending along the y axis
  /// Null: x and y are longitude and latitude in degrees. Otherwise the projection: x and y in metres, or in
  /// degrees around a rotated pole, on the sphere or ellipsoid that the file names.
  std::shared_ptr<const OGRSpatialReference> plane;
};

/// Reads the grid from the octets of section 3. The first node, the increments and the scanning mode give the
/// grid; if the section also states the last node, it has to agree. GDAL 3.6 is not used, because it
/// misplaces grids whose rows run from east to west, and finds the northernmost row from the latitudes, not
/// from the scanning mode.
/// Units    degrees, or metres for a projection
/// Errors   rows of different length or offset by half a step; a first and a last node that contradict the scanning
///          mode or the increments; a projection or a figure of the Earth that is not known or contradicts itself
/// Source   WMO Manual on Codes No. 306, volume I.2, part B, FM 92 GRIB edition 2: templates 3.0, 3.1, 3.10, 3.20,
///          3.30; flag tables 3.3, 3.4, 3.5; code table 3.2
[[nodiscard]] Checked<GribGrid> grib_grid(const std::string& section);

}  // namespace floeplan::ingest
