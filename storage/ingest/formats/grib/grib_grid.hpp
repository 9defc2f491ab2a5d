#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

class OGRSpatialReference;

namespace floeplan::ingest {

/// Where the nodes of a GRIB2 field lie, whichever way its messages scan them.
struct GribGrid {
  std::vector<double> x;  // from west to east, or in ascending order along the projection's own axis
  std::vector<double> y;  // from south to north, likewise
  /// Null: x and y are longitude and latitude, degrees. Else of a projection in metres, or of degrees round a pole
  /// that is not the Earth's; on the sphere or ellipsoid that the file names.
  std::shared_ptr<const OGRSpatialReference> plane;
};

/// Reads the octets of section 3. The grid follows from its first node, its increments and the scanning mode alone;
/// where the section also states the last node, both have to agree. GDAL 3.6 is not asked: it puts grids whose rows run
/// from east to west elsewhere, and takes the northernmost row from the latitudes instead of from the scanning mode.
/// Units    degrees; metres of a projection
/// Errors   rows of different length or offset by half a step; a first and a last node that contradict the scanning
///          mode or the increments; a projection or a figure of the Earth that is not known or contradicts itself
/// Source   WMO Manual on Codes No. 306, volume I.2, part B, FM 92 GRIB edition 2: templates 3.0, 3.1, 3.10, 3.20,
///          3.30; flag tables 3.3, 3.4, 3.5; code table 3.2
[[nodiscard]] Checked<GribGrid> grib_grid(const std::string& section);

}  // namespace floeplan::ingest
