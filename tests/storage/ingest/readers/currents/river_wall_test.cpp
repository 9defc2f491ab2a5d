#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>

#include "engine/core/utc_text.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/model_grid_writer.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::river_wall_test {
namespace {

/// A river that flows east with 0.5 m/s, and a wall of dry points across it, from the southern bank up to a gap. Models
/// with both components at the same points know a wall only by such points; a C grid has closed faces, for which see
/// `ModelLayouts`.
class RiverWithAWall : public StoreFixture {
 protected:
  static constexpr std::size_t columns = 16;
  static constexpr std::size_t rows = 12;
  static constexpr std::size_t wall = 7;       // column
  static constexpr std::size_t wall_rows = 8;  // the rows beyond are the gap

  static bool is_dry(std::size_t i, std::size_t j) { return i == wall && j < wall_rows; }

  std::optional<geo::VelocityEn> current_at(const IngestReport& report, geo::LonLat place) {
    const auto& dataset = report.dataset.value();
    const auto found = repository::FieldRepository{db_}.load_currents(
        dataset.id, {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg}, std::nullopt, std::nullopt);
    return found ? found->at(place, {5.0}, dataset.time_start.value()) : std::nullopt;
  }

  /// `place`        of a point by its column and row, which may lie between two
  /// `half_width`   of the wall, in columns: places nearer to it have no current
  void expect_no_flow_through_the_wall(const IngestReport& report,
                                       const std::function<geo::LonLat(double, double)>& place,
                                       double half_width) {
    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    const auto for_plans =
        repository::FieldRepository{db_}
            .load_currents(report.dataset->id, {-180.0, -90.0, 180.0, 90.0}, std::nullopt, std::nullopt)
            .value();
    support::for_each_seed(60, [&](std::mt19937_64& rng) {
      const double j = support::uniform(rng, 0.1, wall_rows - 1.0);
      const geo::LonLat inside = place(wall + support::uniform(rng, -0.99, 0.99) * half_width, j);
      EXPECT_FALSE(current_at(report, inside).has_value()) << j;
      EXPECT_FALSE(for_plans.at(place(wall, j), {5.0}, report.dataset->time_start.value()).has_value()) << j;

      const double side = support::uniform_int(rng, 0, 1) == 0 ? -1.0 : 1.0;
      const auto beside = current_at(report, place(wall + side * (half_width + 0.05), j));
      ASSERT_TRUE(beside.has_value()) << j;
      EXPECT_NEAR(beside->east.value, 0.5, 1e-3) << "water beside a wall is not slowed down";
    });
    const auto gap = current_at(report, place(wall, wall_rows + 1.5));
    ASSERT_TRUE(gap.has_value());
    EXPECT_NEAR(gap->east.value, 0.5, 1e-3);
  }
};

/// Between four points of a grid in longitude and latitude all must be wet: the wall is two columns wide.
TEST_F(RiverWithAWall, OnARegularGridLetsNothingThrough) {
  CurrentFile file;
  file.lons.clear();
  file.lats.clear();
  for (std::size_t i = 0; i < columns; ++i) file.lons.push_back(-52.0 + 0.1 * static_cast<double>(i));
  for (std::size_t j = 0; j < rows; ++j) file.lats.push_back(69.0 + 0.05 * static_cast<double>(j));
  file.fill = -999.0;
  file.value = [](char component, std::size_t, std::size_t, std::size_t j, std::size_t i) {
    if (is_dry(i, j)) return -999.0;
    return component == 'u' ? 0.5 : 0.0;
  };
  file.write(path("river.nc"));

  expect_no_flow_through_the_wall(
      ingest(path("river.nc")),
      [](double i, double j) { return geo::LonLat{-52.0 + 0.1 * i, 69.0 + 0.05 * j}; }, 1.0);
}

/// Between points of a bent grid a place belongs to the wall where the dry points have more than half of the weight.
TEST_F(RiverWithAWall, OnABentGridWithBothComponentsAtItsPointsLetsNothingThrough) {
  const ModelGrid grid{.turned_deg = 25.0, .spacing_m = 5000.0, .columns = columns, .rows = rows};
  std::vector<double> lon_deg;
  std::vector<double> lat_deg;
  std::vector<double> east;
  std::vector<double> north;
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const geo::LonLat place = grid.place(static_cast<double>(i), static_cast<double>(j));
      lon_deg.push_back(place.lon_deg);
      lat_deg.push_back(place.lat_deg);
      east.push_back(is_dry(i, j) ? -999.0 : 0.5);
      north.push_back(is_dry(i, j) ? -999.0 : 0.0);
    }
  {
    NetcdfWriter file{path("river.nc")};
    file.axis("time", {0.0}, {{"units", "hours since 2026-11-20 00:00:00"}});
    file.dimension("y", rows);
    file.dimension("x", columns);
    const auto add = [&](const std::string& name, std::vector<std::string> dimensions,
                         const std::vector<double>& values, const std::map<std::string, std::string>& texts) {
      file.variable({.name = name,
                     .dimensions = std::move(dimensions),
                     .values = values,
                     .texts = texts,
                     .numbers = {},
                     .fill = -999.0,
                     .type = NetcdfWriter::Type::float64});
    };
    add("nav_lon", {"y", "x"}, lon_deg, {{"units", "degrees_east"}});
    add("nav_lat", {"y", "x"}, lat_deg, {{"units", "degrees_north"}});
    for (const auto& [name, values, standard_name] :
         {std::tuple{"uo", &east, "eastward_sea_water_velocity"},
          std::tuple{"vo", &north, "northward_sea_water_velocity"}})
      add(name, {"time", "y", "x"}, *values,
          {{"units", "m s-1"}, {"standard_name", standard_name}, {"coordinates", "nav_lon nav_lat"}});
  }

  expect_no_flow_through_the_wall(
      ingest(path("river.nc")), [&](double i, double j) { return grid.place(i, j); }, 0.5);
}

/// A bay of ADCIRC: places by column and row, each cell of which is two triangles.
class RiverOfTriangles : public RiverWithAWall {
 protected:
  static geo::LonLat place(double i, double j) { return {-52.0 + 0.1 * i, 69.0 + 0.05 * j}; }
  static std::size_t node(std::size_t i, std::size_t j) { return j * columns + i + 1; }

  IngestReport ingest_river(std::size_t dam, const std::function<double(std::size_t, std::size_t)>& east) {
    std::ostringstream mesh;
    mesh.precision(10);
    const std::size_t across = dam > 0 ? columns - 2 : columns - 1;
    mesh << "a river\n" << 2 * across * (rows - 1) << ' ' << columns * rows << '\n';
    for (std::size_t j = 0; j < rows; ++j)
      for (std::size_t i = 0; i < columns; ++i) {
        const geo::LonLat at =
            place(static_cast<double>(dam > 0 && i >= dam ? i - 1 : i), static_cast<double>(j));
        mesh << node(i, j) << ' ' << at.lon_deg << ' ' << at.lat_deg << " 20\n";
      }
    std::size_t element = 0;
    for (std::size_t j = 0; j + 1 < rows; ++j)
      for (std::size_t i = 0; i + 1 < columns; ++i) {
        if (dam > 0 && i + 1 == dam) continue;
        mesh << ++element << " 3 " << node(i, j) << ' ' << node(i + 1, j) << ' ' << node(i, j + 1) << '\n'
             << ++element << " 3 " << node(i + 1, j) << ' ' << node(i + 1, j + 1) << ' ' << node(i, j + 1)
             << '\n';
      }
    mesh << "0 = Number of open boundaries\n0 = Total number of open boundary nodes\n";
    write_file("fort.14", mesh.str());
    std::ostringstream run;
    run << "a river run\n1 " << columns * rows << " 3600.0 720 2 FileFmtVersion: 1050624\n 3600 720\n";
    for (std::size_t j = 0; j < rows; ++j)
      for (std::size_t i = 0; i < columns; ++i) run << node(i, j) << ' ' << east(i, j) << " 0.0\n";
    write_file("fort.64", run.str());
    return ingest_together({path("fort.14"), path("fort.64")},
                           {.time = core::parse_iso8601("2026-03-01T00:00:00Z")});
  }
};

TEST_F(RiverOfTriangles, WithDryNodesLetsNothingThrough) {
  const auto report =
      ingest_river(0, [](std::size_t i, std::size_t j) { return is_dry(i, j) ? -99999.0 : 0.5; });

  expect_no_flow_through_the_wall(report, place, 0.5);
}

/// A dam without width, as ADCIRC has them: the nodes of both banks lie at the same places, and no triangle joins them.
TEST_F(RiverOfTriangles, WithADamKeepsTheWaterOfBothSidesApart) {
  const auto report = ingest_river(8, [](std::size_t i, std::size_t) { return i < 8 ? 0.5 : -0.3; });

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    const double j = support::uniform(rng, 0.1, rows - 1.1);
    const double off = support::uniform(rng, 0.001, 0.9);
    EXPECT_NEAR(current_at(report, place(7.0 - off, j)).value().east.value, 0.5, 1e-5) << off;
    EXPECT_NEAR(current_at(report, place(7.0 + off, j)).value().east.value, -0.3, 1e-5) << off;
  });
}

}  // namespace
}  // namespace floeplan::ingest::river_wall_test
