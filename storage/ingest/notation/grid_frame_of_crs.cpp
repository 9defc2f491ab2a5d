#include "storage/ingest/notation/grid_frame_of_crs.hpp"

#include <ogr_spatialref.h>

#include <cmath>
#include <string_view>

namespace floeplan::ingest {
namespace {

bool is_near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

/// The known ellipsoid of a CRS; GRS80 counts as WGS84.
std::optional<geo::Ellipsoid> ellipsoid_of(const OGRSpatialReference& crs) {
  OGRErr error = OGRERR_NONE;
  const double semi_major_m = crs.GetSemiMajor(&error);
  const double inverse_flattening = crs.GetInvFlattening();
  if (error != OGRERR_NONE || !is_near(crs.GetPrimeMeridian(), 0.0, 1e-9)) return std::nullopt;
  for (const geo::Ellipsoid known : {geo::wgs84, geo::hughes_1980})
    if (is_near(semi_major_m, known.semi_major_m, 0.5) &&
        is_near(inverse_flattening, known.inverse_flattening, 1e-3))
      return known;
  return std::nullopt;
}

/// False for datums up to hundreds of metres away from WGS84 (NAD27, ED50, ...), even if the ellipsoid has
/// the same size.
bool on_world_datum(const OGRSpatialReference& crs) {
  const char* datum = crs.GetAttrValue("DATUM");
  if (datum == nullptr) return true;
  const std::string_view name = datum;
  for (const char* far : {"1927", "ED50", "European_Datum_1950", "Tokyo", "Pulkovo"})
    if (name.find(far) != std::string_view::npos) return false;
  return true;
}

/// Models use radii between the semi-axes of WGS84, or the longer semi-axis of Hughes 1980.
bool is_sphere(const OGRSpatialReference& crs) {
  const double radius_m = crs.GetSemiMajor();
  return crs.GetInvFlattening() == 0.0 && radius_m >= 6'356'752.0 && radius_m <= 6'378'273.0;
}

}  // namespace

std::optional<geo::GridFrame> grid_frame_of(const OGRSpatialReference& crs) {
  const auto ellipsoid = ellipsoid_of(crs);
  if (!ellipsoid || !on_world_datum(crs)) return std::nullopt;
  if (crs.IsGeographic()) {
    if (!is_near(crs.GetAngularUnits(), 0.017453292519943295, 1e-12)) return std::nullopt;
    return geo::GeographicFrame{};
  }
  if (!crs.IsProjected() || !is_near(crs.GetLinearUnits(), 1.0, 1e-12)) return std::nullopt;

  const char* projection = crs.GetAttrValue("PROJECTION");
  if (projection == nullptr) return std::nullopt;
  const std::string_view method = projection;
  const double lat_0_deg = crs.GetNormProjParm(SRS_PP_LATITUDE_OF_ORIGIN, 0.0);
  const double lon_0_deg = crs.GetNormProjParm(SRS_PP_CENTRAL_MERIDIAN, 0.0);
  const double scale_0 = crs.GetNormProjParm(SRS_PP_SCALE_FACTOR, 1.0);
  const double false_easting_m = crs.GetNormProjParm(SRS_PP_FALSE_EASTING, 0.0);
  const double false_northing_m = crs.GetNormProjParm(SRS_PP_FALSE_NORTHING, 0.0);

  if (method == SRS_PT_POLAR_STEREOGRAPHIC && is_near(scale_0, 1.0, 1e-12))
    return geo::PolarStereographicFrame{.north = lat_0_deg > 0.0,
                                        .lat_ts_deg = lat_0_deg,
                                        .lon_0_deg = lon_0_deg,
                                        .false_easting_m = false_easting_m,
                                        .false_northing_m = false_northing_m,
                                        .ellipsoid = *ellipsoid};
  if (*ellipsoid != geo::wgs84) return std::nullopt;
  if (method == SRS_PT_TRANSVERSE_MERCATOR)
    return geo::TransverseMercatorFrame{.lon_0_deg = lon_0_deg,
                                        .lat_0_deg = lat_0_deg,
                                        .scale_0 = scale_0,
                                        .false_easting_m = false_easting_m,
                                        .false_northing_m = false_northing_m};
  return std::nullopt;
}

bool has_latitudes_of_the_earth(const OGRSpatialReference& crs) {
  return on_world_datum(crs) && (ellipsoid_of(crs) || is_sphere(crs));
}

}  // namespace floeplan::ingest
