#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/utc_text.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::producer_layouts_test {
namespace {

/// Small files with the names, attributes and axes of producers of which no sample is at hand. Expected values are those of
/// the file's own formula at its own points.
class ProducerLayouts : public StoreFixture {
 protected:
  static geo::BoundingBox at(geo::LonLat place) {
    return {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg};
  }

  double depth_at(const IngestReport& report, geo::LonLat place) {
    return repository::FieldRepository{db_}
        .load_bathymetry(report.dataset.value().id, at(place))
        .value()
        .depth(place)
        .value()
        .value;
  }

  static std::vector<double> steps(double first, double step, std::size_t count) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(first + step * static_cast<double>(i));
    return values;
  }

  /// Values [y][x], the last index fastest.
  template <class Formula>
  static std::vector<double> table(std::size_t rows, std::size_t columns, const Formula& formula) {
    std::vector<double> values;
    for (std::size_t j = 0; j < rows; ++j)
      for (std::size_t i = 0; i < columns; ++i) values.push_back(formula(i, j));
    return values;
  }

  static double relief(std::size_t i, std::size_t j) {
    return -310.0 + static_cast<double>((7919 * i + 104729 * j) % 330);
  }

  void expect_relief(const IngestReport& report, const geo::GridFrame& frame, const std::vector<double>& x,
                     const std::vector<double>& y) {
    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    for (std::size_t j = 0; j < y.size(); j += 3)
      for (std::size_t i = 0; i < x.size(); i += 5)
        EXPECT_NEAR(depth_at(report, geo::FrameProjection{frame}.to_lon_lat({x[i], y[j]})), -relief(i, j),
                    1e-4)
            << i << " " << j;
  }
};

TEST_F(ProducerLayouts, GebcosGridIsReadAtItsOwnNodes) {
  const auto lons = steps(-54.0 + 0.5 / 240.0, 1.0 / 240.0, 30);
  const auto lats = steps(69.0 + 0.5 / 240.0, 1.0 / 240.0, 20);
  {
    NetcdfWriter file{path("gebco.nc")};
    file.attribute("title", "The GEBCO_2023 Grid");
    file.axis("lat", lats, {{"standard_name", "latitude"}, {"units", "degrees_north"}, {"axis", "Y"}});
    file.axis("lon", lons, {{"standard_name", "longitude"}, {"units", "degrees_east"}, {"axis", "X"}});
    file.variable({.name = "elevation",
                   .dimensions = {"lat", "lon"},
                   .values = table(20, 30, relief),
                   .texts = {{"standard_name", "height_above_mean_sea_level"},
                             {"long_name", "Elevation relative to sea level"},
                             {"units", "m"},
                             {"sdn_parameter_urn", "SDN:P01::BATHHGHT"}},
                   .numbers = {},
                   .fill = {},
                   .type = NetcdfWriter::Type::int16});
  }

  expect_relief(ingest(path("gebco.nc")), geo::GeographicFrame{}, lons, lats);
}

/// GMT's grid of IBCAO 4 states neither its projection (EPSG:3996) nor what counts upwards.
TEST_F(ProducerLayouts, IbcaosGridIsReadWhereThePilotSaysWhatItLacks) {
  const auto x = steps(-1.0e6, 200.0, 26);
  const auto y = steps(-2.2e6, 200.0, 22);
  {
    NetcdfWriter file{path("ibcao.nc")};
    file.attribute("GMT_version", "6.0.0 [64-bit]");
    file.axis("x", x, {{"long_name", "x"}});
    file.axis("y", y, {{"long_name", "y"}});
    file.variable({.name = "z",
                   .dimensions = {"y", "x"},
                   .values = table(22, 26, relief),
                   .texts = {{"long_name", "z"}},
                   .numbers = {},
                   .fill = NAN});
  }

  expect_refused(path("ibcao.nc"), "State the projection with --crs");
  expect_refused(path("ibcao.nc"), "State --positive up", {.crs = "EPSG:3996"});
  expect_relief(ingest(path("ibcao.nc"), {.crs = "EPSG:3996", .positive = "up"}),
                geo::PolarStereographicFrame{.lat_ts_deg = 75.0}, x, y);
}

/// Bremen's maps of the 89 GHz channels of AMSR2, on the ellipsoid of Hughes until 2018; the date is in the name alone.
TEST_F(ProducerLayouts, IceOfBremenIsReadWhereThePilotNamesIt) {
  const auto x = steps(-1'346'875.0, 6250.0, 20);
  const auto y = steps(-971'875.0, 6250.0, 18);
  const auto percent = [](std::size_t i, std::size_t j) {
    return static_cast<double>((37 * i + 101 * j) % 101);
  };
  {
    NetcdfWriter file{path("asi-AMSR2-n6250-20181001-v5.4.nc")};
    file.axis("x", x, {{"standard_name", "projection_x_coordinate"}, {"units", "m"}});
    file.axis("y", y, {{"standard_name", "projection_y_coordinate"}, {"units", "m"}});
    file.variable({.name = "polar_stereographic",
                   .dimensions = {},
                   .values = {0.0},
                   .texts = {{"grid_mapping_name", "polar_stereographic"}},
                   .numbers = {{"straight_vertical_longitude_from_pole", -45.0},
                               {"latitude_of_projection_origin", 90.0},
                               {"standard_parallel", 70.0},
                               {"false_easting", 0.0},
                               {"false_northing", 0.0},
                               {"semi_major_axis", 6378273.0},
                               {"inverse_flattening", 298.279411123064}},
                   .fill = {},
                   .type = NetcdfWriter::Type::int32});
    file.variable({.name = "z",
                   .dimensions = {"y", "x"},
                   .values = table(18, 20, percent),
                   .texts = {{"long_name", "z"}, {"grid_mapping", "polar_stereographic"}},
                   .numbers = {},
                   .fill = NAN});
  }
  const auto noon = core::parse_iso8601("2018-10-01T12:00:00Z").value();

  const auto report = ingest(path("asi-AMSR2-n6250-20181001-v5.4.nc"),
                             {.kind = repository::DatasetKind::ice, .variable = "z", .time = noon});

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const geo::PolarStereographicFrame frame{
      .lat_ts_deg = 70.0, .lon_0_deg = -45.0, .ellipsoid = geo::hughes_1980};
  for (std::size_t j = 0; j < y.size(); j += 3)
    for (std::size_t i = 0; i < x.size(); i += 5) {
      const geo::LonLat place = geo::FrameProjection{frame}.to_lon_lat({x[i], y[j]});
      const auto ice = repository::FieldRepository{db_}.load_ice(report.dataset->id, at(place), std::nullopt);
      EXPECT_NEAR(ice.value().at(place, noon).value().concentration, 0.01 * percent(i, j), 1e-6)
          << i << " " << j;
    }
}

/// A C grid of MITgcm in longitude and latitude as xmitgcm writes it: heights below zero that claim to be depths.
TEST_F(ProducerLayouts, MitgcmsComponentsAreReadAtTheirOwnPoints) {
  constexpr std::size_t columns = 12;
  constexpr std::size_t rows = 10;
  const auto xc = steps(-52.0 + 0.025, 0.05, columns);
  const auto xg = steps(-52.0, 0.05, columns);
  const auto yc = steps(50.0 + 0.01, 0.02, rows);
  const auto yg = steps(50.0, 0.02, rows);
  const auto speed = [](std::size_t i, std::size_t j, std::size_t level, double part) {
    return 0.3 * std::sin(part + 0.7 * static_cast<double>(i) + 1.3 * static_cast<double>(j)) /
           static_cast<double>(1 + level);
  };
  {
    NetcdfWriter file{path("mitgcm.nc")};
    const auto axis = [&](const char* name, const std::vector<double>& values, const char* standard_name,
                          const char* unit, const char* letter) {
      file.axis(name, values, {{"standard_name", standard_name}, {"units", unit}, {"axis", letter}});
    };
    axis("XC", xc, "longitude", "degrees_east", "X");
    axis("XG", xg, "longitude_at_f_location", "degrees_east", "X");
    axis("YC", yc, "latitude", "degrees_north", "Y");
    axis("YG", yg, "latitude_at_f_location", "degrees_north", "Y");
    file.axis("Z", {-5.0, -20.0}, {{"standard_name", "depth"}, {"units", "m"}, {"positive", "down"}});
    file.axis("time", {0.0}, {{"units", "seconds since 2026-11-01"}});
    for (const auto& [name, y, x, standard_name, part] :
         {std::tuple{"UVEL", "YC", "XG", "sea_water_x_velocity", 0.0},
          std::tuple{"VVEL", "YG", "XC", "sea_water_y_velocity", 2.0}}) {
      std::vector<double> values;
      for (std::size_t level = 0; level < 2; ++level)
        for (std::size_t j = 0; j < rows; ++j)
          for (std::size_t i = 0; i < columns; ++i) values.push_back(speed(i, j, level, part));
      file.variable({.name = name,
                     .dimensions = {"time", "Z", y, x},
                     .values = std::move(values),
                     .texts = {{"standard_name", standard_name}, {"units", "m/s"}},
                     .numbers = {},
                     .fill = {}});
    }
  }

  const auto report = ingest(path("mitgcm.nc"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const auto current = [&](geo::LonLat place, double depth_m) {
    return repository::FieldRepository{db_}
        .load_currents(report.dataset->id, at(place), std::nullopt, std::nullopt)
        .value()
        .at(place, {depth_m}, report.dataset->time_start.value())
        .value();
  };
  for (std::size_t j = 1; j + 1 < rows; j += 2)
    for (std::size_t i = 1; i + 1 < columns; i += 3) {
      EXPECT_NEAR(current({xg[i], yc[j]}, 5.0).east.value, speed(i, j, 0, 0.0), 1e-6);
      EXPECT_NEAR(current({xc[i], yg[j]}, 20.0).north.value, speed(i, j, 1, 2.0), 1e-6);
    }
}

}  // namespace
}  // namespace floeplan::ingest::producer_layouts_test
