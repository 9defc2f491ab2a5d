#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "storage/ingest/formats/netcdf/netcdf_projection.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/model_grid_writer.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::projected_planes_test {
namespace {

using repository::DatasetKind;
using testing::HasSubstr;

constexpr double radians = std::numbers::pi / 180.0;
constexpr double sphere_m = 6'371'000.0;
const geo::BoundingBox everywhere{-180.0, -90.0, 180.0, 90.0};

/// A place and the direction of the first axis there, counterclockwise from east.
struct Spot {
  geo::LonLat place;
  double turned{};
};

/// Lambert's azimuthal equal-area projection round the north pole of a sphere; y runs along 180 degrees.
Spot on_azimuthal_plane(double x_m, double y_m) {
  const double from_pole = 2.0 * std::asin(std::hypot(x_m, y_m) / (2.0 * sphere_m));
  const double lon = std::atan2(x_m, -y_m);
  return {{lon / radians, 90.0 - from_pole / radians}, -lon};
}

/// Longitude and latitude round a pole at 140 E, 25 N, counted from 40 W, 65 N.
Spot on_turned_sphere(double lon_deg, double lat_deg) {
  const auto place = [](double lon, double lat) {
    const double tilt = 65.0 * radians;
    const double x = std::cos(lat) * std::cos(lon);
    const double y = std::cos(lat) * std::sin(lon);
    const double z = std::sin(lat);
    const double ahead = x * std::cos(tilt) - z * std::sin(tilt);
    const double up = x * std::sin(tilt) + z * std::cos(tilt);
    return geo::LonLat{std::atan2(y, ahead) / radians - 40.0, std::asin(up) / radians};
  };
  const geo::LonLat here = place(lon_deg * radians, lat_deg * radians);
  const geo::LonLat ahead = place((lon_deg + 1e-4) * radians, lat_deg * radians);
  return {here, std::atan2(ahead.lat_deg - here.lat_deg,
                           (ahead.lon_deg - here.lon_deg) * std::cos(here.lat_deg * radians))};
}

/// A plane as a file describes it, without tables of positions.
struct Plane {
  std::vector<double> x;
  std::vector<double> y;
  std::map<std::string, std::string> x_texts;
  std::map<std::string, std::string> y_texts;
  std::map<std::string, std::string> mapping_texts;
  std::map<std::string, double> mapping_numbers;
  std::function<Spot(double, double)> spot;
};

std::vector<double> from_to(double first, double last, double step) {
  std::vector<double> values;
  for (int i = 0; first + i * step <= last + 1e-9 * step; ++i) values.push_back(first + i * step);
  return values;
}

/// In kilometres, from north to south in the file, as OSI SAF writes it.
Plane azimuthal_plane(double half_width_km) {
  Plane plane{.x = from_to(-half_width_km, half_width_km, 100.0),
              .y = from_to(-half_width_km, half_width_km, 100.0),
              .x_texts = {{"units", "km"}, {"standard_name", "projection_x_coordinate"}},
              .y_texts = {{"units", "km"}, {"standard_name", "projection_y_coordinate"}},
              .mapping_texts = {{"grid_mapping_name", "lambert_azimuthal_equal_area"}},
              .mapping_numbers = {{"latitude_of_projection_origin", 90.0},
                                  {"longitude_of_projection_origin", 0.0},
                                  {"false_easting", 0.0},
                                  {"false_northing", 0.0},
                                  {"earth_radius", sphere_m}},
              .spot = [](double x, double y) { return on_azimuthal_plane(1e3 * x, 1e3 * y); }};
  std::ranges::reverse(plane.y);
  return plane;
}

Plane turned_plane() {
  return {.x = from_to(-6.0, 6.0, 0.5),
          .y = from_to(-5.0, 5.0, 0.5),
          .x_texts = {{"units", "degrees"}, {"standard_name", "grid_longitude"}},
          .y_texts = {{"units", "degrees"}, {"standard_name", "grid_latitude"}},
          .mapping_texts = {{"grid_mapping_name", "rotated_latitude_longitude"}},
          .mapping_numbers = {{"grid_north_pole_latitude", 25.0},
                              {"grid_north_pole_longitude", -220.0},
                              {"earth_radius", sphere_m}},
          .spot = on_turned_sphere};
}

/// Values at the points of a plane.
using Field = std::function<double(const Spot&)>;

void write(const std::filesystem::path& file, const Plane& plane,
           const std::vector<std::pair<NetcdfWriter::Variable, Field>>& fields) {
  NetcdfWriter writer{file};
  writer.axis("time", {0.0}, {{"units", "hours since 2026-11-20 00:00:00"}});
  writer.axis("yc", plane.y, plane.y_texts);
  writer.axis("xc", plane.x, plane.x_texts);
  writer.variable({.name = "projection",
                   .dimensions = {},
                   .values = {0.0},
                   .texts = plane.mapping_texts,
                   .numbers = plane.mapping_numbers,
                   .fill = {},
                   .type = NetcdfWriter::Type::int32});
  for (auto [variable, field] : fields) {
    variable.dimensions = {"time", "yc", "xc"};
    variable.texts["grid_mapping"] = "projection";
    for (const double y : plane.y)
      for (const double x : plane.x) variable.values.push_back(field(plane.spot(x, y)));
    writer.variable(variable);
  }
}

NetcdfWriter::Variable called(const std::string& name, const std::string& standard_name,
                              const std::string& unit) {
  return {.name = name,
          .dimensions = {},
          .values = {},
          .texts = {{"standard_name", standard_name}, {"units", unit}},
          .numbers = {},
          .fill = {},
          .type = NetcdfWriter::Type::float64};
}

double along_first(const Spot& spot) {
  const geo::VelocityEn water = turning_sea(spot.place);
  return water.east.value * std::cos(spot.turned) + water.north.value * std::sin(spot.turned);
}

double along_second(const Spot& spot) {
  const geo::VelocityEn water = turning_sea(spot.place);
  return water.north.value * std::cos(spot.turned) - water.east.value * std::sin(spot.turned);
}

/// A share of ice that differs on all sides of the pole.
double share_of_ice(geo::LonLat place) {
  const double from_axis = std::cos(place.lat_deg * radians);
  return 0.5 + 0.4 * from_axis * std::cos(place.lon_deg * radians) +
         0.2 * from_axis * std::sin(place.lon_deg * radians);
}

class ProjectedPlanes : public StoreFixture {
 protected:
  ocean::CurrentGrid stored_velocity(DatasetKind kind) {
    const auto report = ingest(path("plane.nc"));
    ocean::CurrentGrid currents = currents_of(report);
    EXPECT_EQ(report.dataset->kind, kind);
    return currents;
  }
  ocean::IceField stored_ice() {
    const auto report = ingest(path("plane.nc"));
    EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
    if (!report.dataset) throw std::runtime_error{"nothing was stored"};
    return repository::FieldRepository{db_}.load_ice(report.dataset->id, everywhere, std::nullopt).value();
  }
};

/// Expects the turning sea as exactly as linear interpolation between points 50 to 100 km apart allows.
void expect_turning_sea(const ocean::CurrentGrid& currents, double tolerance) {
  const auto& samples = currents.samples();
  std::size_t wet = 0;
  for (std::size_t i = 0; i < samples.grid.size(); ++i) {
    if (std::isnan(samples.u[i])) continue;
    ++wet;
    const std::size_t columns = samples.grid.x().size();
    const geo::VelocityEn truth = turning_sea(samples.grid.place(i % columns, i / columns));
    ASSERT_NEAR(samples.u[i], truth.east.value, tolerance) << i;
    ASSERT_NEAR(samples.v[i], truth.north.value, tolerance) << i;
  }
  EXPECT_GT(wet, 300U);
}

TEST_F(ProjectedPlanes, CurrentsOnAnAzimuthalPlaneArePlacedByItAndTurned) {
  write(path("plane.nc"), azimuthal_plane(1000.0),
        {{called("u", "sea_water_x_velocity", "m s-1"), along_first},
         {called("v", "sea_water_y_velocity", "m s-1"), along_second}});

  const auto currents = stored_velocity(DatasetKind::currents);
  EXPECT_TRUE(std::holds_alternative<geo::AlbersFrame>(currents.samples().grid.frame()));
  // The plane keeps areas, not angles: 9 degrees from the pole its axes are up to 0.2 degrees off their right angle.
  expect_turning_sea(currents, 2e-3 + 0.5 * 0.2 * radians);
}

TEST_F(ProjectedPlanes, CurrentsRoundATurnedPoleArePlacedByItAndTurned) {
  write(path("plane.nc"), turned_plane(),
        {{called("u", "sea_water_x_velocity", "m s-1"), along_first},
         {called("v", "sea_water_y_velocity", "m s-1"), along_second}});

  expect_turning_sea(stored_velocity(DatasetKind::currents), 2e-3);
}

/// The radius of the sphere plays no part where longitudes and latitudes are turned.
TEST_F(ProjectedPlanes, CurrentsRoundATurnedPoleNeedNoFigureOfTheEarth) {
  for (const double axis_m : {0.0, 6'378'137.0, 6'377'397.155}) {
    Plane plane = turned_plane();
    plane.mapping_numbers.erase("earth_radius");
    if (axis_m > 0.0) plane.mapping_numbers["semi_major_axis"] = axis_m;
    write(path("plane.nc"), plane,
          {{called("u", "sea_water_x_velocity", "m s-1"), along_first},
           {called("v", "sea_water_y_velocity", "m s-1"), along_second}});

    expect_turning_sea(stored_velocity(DatasetKind::currents), 2e-3);
    std::filesystem::remove(path("plane.nc"));
  }
}

TEST_F(ProjectedPlanes, WindRoundATurnedPoleIsPlacedByItAndTurned) {
  write(path("plane.nc"), turned_plane(),
        {{called("x_wind_10m", "x_wind", "m s-1"), along_first},
         {called("y_wind_10m", "y_wind", "m s-1"), along_second}});

  expect_turning_sea(stored_velocity(DatasetKind::wind), 2e-3);
}

/// The file has currents and ice as the Arctic models of Copernicus write them.
TEST_F(ProjectedPlanes, IceBesideCurrentsIsStoredWhenItIsAskedFor) {
  write(path("plane.nc"), turned_plane(),
        {{called("u", "sea_water_x_velocity", "m s-1"), along_first},
         {called("v", "sea_water_y_velocity", "m s-1"), along_second},
         {called("siconc", "sea_ice_area_fraction", "%"),
          [&](const Spot& spot) { return 100.0 * share_of_ice(spot.place); }}});

  const auto currents = ingest(path("plane.nc"));
  const auto ice = ingest(path("plane.nc"), {.kind = DatasetKind::ice});

  EXPECT_EQ(currents.dataset->kind, DatasetKind::currents) << words(currents);
  EXPECT_THAT(words(currents), HasSubstr("also holds concentrations of sea ice"));
  ASSERT_EQ(ice.status, IngestStatus::stored) << words(ice);
  EXPECT_EQ(ice.dataset->kind, DatasetKind::ice);
}

TEST_F(ProjectedPlanes, IceOnAnAzimuthalPlaneIsKnownAllRoundThePole) {
  for (const double half_width_km :
       {2500.0, 5000.0}) {  // the larger one does not fit a polar plane of the store
    write(path("plane.nc"), azimuthal_plane(half_width_km),
          {{called("ice_conc", "sea_ice_area_fraction", "%"),
            [](const Spot& spot) { return 100.0 * share_of_ice(spot.place); }}});

    const auto ice = stored_ice();

    const core::UtcTime time = core::from_unix_seconds(ice.samples().times_s.nodes().front());
    for (const double lat : {72.3, 80.1, 86.7, 89.4}) {
      for (double lon = -179.99; lon < 180.0; lon += 29.998) {
        const auto seen = ice.at({lon, lat}, time);
        ASSERT_TRUE(seen) << lon << " " << lat;
        EXPECT_NEAR(seen->concentration, share_of_ice({lon, lat}), 2e-3) << lon << " " << lat;
      }
    }
    std::filesystem::remove(path("plane.nc"));
  }
}

/// GDAL would assume WGS84, on which the corner lies some ten kilometres elsewhere.
TEST_F(ProjectedPlanes, AFigureOfTheEarthThatOnlyAProjStringStatesIsUsed) {
  Plane plane = azimuthal_plane(2500.0);
  plane.mapping_numbers.erase("earth_radius");
  plane.mapping_texts["proj4_string"] = "+proj=laea +lat_0=90 +lon_0=0 +R=6371000 +units=km";
  write(path("plane.nc"), plane,
        {{called("ice_conc", "sea_ice_area_fraction", "1"), [](const Spot&) { return 0.5; }}});
  const auto file = NetcdfFile::open(path("plane.nc"));
  ASSERT_TRUE(file) << reason_of(file.error());

  const auto places = places_by_projection(*file, *file->find("ice_conc"), 1, 2);

  ASSERT_TRUE(places) << reason_of(places.error());
  const geo::LonLat corner = on_azimuthal_plane(1e3 * plane.x[0], 1e3 * plane.y[0]).place;
  EXPECT_NEAR(places->front().lat_deg, corner.lat_deg, 1e-6);
  EXPECT_NEAR(places->front().lon_deg, corner.lon_deg, 1e-6);
}

/// NSIDC's files of the south: text of an old GDAL, which PROJ does not take as it stands, beside a meridian that
/// is half a turn off.
TEST_F(ProjectedPlanes, AProjectionWithAxesOfUnknownDirectionIsReadFromItsText) {
  Plane plane = azimuthal_plane(1000.0);
  for (auto* const texts : {&plane.x_texts, &plane.y_texts}) (*texts)["units"] = "meters";
  for (auto* const values : {&plane.x, &plane.y})
    for (double& value : *values) value *= 1000.0;
  plane.mapping_texts = {
      {"grid_mapping_name", "polar_stereographic"},
      {"spatial_ref",
       "PROJCS[\"NSIDC Sea Ice Polar Stereographic South\",GEOGCS[\"Unspecified datum based upon the Hughes "
       "1980 ellipsoid\",DATUM[\"Not_specified_based_on_Hughes_1980_ellipsoid\",SPHEROID[\"Hughes "
       "1980\",6378273,298.279411123061,AUTHORITY[\"EPSG\",\"7058\"]],AUTHORITY[\"EPSG\",\"6054\"]],PRIMEM["
       "\"Greenwich\",0,AUTHORITY[\"EPSG\",\"8901\"]],UNIT[\"degree\",0.01745329251994328,AUTHORITY["
       "\"EPSG\",\"9122\"]],AUTHORITY[\"EPSG\",\"4054\"]],UNIT[\"metre\",1,AUTHORITY[\"EPSG\",\"9001\"]],"
       "PROJECTION[\"Polar_Stereographic\"],PARAMETER[\"latitude_of_origin\",-70],PARAMETER[\"central_"
       "meridian\",0],PARAMETER[\"scale_factor\",1],PARAMETER[\"false_easting\",0],PARAMETER[\"false_"
       "northing\",0],AUTHORITY[\"EPSG\",\"3412\"],AXIS[\"X\",UNKNOWN],AXIS[\"Y\",UNKNOWN]]"}};
  plane.mapping_numbers = {{"straight_vertical_longitude_from_pole", 180.0},
                           {"latitude_of_projection_origin", -90.0},
                           {"standard_parallel", -70.0}};
  write(path("plane.nc"), plane,
        {{called("cdr_seaice_conc", "sea_ice_area_fraction", "1"), [](const Spot&) { return 0.5; }}});

  const auto ice = stored_ice();
  const auto& frame = std::get<geo::PolarStereographicFrame>(ice.samples().grid.frame());
  EXPECT_FALSE(frame.north);
  EXPECT_EQ(frame.lon_0_deg, 0.0);
  EXPECT_EQ(frame.ellipsoid, geo::hughes_1980);
}

}  // namespace
}  // namespace floeplan::ingest::projected_planes_test
