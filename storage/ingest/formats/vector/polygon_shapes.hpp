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

/// Polygons of a file as places on WGS84.
/// Edges    straight where the file has them straight: those of a projection are divided until they keep within
///          10 m of it between corners that are straight in longitude and latitude; on a projection an outline round a
///          pole is cut open along the antimeridian
class PolygonShapes {
 public:
  /// Shapes whose coordinates are already longitude and latitude on WGS84.
  PolygonShapes();
  /// Errors   a reference system that cannot be brought to WGS84
  [[nodiscard]] static Checked<PolygonShapes> in(const OGRSpatialReference& crs);
  PolygonShapes(PolygonShapes&&) noexcept;
  ~PolygonShapes();

  /// The polygons of a polygon, a multipolygon or a collection of them; curves are laid out as lines.
  /// Errors   other geometries; rings of fewer than three corners; corners that are no places
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

  std::unique_ptr<OGRCoordinateTransformation, Release> to_wgs84_;  // null: they are on it
  bool straight_{true};  // edges are straight in longitude and latitude
};

/// Counts the longitudes of every ring on, beyond 180 degrees, where it crosses the antimeridian with a jump. What
/// leads along a whole parallel or along a pole stays as it is.
void remove_jumps(OGRGeometry& geometry);

/// A ring that leads round a pole, cut open along the antimeridian and closed round that pole; else as it is.
/// Errors   a ring round the Earth on both sides of the equator: which side is its inside is not known
[[nodiscard]] Checked<geo::Ring> closed_over_pole(geo::Ring ring);

/// The reference system of a layer, or the one stated for layers without one, longitudes and eastings first.
/// Errors   none of both; one that is not known
[[nodiscard]] Checked<OGRSpatialReference> crs_of(OGRLayer& layer, const std::optional<std::string>& stated);

}  // namespace floeplan::ingest
