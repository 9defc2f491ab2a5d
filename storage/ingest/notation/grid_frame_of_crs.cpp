#include "storage/ingest/notation/grid_frame_of_crs.hpp"

#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <variant>

#include "storage/ingest/notation/places_by_crs.hpp"

namespace floeplan::ingest {
namespace {

bool is_near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

/// Parameters of a projection in degrees and metres, as GDAL names them; 0 where the CRS has none.
struct Parameters {
  double lat_0_deg{};
  double lon_0_deg{};
  double lat_centre_deg{};
  double lon_centre_deg{};
  double lat_1_deg{};
  double lat_2_deg{};
  double scale{};
  double false_easting_m{};
  double false_northing_m{};
};

Parameters parameters_of(const OGRSpatialReference& crs) {
  return {.lat_0_deg = crs.GetNormProjParm(SRS_PP_LATITUDE_OF_ORIGIN, 0.0),
          .lon_0_deg = crs.GetNormProjParm(SRS_PP_CENTRAL_MERIDIAN, 0.0),
          .lat_centre_deg = crs.GetNormProjParm(SRS_PP_LATITUDE_OF_CENTER, 0.0),
          .lon_centre_deg = crs.GetNormProjParm(SRS_PP_LONGITUDE_OF_CENTER, 0.0),
          .lat_1_deg = crs.GetNormProjParm(SRS_PP_STANDARD_PARALLEL_1, 0.0),
          .lat_2_deg = crs.GetNormProjParm(SRS_PP_STANDARD_PARALLEL_2, 0.0),
          .scale = crs.GetNormProjParm(SRS_PP_SCALE_FACTOR, 1.0),
          .false_easting_m = crs.GetNormProjParm(SRS_PP_FALSE_EASTING, 0.0),
          .false_northing_m = crs.GetNormProjParm(SRS_PP_FALSE_NORTHING, 0.0)};
}

geo::GridFrame conformal(const Parameters& p, double lat_1_deg, double lat_2_deg, double lat_0_deg,
                         const geo::Ellipsoid& earth) {
  return geo::LambertConformalFrame{.lat_1_deg = lat_1_deg,
                                    .lat_2_deg = lat_2_deg,
                                    .scale_1 = p.scale,
                                    .lat_0_deg = lat_0_deg,
                                    .lon_0_deg = p.lon_0_deg,
                                    .false_easting_m = p.false_easting_m,
                                    .false_northing_m = p.false_northing_m,
                                    .ellipsoid = earth};
}

geo::GridFrame equal_area(const Parameters& p, double lat_1_deg, double lat_2_deg, double lat_0_deg,
                          double lon_0_deg, const geo::Ellipsoid& earth) {
  return geo::AlbersFrame{.lat_1_deg = lat_1_deg,
                          .lat_2_deg = lat_2_deg,
                          .lat_0_deg = lat_0_deg,
                          .lon_0_deg = lon_0_deg,
                          .false_easting_m = p.false_easting_m,
                          .false_northing_m = p.false_northing_m,
                          .ellipsoid = earth};
}

std::optional<geo::GridFrame> projected_frame(const OGRSpatialReference& crs, const geo::Ellipsoid& earth) {
  const char* projection = crs.GetAttrValue("PROJECTION");
  if (projection == nullptr) return std::nullopt;
  const std::string_view method = projection;
  const Parameters p = parameters_of(crs);
  if (method == SRS_PT_POLAR_STEREOGRAPHIC)
    return geo::PolarStereographicFrame{.north = p.lat_0_deg > 0.0,
                                        .lat_ts_deg = p.lat_0_deg,
                                        .lon_0_deg = p.lon_0_deg,
                                        .false_easting_m = p.false_easting_m,
                                        .false_northing_m = p.false_northing_m,
                                        .ellipsoid = earth,
                                        .scale_ts = p.scale};
  if (method == SRS_PT_TRANSVERSE_MERCATOR)
    return geo::TransverseMercatorFrame{.lon_0_deg = p.lon_0_deg,
                                        .lat_0_deg = p.lat_0_deg,
                                        .scale_0 = p.scale,
                                        .false_easting_m = p.false_easting_m,
                                        .false_northing_m = p.false_northing_m,
                                        .ellipsoid = earth};
  if (method == SRS_PT_MERCATOR_1SP) {
    // GDAL writes the Mercator projection of web maps (EPSG:3857) as if it were on the ellipsoid, with an extension.
    const char* extension = crs.GetExtension("PROJCS", "PROJ4");
    const bool of_web_maps =
        extension != nullptr && std::string_view{extension}.find("nadgrids=@null") != std::string_view::npos;
    return conformal(p, 0.0, 0.0, 0.0, of_web_maps ? geo::Ellipsoid{earth.semi_major_m, 0.0} : earth);
  }
  if (method == SRS_PT_MERCATOR_2SP) return conformal(p, p.lat_1_deg, -p.lat_1_deg, 0.0, earth);
  if (method == SRS_PT_LAMBERT_CONFORMAL_CONIC_1SP)
    return conformal(p, p.lat_0_deg, p.lat_0_deg, p.lat_0_deg, earth);
  if (method == SRS_PT_LAMBERT_CONFORMAL_CONIC_2SP)
    return conformal(p, p.lat_1_deg, p.lat_2_deg, p.lat_0_deg, earth);
  if (method == SRS_PT_ALBERS_CONIC_EQUAL_AREA)
    return equal_area(p, p.lat_1_deg, p.lat_2_deg, p.lat_centre_deg, p.lon_centre_deg, earth);
  if (method == SRS_PT_CYLINDRICAL_EQUAL_AREA)
    return equal_area(p, p.lat_1_deg, -p.lat_1_deg, 0.0, p.lon_0_deg, earth);
  if (method != SRS_PT_LAMBERT_AZIMUTHAL_EQUAL_AREA) return std::nullopt;
  if (std::abs(p.lat_centre_deg) == 90.0)
    return equal_area(p, p.lat_centre_deg, p.lat_centre_deg, p.lat_centre_deg, p.lon_centre_deg, earth);
  return geo::AzimuthalEqualAreaFrame{.lat_0_deg = p.lat_centre_deg,
                                      .lon_0_deg = p.lon_centre_deg,
                                      .false_easting_m = p.false_easting_m,
                                      .false_northing_m = p.false_northing_m,
                                      .ellipsoid = earth};
}

/// A place near the middle of what a projection is made for.
geo::LonLat middle_of(const geo::PolarStereographicFrame& frame) {
  return {frame.lon_0_deg, frame.north ? 80.0 : -80.0};
}
template <class Frame>
geo::LonLat middle_of(const Frame& frame) {
  if constexpr (requires { frame.lat_1_deg; })
    return {frame.lon_0_deg, 0.5 * (frame.lat_1_deg + frame.lat_2_deg)};
  else
    return {frame.lon_0_deg, frame.lat_0_deg};
}
geo::LonLat middle_of(const geo::GeographicFrame& /*frame*/) { return {}; }

/// Whether PROJ has the same places for the same coordinates. Parameters that a method does not have, or another
/// orientation of its axes, show here.
bool agrees_with_proj(const geo::GridFrame& frame, const OGRSpatialReference& crs) {
  constexpr double most_apart_deg = 1e-6;
  constexpr std::array<geo::LonLat, 3> beside{{{-2.5, -5.0}, {0.5, 0.5}, {2.0, 4.0}}};
  const geo::FrameProjection projection{frame};
  const geo::LonLat middle = std::visit([](const auto& any) { return middle_of(any); }, frame);
  std::array<geo::LonLat, beside.size()> places{};
  for (std::size_t i = 0; i < beside.size(); ++i)
    places.at(i) = {geo::wrap_longitude(middle.lon_deg + beside.at(i).lon_deg),
                    std::clamp(middle.lat_deg, -80.0, 80.0) + beside.at(i).lat_deg};
  const auto by_proj = places_by_crs(crs, 1, beside.size(), [&](std::size_t /*row*/, std::size_t column) {
    return projection.to_grid(places.at(column));
  });
  if (!by_proj) return false;
  for (std::size_t i = 0; i < beside.size(); ++i) {
    const geo::LonLat place = places.at(i);
    if (!is_near((*by_proj)[i].lat_deg, place.lat_deg, most_apart_deg) ||
        !is_near(geo::longitude_difference(place.lon_deg, (*by_proj)[i].lon_deg), 0.0, most_apart_deg))
      return false;
  }
  return true;
}

}  // namespace

std::optional<geo::GridFrame> grid_frame_of(const OGRSpatialReference& crs) {
  const auto earth = earth_of(crs);
  if (!earth || crs.IsDerivedGeographic() != 0) return std::nullopt;  // round a turned pole
  if (crs.IsGeographic() != 0) {
    const bool in_degrees = is_near(crs.GetAngularUnits(), 0.017453292519943295, 1e-12);
    const bool on_sphere = earth->inverse_flattening == 0.0;
    return in_degrees && !on_sphere ? std::optional<geo::GridFrame>{geo::GeographicFrame{}} : std::nullopt;
  }
  if (crs.IsProjected() == 0 || !is_near(crs.GetLinearUnits(), 1.0, 1e-12)) return std::nullopt;
  try {
    const auto frame = projected_frame(crs, *earth);
    return frame && agrees_with_proj(*frame, crs) ? frame : std::nullopt;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

bool lies_in_projection(const ocean::HorizontalGrid& grid) {
  constexpr double rounding_m = 0.01;
  const std::size_t columns = grid.x().size();
  const std::size_t rows = grid.y().size();
  const auto cut_deg = grid.projection().cut_deg();
  std::optional<double> last_deg;  // east of the cut
  const auto is_placed = [&](std::size_t ix, std::size_t iy) {
    const geo::LonLat place = grid.place(ix, iy);
    const geo::GridPoint back = grid.projection().to_grid(place);
    if (!is_near(back.x, grid.x()[ix], rounding_m) || !is_near(back.y, grid.y()[iy], rounding_m))
      return false;
    if (!cut_deg) return true;
    const double difference_deg = geo::longitude_difference(*cut_deg, place.lon_deg);
    const double east_deg = difference_deg < 0.0 ? difference_deg + 360.0 : difference_deg;
    const bool crosses = last_deg && std::abs(east_deg - *last_deg) > 180.0;
    last_deg = east_deg;
    return !crosses;
  };
  constexpr std::size_t most_on_a_side = 1024;  // what lies between would show as a jump, too
  const auto along = [most_on_a_side](std::size_t count, const auto& holds) {
    const std::size_t parts = std::min(count - 1, most_on_a_side);
    for (std::size_t i = 0; i <= parts; ++i)
      if (!holds(parts == 0 ? 0 : i * (count - 1) / parts)) return false;
    return true;
  };
  return along(columns, [&](std::size_t ix) { return is_placed(ix, 0); }) &&
         along(rows, [&](std::size_t iy) { return is_placed(columns - 1, iy); }) &&
         along(columns, [&](std::size_t ix) { return is_placed(columns - 1 - ix, rows - 1); }) &&
         along(rows, [&](std::size_t iy) { return is_placed(0, rows - 1 - iy); });
}

}  // namespace floeplan::ingest
