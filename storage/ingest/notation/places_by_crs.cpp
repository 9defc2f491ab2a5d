#include "storage/ingest/notation/places_by_crs.hpp"

#include <ogr_spatialref.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string_view>

#include "storage/ingest/common/gdal_guard.hpp"

namespace floeplan::ingest {
namespace {

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

OGRSpatialReference geographic_for(const OGRSpatialReference& crs) {
  OGRSpatialReference geographic;
  if (earth_of(crs))
    geographic.SetGeogCS("own", "own", "own", crs.GetSemiMajor(), crs.GetInvFlattening());
  else
    geographic.SetWellKnownGeogCS("WGS84");
  geographic.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return geographic;
}

}  // namespace

std::optional<geo::Ellipsoid> earth_of(const OGRSpatialReference& crs) {
  if (!on_world_datum(crs)) return std::nullopt;
  OGRErr error = OGRERR_NONE;
  const double semi_major_m = crs.GetSemiMajor(&error);
  const double inverse_flattening = crs.GetInvFlattening();
  if (error == OGRERR_NONE && std::abs(crs.GetPrimeMeridian()) <= 1e-9) {
    const auto differs = [&](const geo::Ellipsoid& known) {
      return std::abs(semi_major_m - known.semi_major_m) <= 0.5
                 ? std::abs(inverse_flattening - known.inverse_flattening)
                 : std::numeric_limits<double>::infinity();
    };
    // Files round the shorter axis, that of Hughes 1980 to a millimetre.
    if (differs(geo::hughes_1980) <= 1e-3) return geo::hughes_1980;
    const geo::Ellipsoid nearest = differs(geo::wgs84) <= differs(geo::grs_1980) ? geo::wgs84 : geo::grs_1980;
    if (differs(nearest) <= 1e-6) return nearest;
    if (differs(nearest) <= 1e-3) return geo::Ellipsoid{semi_major_m, inverse_flattening};
  }
  // Models use radii between the semi-axes of WGS84, or the longer semi-axis of Hughes 1980.
  if (inverse_flattening == 0.0 && semi_major_m >= 6'356'752.0 && semi_major_m <= 6'378'273.0)
    return geo::Ellipsoid{semi_major_m, 0.0};
  return std::nullopt;
}

tl::expected<std::vector<geo::LonLat>, std::string> places_by_crs(
    const OGRSpatialReference& crs, std::size_t rows, std::size_t columns,
    const std::function<geo::GridPoint(std::size_t row, std::size_t column)>& at) {
  const GdalMessages messages;
  OGRSpatialReference from{crs};
  from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const OGRSpatialReference to = geographic_for(crs);
  const std::unique_ptr<OGRCoordinateTransformation> way{OGRCreateCoordinateTransformation(&from, &to)};
  if (!way) return tl::unexpected(messages.first_error());

  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  std::vector<geo::LonLat> places;
  places.reserve(rows * columns);
  std::vector<double> lons(columns);
  std::vector<double> lats(columns);
  std::vector<int> reached(columns);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const geo::GridPoint point = at(row, column);
      lons[column] = point.x;
      lats[column] = point.y;
    }
    way->Transform(static_cast<int>(columns), lons.data(), lats.data(), nullptr, reached.data());
    for (std::size_t i = 0; i < columns; ++i) {
      const bool known = reached[i] != 0 && std::isfinite(lons[i]) && std::abs(lats[i]) <= 90.0;
      places.push_back(known ? geo::LonLat{geo::wrap_longitude(lons[i]), lats[i]}
                             : geo::LonLat{nowhere, nowhere});
    }
  }
  return places;
}

}  // namespace floeplan::ingest
