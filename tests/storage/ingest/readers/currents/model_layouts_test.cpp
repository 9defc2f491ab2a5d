#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <random>

#include "engine/geo/geodesic.hpp"
#include "engine/geo/tangent_plane.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/model_grid_writer.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::model_layouts_test {
namespace {

using testing::HasSubstr;

bool no_land(std::size_t /*i*/, std::size_t /*j*/) { return false; }

class ModelLayouts : public StoreFixture {
 protected:
  ocean::CurrentGrid stored(const std::vector<std::filesystem::path>& files) {
    report_ = ingest_together(files);
    return currents_of(report_);
  }
  ocean::CurrentGrid stored_nemo(const ModelGrid& grid) {
    write_nemo(grid, path("u.nc"), path("v.nc"), no_land);
    return stored({path("u.nc"), path("v.nc")});
  }

  IngestReport report_;
};

/// Compares every node of one level with the known field, times `share`; at least `least` nodes must have water. The
/// tolerance is that between angles on the models' sphere and on the ellipsoid, 0.1 degrees.
void expect_turning_sea(const ocean::CurrentGrid& currents, std::size_t level, double share,
                        std::size_t least, double tolerance = 1e-3) {
  const auto& samples = currents.samples();
  const std::size_t nx = samples.grid.x().size();
  std::size_t wet = 0;
  for (std::size_t iy = 0; iy < samples.grid.y().size(); ++iy) {
    for (std::size_t ix = 0; ix < nx; ++ix) {
      const std::size_t i = (level * samples.grid.y().size() + iy) * nx + ix;
      if (std::isnan(samples.u[i])) continue;
      ++wet;
      const geo::VelocityEn truth = turning_sea(samples.grid.place(ix, iy));
      ASSERT_NEAR(samples.u[i], share * truth.east.value, tolerance) << ix << " " << iy;
      ASSERT_NEAR(samples.v[i], share * truth.north.value, tolerance) << ix << " " << iy;
    }
  }
  EXPECT_GE(wet, least);
}

TEST_F(ModelLayouts, StaggeredComponentsInTwoFilesBecomeEastAndNorth) {
  const auto currents = stored_nemo({});

  expect_turning_sea(currents, 0, 1.0, 3500);
  expect_turning_sea(currents, 1, 0.5, 3500);
  EXPECT_THAT(currents.samples().depths_m->nodes(), testing::ElementsAre(0.5, 10.0));
  EXPECT_EQ(report_.file, "u.nc + v.nc");
  EXPECT_THAT(words(report_), HasSubstr("turned to east and north"));
  EXPECT_THAT(words(report_), HasSubstr("kept at the model's own"));
}

TEST_F(ModelLayouts, TheOrderOfTheTwoFilesPlaysNoPart) {
  write_nemo({}, path("u.nc"), path("v.nc"), no_land);
  expect_turning_sea(stored({path("v.nc"), path("u.nc")}), 0, 1.0, 3500);
}

TEST_F(ModelLayouts, AGridMayBeTurnedByAnyAngle) {
  for (const double turned_deg : {-170.0, -90.0, 0.0, 33.0, 120.0, 180.0})
    expect_turning_sea(stored_nemo({.turned_deg = turned_deg}), 0, 1.0, 3000);
}

TEST_F(ModelLayouts, AGridMayLieAcrossTheDateLine) {
  const auto currents = stored_nemo({.origin = {179.7, -60.0}, .turned_deg = 25.0});

  expect_turning_sea(currents, 0, 1.0, 3000);
  EXPECT_TRUE(currents.at({179.9, -60.0}, {1.0}, core::from_unix_seconds(1795132800.0)).has_value());
  EXPECT_TRUE(currents.at({-179.9, -60.0}, {1.0}, core::from_unix_seconds(1795132800.0)).has_value());
  EXPECT_LT(geo::width_deg(report_.dataset->bounds), 30.0);
}

TEST_F(ModelLayouts, AGridMayLieAcrossAPole) {
  for (const double lat_deg : {89.0, -89.0}) {
    const auto currents = stored_nemo({.origin = {30.0, lat_deg}});
    expect_turning_sea(currents, 0, 1.0, 3000);
    EXPECT_TRUE(std::holds_alternative<geo::PolarStereographicFrame>(currents.samples().grid.frame()));
    EXPECT_TRUE(
        currents.at({0.0, std::copysign(90.0, lat_deg)}, {1.0}, core::from_unix_seconds(1795132800.0)));
  }
}

TEST_F(ModelLayouts, AGridMayHaveTwoPolesAndAFoldBetweenThem) {
  const auto currents = stored_nemo({.columns = 242, .rows = 82, .two_poles = true});

  const auto& samples = currents.samples();
  const std::size_t nx = samples.grid.x().size();
  constexpr double least_m = 1e6;  // from the grid's poles, which a model puts on land
  double largest = 0.0;
  std::size_t wet = 0;
  for (std::size_t i = 0; i < samples.grid.size(); ++i) {
    const geo::LonLat place = samples.grid.place(i % nx, i / nx);
    if (std::isnan(samples.u[i]) || geo::geodesic_between(place, {15.0, 60.0}).length.value < least_m ||
        geo::geodesic_between(place, {-165.0, 60.0}).length.value < least_m)
      continue;
    ++wet;
    const geo::VelocityEn truth = turning_sea(place);
    largest = std::max(largest, std::hypot(static_cast<double>(samples.u[i]) - truth.east.value,
                                           static_cast<double>(samples.v[i]) - truth.north.value));
  }
  EXPECT_GT(wet, samples.grid.size() / 2);
  EXPECT_LT(largest, 2e-3);
  EXPECT_TRUE(
      currents.at({15.0, 89.9}, core::Metres{0.5}, core::from_unix_seconds(currents.times_s().front())));
}

TEST_F(ModelLayouts, CollocatedComponentsAlongABentGridAreTurned) {
  write_pop({.origin = {-40.0, 50.0}}, path("pop.nc"));

  const auto currents = stored({path("pop.nc")});

  expect_turning_sea(currents, 0, 1.0, 3500);
  EXPECT_THAT(currents.samples().depths_m->nodes(), testing::ElementsAre(5.0, 15.0));
}

TEST_F(ModelLayouts, LandWrittenAsZeroOnAStaggeredGridIsMissing) {
  const ModelGrid grid;
  write_nemo(grid, path("u.nc"), path("v.nc"), [](std::size_t i, std::size_t) { return i >= 25; });

  const auto currents = stored({path("u.nc"), path("v.nc")});

  const auto when = core::from_unix_seconds(1795132800.0);
  EXPECT_FALSE(currents.at(grid.place(32, 15), {1.0}, when).has_value());
  EXPECT_TRUE(currents.at(grid.place(15, 15), {1.0}, when).has_value());
  EXPECT_THAT(words(report_), HasSubstr("count as land"));
}

/// The model's own components at random points of a C grid, as the currents that are stored have them along the axes.
void expect_own_components(const ModelGrid& grid, const std::string& what,
                           const std::function<std::optional<geo::VelocityEn>(geo::LonLat)>& current,
                           const std::function<double(double, double, bool)>& axis_rad) {
  std::mt19937_64 rng{11};
  for (int n = 0; n < 200; ++n) {
    const bool first = n % 2 == 0;
    const double i = 1.0 + static_cast<double>(rng() % (grid.columns - 3)) + (first ? 0.5 : 0.0);
    const double j = 1.0 + static_cast<double>(rng() % (grid.rows - 3)) + (first ? 0.0 : 0.5);
    const auto water = current(grid.place(i, j));
    ASSERT_TRUE(water.has_value()) << what << " " << i << " " << j;
    const double axis = axis_rad(i, j, first);
    ASSERT_NEAR(water->east.value * std::cos(axis) + water->north.value * std::sin(axis),
                first ? grid.first(i, j) : grid.second(i, j), 1e-6)
        << what << " " << i << " " << j;
  }
}

TEST_F(ModelLayouts, APointOfACGridHasTheModelsOwnComponent) {
  for (const geo::LonLat origin :
       {geo::LonLat{15.0, 70.0}, geo::LonLat{179.8, -60.0}, geo::LonLat{40.0, 89.3}}) {
    const ModelGrid grid{.origin = origin};
    repository::DatasetId id;
    const auto current = [&](geo::LonLat place) {
      const auto found = repository::FieldRepository{db_}.load_currents(
          id, {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg}, std::nullopt, std::nullopt);
      return found ? found->at(place, {0.5}, core::from_unix_seconds(1795132800.0)) : std::nullopt;
    };

    write_nemo(grid, path("u.nc"), path("v.nc"), no_land);
    id = ingest_together({path("u.nc"), path("v.nc")}).dataset.value().id;
    expect_own_components(grid, "nemo", current, [&](double i, double j, bool first) {
      const double di = first ? 1.0 : 0.0;
      const double dj = first ? 0.0 : 1.0;
      return geo::direction_at(grid.place(i, j), grid.place(i - di, j - dj), grid.place(i + di, j + dj))
          .value();
    });

    write_roms(grid, path("roms.nc"), {});
    id = ingest(path("roms.nc")).dataset.value().id;
    expect_own_components(grid, "roms", current, [&](double i, double j, bool first) {
      const double half_i = first ? 0.5 : 0.0;
      const double half_j = first ? 0.0 : 0.5;
      const double before = grid.angle(i - half_i, j - half_j);
      const double turn = std::remainder(grid.angle(i + half_i, j + half_j) - before, 2.0 * std::numbers::pi);
      return before + 0.5 * turn + (first ? 0.0 : 0.5 * std::numbers::pi);
    });
    std::filesystem::remove(path("roms.nc"));
  }
}

TEST_F(ModelLayouts, NothingFlowsThroughAWallAcrossAStaggeredGrid) {
  const ModelGrid grid{.origin = {-30.0, 65.0}};
  write_roms(grid, path("roms.nc"), {.wall_after = 20, .wall_rows = 18});
  const auto id = ingest(path("roms.nc")).dataset.value().id;
  const auto current = [&](double i, double j) {
    const geo::LonLat place = grid.place(i, j);
    const auto found = repository::FieldRepository{db_}.load_currents(
        id, {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg}, std::nullopt, std::nullopt);
    const auto water = found.value().at(place, {5.0}, core::from_unix_seconds(1795132800.0)).value();
    return water.east.value * std::cos(grid.angle(i, j)) + water.north.value * std::sin(grid.angle(i, j));
  };

  for (double j = 2.0; j < 17.4; j += 0.3) EXPECT_NEAR(current(20.5, j), 0.0, 1e-4) << j;
  EXPECT_NEAR(current(20.5, 17.8), grid.first(20.5, 17.8), 2e-3);  // past its end
  EXPECT_NEAR(current(19.5, 10.0), grid.first(19.5, 10.0), 2e-3);  // a cell before it
}

TEST_F(ModelLayouts, OneComponentAloneAsksForTheOther) {
  write_nemo({}, path("u.nc"), path("v.nc"), no_land);
  expect_refused(path("u.nc"), "in the same command");
}

TEST_F(ModelLayouts, ComponentsOfDifferentTimesAreNotPutTogether) {
  write_nemo({}, path("u.nc"), path("v.nc"), no_land);
  write_nemo({.turned_deg = 0.0}, path("u2.nc"), path("v2.nc"), no_land);
  const auto reports = ingest_all_together({path("u.nc"), path("v2.nc")});
  ASSERT_EQ(reports.size(), 1U);
  EXPECT_EQ(reports[0].status, IngestStatus::refused);
  EXPECT_THAT(words(reports[0]), HasSubstr("neither at the same points nor half a cell apart"));
}

TEST_F(ModelLayouts, LevelsThatFollowTheBedBecomeDepthsBelowTheSurface) {
  for (const int transform : {1, 2}) {
    write_roms({}, path("roms.nc"), {.transform = transform, .shear_per_m = 0.004});

    const auto currents = stored({path("roms.nc")});

    const auto& depths = currents.samples().depths_m->nodes();
    ASSERT_GT(depths.size(), 20U);
    for (std::size_t level = 1; level < 16; ++level) {  // above the lowest and below the uppermost level
      const double share = 1.0 - 0.004 * depths[level];
      expect_turning_sea(currents, level, share, 3000, 3e-3);
    }
    std::filesystem::remove(path("roms.nc"));
  }
}

TEST_F(ModelLayouts, BelowTheBedThereIsNoCurrent) {
  const ModelGrid grid;
  write_roms(grid, path("roms.nc"), {});

  const auto currents = stored({path("roms.nc")});

  const auto when = core::from_unix_seconds(1795132800.0);
  EXPECT_TRUE(currents.at(grid.place(5, 15), {110.0}, when).has_value());
  EXPECT_FALSE(currents.at(grid.place(5, 15), {150.0}, when).has_value());
  EXPECT_TRUE(currents.at(grid.place(30, 15), {150.0}, when).has_value());
}

TEST_F(ModelLayouts, PositionsOfTheComponentsFollowFromThoseOfTheCentres) {
  write_roms({}, path("roms.nc"), {.with_positions_of_components = false, .with_angle = false});
  expect_turning_sea(stored({path("roms.nc")}), 0, 1.0, 3000);
}

TEST_F(ModelLayouts, AnAngleThatContradictsThePositionsIsRefused) {
  write_roms({}, path("roms.nc"), {.angle_error_deg = 10.0});
  expect_refused(path("roms.nc"), "contradicts");
}

/// Faces of six corners, of four and of three in one mesh, as Delft3D FM has them: places that a face lacks are filled.
void write_mixed_mesh(const std::filesystem::path& file, bool in_faces) {
  constexpr std::size_t columns = 7;
  constexpr std::size_t rows = 7;
  constexpr double step_deg = 0.02;
  const auto node = [&](std::size_t i, std::size_t j) { return static_cast<double>(j * columns + i + 1); };
  const auto lon_of = [](double i) { return 3.0 + step_deg * i; };
  const auto lat_of = [](double j) { return 55.0 + step_deg * j; };
  std::vector<double> corners;
  std::vector<std::pair<double, double>> middles;
  const auto add = [&](const std::vector<std::pair<std::size_t, std::size_t>>& face) {
    double i = 0.0;
    double j = 0.0;
    for (const auto& [column, row] : face) {
      corners.push_back(node(column, row));
      i += static_cast<double>(column) / static_cast<double>(face.size());
      j += static_cast<double>(row) / static_cast<double>(face.size());
    }
    corners.insert(corners.end(), 6 - face.size(), -999.0);
    middles.emplace_back(i, j);
  };
  for (std::size_t j = 0; j + 1 < rows; ++j)
    for (std::size_t i = 0; i + 2 < columns; i += 2) {
      if (j % 3 == 0) {
        add({{i, j}, {i + 1, j}, {i + 2, j}, {i + 2, j + 1}, {i + 1, j + 1}, {i, j + 1}});
      } else if (j % 3 == 1) {
        add({{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
        add({{i + 1, j}, {i + 2, j}, {i + 2, j + 1}, {i + 1, j + 1}});
      } else {
        add({{i, j}, {i + 1, j}, {i, j + 1}});
        add({{i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
        add({{i + 1, j}, {i + 2, j}, {i + 2, j + 1}, {i + 1, j + 1}});
      }
    }
  NetcdfWriter writer{file};
  writer.axis("time", {0.0}, {{"units", "hours since 2026-11-20 00:00:00"}, {"standard_name", "time"}});
  writer.dimension("node", columns * rows);
  writer.dimension("face", middles.size());
  writer.dimension("most", 6);
  const auto variable = [&](const std::string& name, const std::vector<std::string>& dimensions,
                            const std::vector<double>& values, std::map<std::string, std::string> texts,
                            std::optional<double> fill = {}, std::map<std::string, double> numbers = {}) {
    writer.variable({.name = name,
                     .dimensions = dimensions,
                     .values = values,
                     .texts = std::move(texts),
                     .numbers = std::move(numbers),
                     .fill = fill,
                     .type = NetcdfWriter::Type::float64});
  };
  variable("mesh", {}, {0.0},
           {{"cf_role", "mesh_topology"},
            {"node_coordinates", "node_lon node_lat"},
            {"face_node_connectivity", "face_nodes"}},
           {}, {{"topology_dimension", 2.0}});
  std::vector<double> lons;
  std::vector<double> lats;
  std::vector<std::pair<double, double>> at;
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      lons.push_back(lon_of(static_cast<double>(i)));
      lats.push_back(lat_of(static_cast<double>(j)));
      at.emplace_back(i, j);
    }
  variable("node_lon", {"node"}, lons, {{"units", "degrees_east"}, {"standard_name", "longitude"}});
  variable("node_lat", {"node"}, lats, {{"units", "degrees_north"}, {"standard_name", "latitude"}});
  variable("face_nodes", {"face", "most"}, corners, {{"cf_role", "face_node_connectivity"}}, -999.0,
           {{"start_index", 1.0}});
  if (in_faces) at = middles;
  std::vector<double> u;
  std::vector<double> v;
  for (const auto& [i, j] : at) {
    u.push_back(0.1 + 0.01 * i);
    v.push_back(0.2 - 0.01 * j);
  }
  const std::string place = in_faces ? "face" : "node";
  variable("u", {"time", place}, u,
           {{"units", "m s-1"},
            {"standard_name", "eastward_sea_water_velocity"},
            {"mesh", "mesh"},
            {"location", place}});
  variable("v", {"time", place}, v,
           {{"units", "m s-1"},
            {"standard_name", "northward_sea_water_velocity"},
            {"mesh", "mesh"},
            {"location", place}});
}

TEST_F(ModelLayouts, FacesOfAMeshMayHaveUpToTwelveCorners) {
  for (const bool in_faces : {false, true}) {
    write_mixed_mesh(path(in_faces ? "faces.nc" : "nodes.nc"), in_faces);
    const IngestReport report = ingest(path(in_faces ? "faces.nc" : "nodes.nc"));
    ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
    const ocean::CurrentGrid currents = currents_of(report);
    const auto time = core::from_unix_seconds(currents.samples().times_s.front());
    for (double i = 1.0; i <= 5.0; i += 0.5)
      for (double j = 1.0; j <= 5.0; j += 0.5) {
        const auto current = currents.at({3.0 + 0.02 * i, 55.0 + 0.02 * j}, core::Metres{0.0}, time);
        ASSERT_TRUE(current) << i << " " << j;
        EXPECT_NEAR(current->east.value, 0.1 + 0.01 * i, in_faces ? 4e-3 : 1e-4) << i << " " << j;
        EXPECT_NEAR(current->north.value, 0.2 - 0.01 * j, in_faces ? 4e-3 : 1e-4) << i << " " << j;
      }
  }
}

TEST_F(ModelLayouts, FacesOfAMeshAreInterpolatedAtDepthsAboveASigmaBed) {
  for (const geo::LonLat origin : {geo::LonLat{15.0, 70.0}, geo::LonLat{179.9, -55.0}}) {
    write_fvcom({.origin = origin}, path("fvcom.nc"));

    const auto currents = stored({path("fvcom.nc")});

    expect_turning_sea(currents, 0, 1.0, 2500,
                       5e-3);  // the outermost nodes take the mean of faces to one side
    expect_turning_sea(currents, 4, 0.75, 2500, 5e-3);  // 20 m, between the layers at 10 and 30 m
    EXPECT_EQ(currents.samples().depths_m->back(), 40.0);
    EXPECT_THAT(words(report_), HasSubstr("the faces of a mesh"));
    std::filesystem::remove(path("fvcom.nc"));
  }
}

TEST_F(ModelLayouts, TheSameFileThatAnOlderVersionResampledMakesADatasetOfItsOwn) {
  write_fvcom({.origin = {15.0, 70.0}}, path("fvcom.nc"));
  const auto native = ingest(path("fvcom.nc"));
  ASSERT_EQ(native.status, IngestStatus::stored) << words(native);
  repository::DatasetRepository datasets{db_};
  datasets.remove(native.dataset->id);
  repository::Dataset resampled = *native.dataset;
  resampled.id = {"currents-" + resampled.provenance.sha256.substr(0, 8)};
  resampled.warnings = {"resampled from the faces of a mesh to a regular grid of 0.05 x 0.05 degrees"};
  datasets.insert(resampled);

  const auto again = ingest(path("fvcom.nc"));

  EXPECT_EQ(again.status, IngestStatus::stored) << words(again);
  EXPECT_EQ(again.dataset->id, native.dataset->id);
  EXPECT_NE(again.dataset->id, resampled.id);
  EXPECT_TRUE(datasets.find(resampled.id).has_value());
  EXPECT_EQ(ingest(path("fvcom.nc")).status, IngestStatus::unchanged);
  EXPECT_EQ(stored_datasets(), 2U);
}

TEST_F(ModelLayouts, AProjectedPlaneKeepsItsFrameAndItsVectorsAreTurned) {
  for (const bool along_axes : {true, false}) {
    write_polar_plane(path("polar.nc"), {.along_axes = along_axes});

    const auto currents = stored({path("polar.nc")});

    expect_turning_sea(currents, 0, 1.0, 12);
    EXPECT_TRUE(std::holds_alternative<geo::PolarStereographicFrame>(currents.samples().grid.frame()));
    EXPECT_EQ(currents.samples().grid.y().front(), -700000.0);
    std::filesystem::remove(path("polar.nc"));
  }
}

TEST_F(ModelLayouts, APlaneThatContradictsItsTablesIsPlacedByTheTables) {
  write_polar_plane(path("topaz.nc"), {.as_topaz = true});
  expect_turning_sea(stored({path("topaz.nc")}), 0, 1.0, 20, 3e-3);  // nodes 50 km apart
  EXPECT_THAT(words(report_), HasSubstr("kept at the model's own"));
}

/// Components half a cell apart on plain axes, as MOM6 writes them: u on (yh, xq), v on (yq, xh).
void write_mom6(const std::filesystem::path& file, double south_deg) {
  constexpr std::size_t side = 12;
  NetcdfWriter writer{file};
  const auto axis = [&](const std::string& name, double from, const std::string& units) {
    std::vector<double> nodes;
    for (std::size_t i = 0; i < side; ++i) nodes.push_back(from + 0.25 * static_cast<double>(i));
    writer.axis(name, nodes, {{"units", units}});
    return nodes;
  };
  writer.axis("time", {0.0}, {{"units", "hours since 2026-11-20"}});
  const auto xh = axis("xh", -300.0, "degrees_east");
  const auto xq = axis("xq", -299.875, "degrees_east");
  const auto yh = axis("yh", south_deg, "degrees_north");
  const auto yq = axis("yq", south_deg + 0.125, "degrees_north");
  for (const bool is_u : {true, false}) {
    std::vector<double> values;
    for (const double lat : is_u ? yh : yq)
      for (const double lon : is_u ? xq : xh) {
        const geo::VelocityEn water = turning_sea({lon, lat});
        values.push_back(is_u ? water.east.value : water.north.value);
      }
    const std::string axis_name = is_u ? "x" : "y";
    writer.variable({.name = is_u ? "uo" : "vo",
                     .dimensions = {"time", is_u ? "yh" : "yq", is_u ? "xq" : "xh"},
                     .values = std::move(values),
                     .texts = {{"units", "m s-1"}, {"standard_name", "sea_water_" + axis_name + "_velocity"}},
                     .numbers = {},
                     .fill = {},
                     .type = NetcdfWriter::Type::float64});
  }
}

TEST_F(ModelLayouts, ComponentsHalfACellApartOnPlainAxesAreBroughtTogether) {
  write_mom6(path("mom6.nc"), -40.0);
  expect_turning_sea(stored({path("mom6.nc")}), 0, 1.0, 350);
}

TEST_F(ModelLayouts, PlainAxesInTheFarNorthAreNotBelievedToBeStraight) {
  write_mom6(path("mom6.nc"), 70.0);
  expect_refused(path("mom6.nc"), "bent round poles on land");
}

TEST_F(ModelLayouts, ABentGridWithoutPositionsAsksForTheGridFile) {
  NetcdfWriter writer{path("bare.nc")};
  writer.axis("ocean_time", {0.0}, {{"units", "hours since 2026-11-20"}});
  for (const char* name : {"eta_u", "xi_u", "eta_v", "xi_v"}) writer.dimension(name, 5);
  for (const std::string name : {"u", "v"})
    writer.variable({.name = name,
                     .dimensions = {"ocean_time", "eta_" + name, "xi_" + name},
                     .values = std::vector<double>(25, 0.1),
                     .texts = {{"units", "m/s"}},
                     .numbers = {},
                     .fill = {},
                     .type = NetcdfWriter::Type::float64});
  expect_refused(path("bare.nc"), "grid or mesh file in the same command");
}

}  // namespace
}  // namespace floeplan::ingest::model_layouts_test
