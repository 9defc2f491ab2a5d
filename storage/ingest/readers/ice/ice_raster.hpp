#pragma once

#include <memory>
#include <vector>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/vector/sigrid3.hpp"

class OGRGeometry;

namespace floeplan::ingest {

/// An area and its ice.
struct IcePolygon {
  std::unique_ptr<OGRGeometry> area;
  IceOfPolygon ice;
};

/// Ice on a grid; NaN where nothing is known, of the thickness also where it has no upper bound.
/// Shape    [y][x], last index fastest
struct IceRaster {
  ocean::HorizontalGrid grid;
  std::vector<float> concentration;
  std::vector<float> thickness_m;
};

/// Lays polygons in longitude and latitude (of which long edges are divided already) or in a reference system on a
/// polar stereographic grid, true to scale at 70 degrees, of at most two million nodes; the greatest value of all
/// polygons that touch a cell or one beside it counts.
/// Errors   corners that the projection cannot take, polygons on both hemispheres
[[nodiscard]] Checked<IceRaster> lay_on_grid(std::vector<IcePolygon> polygons);

}  // namespace floeplan::ingest
