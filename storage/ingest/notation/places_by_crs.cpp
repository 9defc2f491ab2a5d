#include "storage/ingest/notation/places_by_crs.hpp"

#include <ogr_spatialref.h>

#include <cmath>
#include <limits>
#include <memory>

#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/notation/grid_frame_of_crs.hpp"

namespace floeplan::ingest {
namespace {

OGRSpatialReference geographic_for(const OGRSpatialReference& crs) {
  OGRSpatialReference geographic;
  if (has_latitudes_of_the_earth(crs))
    geographic.SetGeogCS("own", "own", "own", crs.GetSemiMajor(), crs.GetInvFlattening());
  else
    geographic.SetWellKnownGeogCS("WGS84");
  geographic.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return geographic;
}

}  // namespace

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
