#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/places.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::bed_levels_test {
namespace {

constexpr std::size_t columns = 9;
constexpr std::size_t rows = 7;
constexpr double step_deg = 0.5;

/// How a file says where its levels lie.
enum class Layout { heights_at_nodes, formula_at_nodes, formula_in_faces, formula_on_axes };

/// A sea whose current changes evenly with place and depth, so that it is known everywhere.
struct EvenSea {
  Layout layout{};
  geo::LonLat corner{-10.0, 50.0};
  bool from_the_bed{true};  // the order of the levels in the file
  bool depth_of_the_moment{false};
  double unit_m{1.0};     // of the depth of the bed
  double surface_m{0.0};  // above the mean
  double shallowest_m{100.0};
  double slope_m{5.0};  // by which the bed falls from column to column
  std::vector<double> sigma{-5.0 / 6.0, -0.5, -1.0 / 6.0};

  [[nodiscard]] static double east(geo::LonLat place, double depth_m) {
    return 0.3 + 0.01 * (place.lon_deg + 7.5) - 0.002 * depth_m;
  }
  [[nodiscard]] static double north(geo::LonLat place, double depth_m) {
    return -0.1 + 0.01 * (place.lat_deg - 52.0) + 0.001 * depth_m;
  }
  [[nodiscard]] geo::LonLat place(double column, double row) const {
    return {corner.lon_deg + step_deg * column, corner.lat_deg + step_deg * row};
  }
  /// Below the mean surface.
  [[nodiscard]] double bed_m(double column) const { return shallowest_m + slope_m * column; }
  [[nodiscard]] double column_m(double column) const { return bed_m(column) + surface_m; }
  void write(const std::filesystem::path& file) const;
};

struct Point {
  double column{};
  double row{};
};

NetcdfWriter::Variable variable(std::string name, std::vector<std::string> dimensions,
                                std::vector<double> values, std::map<std::string, std::string> texts = {},
                                std::map<std::string, double> numbers = {}) {
  return {.name = std::move(name),
          .dimensions = std::move(dimensions),
          .values = std::move(values),
          .texts = std::move(texts),
          .numbers = std::move(numbers),
          .fill = {},
          .type = NetcdfWriter::Type::float64};
}

std::vector<Point> nodes() {
  std::vector<Point> points;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column)
      points.push_back({static_cast<double>(column), static_cast<double>(row)});
  return points;
}

std::vector<std::array<std::size_t, 3>> triangles() {
  std::vector<std::array<std::size_t, 3>> faces;
  for (std::size_t row = 0; row + 1 < rows; ++row)
    for (std::size_t column = 0; column + 1 < columns; ++column) {
      const std::size_t a = row * columns + column;
      faces.push_back({a, a + 1, a + columns + 1});
      faces.push_back({a, a + columns + 1, a + columns});
    }
  return faces;
}

std::vector<Point> middles() {
  std::vector<Point> points;
  const std::vector<Point> corners = nodes();
  for (const auto& [a, b, c] : triangles())
    points.push_back({(corners[a].column + corners[b].column + corners[c].column) / 3.0,
                      (corners[a].row + corners[b].row + corners[c].row) / 3.0});
  return points;
}

void write_mesh(NetcdfWriter& writer, const EvenSea& sea) {
  writer.dimension("node", rows * columns);
  writer.dimension("face", triangles().size());
  writer.dimension("three", 3);
  writer.variable({.name = "mesh",
                   .dimensions = {},
                   .values = {0.0},
                   .texts = {{"cf_role", "mesh_topology"},
                             {"node_coordinates", "node_x node_y"},
                             {"face_node_connectivity", "face_nodes"}},
                   .numbers = {{"topology_dimension", 2.0}},
                   .fill = {},
                   .type = NetcdfWriter::Type::int32});
  std::vector<double> lons;
  std::vector<double> lats;
  for (const Point& node : nodes()) {
    lons.push_back(sea.place(node.column, node.row).lon_deg);
    lats.push_back(sea.place(node.column, node.row).lat_deg);
  }
  writer.variable(variable("node_x", {"node"}, lons, {{"units", "degrees_east"}}));
  writer.variable(variable("node_y", {"node"}, lats, {{"units", "degrees_north"}}));
  std::vector<double> corners;
  for (const auto& face : triangles())
    for (const std::size_t node : face) corners.push_back(static_cast<double>(node + 1));
  writer.variable(variable("face_nodes", {"face", "three"}, corners, {}, {{"start_index", 1.0}}));
}

void EvenSea::write(const std::filesystem::path& file) const {
  NetcdfWriter writer{file};
  writer.axis("time", {0.0}, {{"units", "hours since 2026-11-20 00:00:00"}});
  std::vector<double> shares = sigma;
  if (!from_the_bed) std::ranges::reverse(shares);
  const bool by_heights = layout == Layout::heights_at_nodes;
  std::vector<Point> points = layout == Layout::formula_in_faces ? middles() : nodes();
  std::vector<std::string> along{layout == Layout::formula_in_faces ? "face" : "node"};
  if (layout == Layout::formula_on_axes) {
    std::vector<double> lons;
    std::vector<double> lats;
    for (std::size_t i = 0; i < columns; ++i) lons.push_back(place(static_cast<double>(i), 0.0).lon_deg);
    for (std::size_t j = 0; j < rows; ++j) lats.push_back(place(0.0, static_cast<double>(j)).lat_deg);
    writer.axis("lat", lats, {{"units", "degrees_north"}});
    writer.axis("lon", lons, {{"units", "degrees_east"}});
    along = {"lat", "lon"};
  } else {
    write_mesh(writer, *this);
  }
  const std::string bed_name =
      depth_of_the_moment ? "sea_floor_depth_below_sea_surface" : "sea_floor_depth_below_mean_sea_level";
  const auto table = [&](const auto& value) {
    std::vector<double> values;
    for (const Point& point : points) values.push_back(value(point));
    return values;
  };
  if (by_heights) {
    // With the bed and the surface themselves, as SCHISM has them; the last dimension is that of the levels.
    shares.insert(from_the_bed ? shares.begin() : shares.end(), -1.0);
    shares.insert(from_the_bed ? shares.end() : shares.begin(), 0.0);
    writer.dimension("nSCHISM_vgrid_layers", shares.size());
    writer.dimension("two", 2);
    std::vector<double> heights;
    std::vector<double> velocities;
    for (const Point& point : points)
      for (const double share : shares) {
        const double depth_m = -share * column_m(point.column);
        heights.push_back(surface_m - depth_m);
        velocities.push_back(east(place(point.column, point.row), depth_m));
        velocities.push_back(north(place(point.column, point.row), depth_m));
      }
    writer.variable(variable("zcor", {"time", "node", "nSCHISM_vgrid_layers"}, heights, {{"units", "m"}}));
    writer.variable(variable("hvel", {"time", "node", "nSCHISM_vgrid_layers", "two"}, velocities,
                             {{"units", "m s-1"}, {"mesh", "mesh"}, {"location", "node"}}));
    return;
  }
  writer.axis("layer", shares,
              {{"standard_name", "ocean_sigma_coordinate"},
               {"positive", "up"},
               {"formula_terms", "sigma: layer eta: level_of_water depth: bottom"}});
  writer.variable(variable("bottom", along, table([&](const Point& point) {
                             return (depth_of_the_moment ? column_m(point.column) : bed_m(point.column)) /
                                    unit_m;
                           }),
                           {{"standard_name", bed_name}, {"units", unit_m == 1.0 ? "m" : "ft"}}));
  std::vector<std::string> in_time = along;
  in_time.insert(in_time.begin(), "time");
  writer.variable(variable("level_of_water", in_time, table([&](const Point&) { return surface_m; }),
                           {{"standard_name", "sea_surface_height_above_mean_sea_level"}, {"units", "m"}}));
  // On a mesh the levels are the last dimension, on axes the second.
  std::vector<std::string> dimensions{"time"};
  const bool on_axes = layout == Layout::formula_on_axes;
  if (on_axes) dimensions.emplace_back("layer");
  dimensions.insert(dimensions.end(), along.begin(), along.end());
  if (!on_axes) dimensions.emplace_back("layer");
  for (const bool is_u : {true, false}) {
    const auto value = [&](const Point& point, double share) {
      const double depth_m = -share * column_m(point.column);
      const geo::LonLat here = place(point.column, point.row);
      return is_u ? east(here, depth_m) : north(here, depth_m);
    };
    std::vector<double> values;
    if (on_axes) {
      for (const double share : shares)
        for (const Point& point : points) values.push_back(value(point, share));
    } else {
      for (const Point& point : points)
        for (const double share : shares) values.push_back(value(point, share));
    }
    writer.variable(
        variable(is_u ? "ucx" : "ucy", dimensions, values,
                 {{"units", "m s-1"},
                  {"standard_name", is_u ? "eastward_sea_water_velocity" : "northward_sea_water_velocity"}}));
  }
}

class BedLevels : public StoreFixture {
 protected:
  /// The currents of a file, beside which its depths may be stored, too.
  ocean::CurrentGrid stored(const std::filesystem::path& file) {
    report_ = ingest_all(file).front();
    return currents_of(report_);
  }

  IngestReport report_;
};

TEST_F(BedLevels, ArePlacedByHeightsAndByFormulasOnMeshesAndOnAxes) {
  support::for_each_seed(40, [&](std::mt19937_64& rng) {
    EvenSea sea;
    sea.layout = static_cast<Layout>(support::uniform_int(rng, 0, 3));
    sea.corner = {-10.0 + support::uniform_int(rng, 0, 4), 50.0 + support::uniform_int(rng, 0, 3)};
    sea.from_the_bed = support::uniform_int(rng, 0, 1) == 0;
    sea.depth_of_the_moment = support::uniform_int(rng, 0, 1) == 0;
    sea.surface_m = support::uniform(rng, -3.0, 3.0);
    sea.shallowest_m = support::uniform(rng, 90.0, 110.0);
    sea.slope_m = support::uniform(rng, 0.0, 6.0);
    const bool mesh_formula =
        sea.layout == Layout::formula_at_nodes || sea.layout == Layout::formula_in_faces;
    if (mesh_formula && support::uniform_int(rng, 0, 1) == 0) sea.unit_m = 0.3048;
    std::filesystem::remove(path("sea.nc"));
    sea.write(path("sea.nc"));

    const auto currents = stored(path("sea.nc"));

    const auto& samples = currents.samples();
    const std::size_t plane = samples.grid.size();
    std::size_t wet = 0;
    for (std::size_t level = 0; level < samples.depths_m->size(); ++level) {
      const double depth_m = samples.depths_m->nodes()[level];
      if (depth_m < 30.0 || depth_m > 70.0) continue;  // between the levels of every column
      for (std::size_t i = 0; i < plane; ++i) {
        const auto u = static_cast<double>(samples.u[level * plane + i]);
        const auto v = static_cast<double>(samples.v[level * plane + i]);
        if (std::isnan(u)) continue;
        ++wet;
        const std::size_t nx = samples.grid.x().size();
        const geo::LonLat here = samples.grid.place(i % nx, i / nx);
        // The outermost nodes of a mesh with currents in its faces take the mean of faces to one side.
        ASSERT_NEAR(u, EvenSea::east(here, depth_m), 5e-3) << depth_m;
        ASSERT_NEAR(v, EvenSea::north(here, depth_m), 5e-3) << depth_m;
      }
    }
    EXPECT_GT(wet, 100U);
  });
}

TEST_F(BedLevels, OfAnotherFormulaAreRefusedByItsName) {
  for (const char* const name : {"ocean_sigma_z_coordinate", "ocean_double_sigma_coordinate"}) {
    const std::filesystem::path file = path("other.nc");
    std::filesystem::remove(file);
    {
      NetcdfWriter writer{file};
      writer.axis("time", {0.0}, {{"units", "hours since 2026-11-20 00:00:00"}});
      writer.axis("layer", {-0.5, -0.1}, {{"standard_name", name}, {"formula_terms", "sigma: layer"}});
      writer.axis("lat", {50.0, 51.0, 52.0}, {{"units", "degrees_north"}});
      writer.axis("lon", {1.0, 2.0, 3.0}, {{"units", "degrees_east"}});
      for (const char* const component : {"uo", "vo"})
        writer.variable(variable(component, {"time", "layer", "lat", "lon"}, std::vector<double>(18, 0.1),
                                 {{"units", "m s-1"}}));
    }
    expect_refused(file, name);
  }
}

std::filesystem::path case_file(const std::string& name) {
  return std::filesystem::path{support::source_folder()} / "../shared/data/cases" / name;
}

/// Files as in a public report on other programs.
TEST_F(BedLevels, OfOtherModelsAreReadWhereTheirFilesSayThatTheyLie) {
  struct Sample {
    const char* file;
    double depth_m;
    double east_m_s;
  };
  if (!std::filesystem::exists(case_file("16-mesh-models-refused")))
    GTEST_SKIP() << "the sample data are not on this machine";
  for (const Sample& sample : {Sample{"schism_hvel.nc", 0.0, 0.3125}, Sample{"schism_hvel.nc", 50.0, 0.2125},
                               Sample{"delft3dfm_sigma_map.nc", 60.0, 0.3125}}) {
    SCOPED_TRACE(sample.file);
    const auto report = ingest(case_file("16-mesh-models-refused") / sample.file);
    const auto currents = currents_of(report);
    const auto water = currents.at({-7.25, 52.25}, core::Metres{sample.depth_m}, *report.dataset->time_start);
    ASSERT_TRUE(water);
    EXPECT_NEAR(water->east.value, sample.east_m_s, 2e-3);
    EXPECT_NEAR(water->north.value, -0.0875, 2e-3);
  }
}

}  // namespace
}  // namespace floeplan::ingest::bed_levels_test
