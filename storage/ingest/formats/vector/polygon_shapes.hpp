#pragma once

#include <ogr_spatialref.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/geo/polygon.hpp"
#include "storage/ingest/common/refusal.hpp"

class OGRCoordinateTransformation;
class OGRGeometry;
class OGRLayer;
class OGRLinearRing;
class OGRPolygon;

namespace floeplan::ingest {

/// Converts polygons of a file to polygons on WGS84.
/// Edges    an edge is straight in the coordinates of the file. Edges of a projection are divided until the
///          straight line in longitude and latitude deviates by less than 10 m; an outline around a pole on a
///          projection is cut open along the antimeridian
class PolygonShapes {
 public:
  /// Shapes whose coordinates are already longitude and latitude on WGS84.
  PolygonShapes();
  /// Errors   the reference system cannot be transformed to WGS84
  [[nodiscard]] static Checked<PolygonShapes> in(const OGRSpatialReference& crs);
  PolygonShapes(PolygonShapes&&) noexcept;
  ~PolygonShapes();

  /// The polygons of a polygon, a multipolygon or a collection of them. Curves are approximated by lines.
  /// Errors   other geometries; rings of fewer than three corners; corners that are not positions on the
  ///          Earth
  [[nodiscard]] Checked<std::vector<geo::Polygon>> polygons(const OGRGeometry* geometry) const;

 private:
  struct Release {
    void operator()(OGRCoordinateTransformation* transformation) const;
  };
  [[nodiscard]] Checked<geo::LonLat> place(double x, double y) const;
  [[nodiscard]] Checked<geo::Ring> ring(const OGRLinearRing& line) const;
  [[nodiscard]] Checked<geo::Polygon> polygon(const OGRPolygon& shape) const;
  [[nodiscard]] Checked<bool> divide(double x0, double y0, geo::LonLat from, double x1, double y1,
                                     geo::LonLat to, int depth, geo::Ring& ring) const;

  // null: the coordinates are on WGS84 already
  std::unique_ptr<OGRCoordinateTransformation, Release> to_wgs84_;
  bool straight_{true};  // edges are straight in longitude and latitude
};

/// Makes the longitudes of every ring continuous, beyond 180 degrees where the ring jumps across the
/// antimeridian. An edge along a whole parallel or along a pole stays unchanged.
void remove_jumps(OGRGeometry& geometry);

/// Cuts a ring around a pole open along the antimeridian and closes it over that pole. Other rings stay
/// unchanged.
/// Errors   the ring surrounds the Earth on both sides of the equator, so its inside is not defined
[[nodiscard]] Checked<geo::Ring> closed_over_pole(geo::Ring ring);

/// The reference system of a layer, or the stated one if the layer has none; longitude or easting comes
/// first.
/// Errors   neither exists; the reference system is not known
[[nodiscard]] Checked<OGRSpatialReference> crs_of(OGRLayer& layer, const std::optional<std::string>& stated);

}  // namespace floeplan::ingest
