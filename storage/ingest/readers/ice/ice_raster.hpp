#pragma once

#include <memory>
#include <vector>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/vector/sigrid3.hpp"

class OGRGeometry;

namespace floeplan::ingest {

/// An area with its ice.
struct IcePolygon {
  std::unique_ptr<OGRGeometry> area;
  IceOfPolygon ice;
};

/// Ice on a grid. NaN where nothing is known; the thickness is also NaN where it has no upper limit.
/// Shape    [y][x], last index fastest
struct IceRaster {
  ocean::HorizontalGrid grid;
  std::vector<float> concentration;
  std::vector<float> thickness_m;
};

/// Puts polygons on a polar stereographic grid that is true to scale at 70 degrees and has at most two
/// million nodes. The polygons are in longitude and latitude, with long edges already divided, or in a
/// reference system. A node gets the greatest value of all polygons that touch its cell or a neighbouring
/// cell.
/// Errors   corners outside the range of the projection; polygons in both hemispheres
[[nodiscard]] Checked<IceRaster> lay_on_grid(std::vector<IcePolygon> polygons);

}  // namespace floeplan::ingest
