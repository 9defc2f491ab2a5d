#include "storage/repository/fields/native_currents.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "engine/ocean/currents/level_columns.hpp"
#include "engine/ocean/grids/mesh_lattice.hpp"
#include "engine/ocean/grids/mesh_sampling.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/repository/fields/forecast_runs.hpp"
#include "storage/repository/fields/mesh_blocks.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/empty_store.hpp"
#include "tests/support/property.hpp"

namespace floeplan::repository::native_currents_test {
namespace {

/// Triangles between points of rows and columns in any order; with their middles as points, too, where the values are
/// those of faces.
ocean::Mesh mesh_of(std::mt19937_64& rng, std::uint32_t rows, std::uint32_t columns, bool in_faces) {
  ocean::Mesh mesh;
  mesh.in_faces = in_faces;
  std::vector<std::uint32_t> numbers(std::size_t{rows} * columns);
  std::iota(numbers.begin(), numbers.end(), 0U);
  std::ranges::shuffle(numbers, rng);
  mesh.points.resize(numbers.size());
  const auto node = [&](std::uint32_t row, std::uint32_t column) { return numbers[row * columns + column]; };
  for (std::uint32_t row = 0; row < rows; ++row)
    for (std::uint32_t column = 0; column < columns; ++column)
      mesh.points[node(row, column)] = {178.0 + 0.05 * column + support::uniform(rng, -0.01, 0.01),
                                        66.0 + 0.02 * row + support::uniform(rng, -0.004, 0.004)};
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (!in_faces) {
      mesh.cells.push_back({a, b, c, c});
      return;
    }
    const auto mean = [&](auto part) {
      return (mesh.points[a].*part + mesh.points[b].*part + mesh.points[c].*part) / 3.0;
    };
    const auto middle = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back({mean(&geo::LonLat::lon_deg), mean(&geo::LonLat::lat_deg)});
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
      mesh.cells.push_back({middle, from, to, to});
  };
  for (std::uint32_t row = 0; row + 1 < rows; ++row)
    for (std::uint32_t column = 0; column + 1 < columns; ++column) {
      add(node(row, column), node(row, column + 1), node(row + 1, column));
      add(node(row, column + 1), node(row + 1, column + 1), node(row + 1, column));
    }
  for (geo::LonLat& point : mesh.points) point.lon_deg = geo::wrap_longitude(point.lon_deg);
  return mesh;
}

geo::BoundingBox at(geo::LonLat place) {
  return {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg};
}

class NativeCurrents : public testing::Test {
 protected:
  static constexpr double start_s = 1.8e9;

  std::vector<float> noise(std::mt19937_64& rng, const ocean::Mesh& mesh) const {
    std::vector<float> values;
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
      values.push_back(static_cast<float>(support::uniform(rng, -1.0, 1.0)));
    if (mesh.in_faces)
      for (const ocean::Mesh::Cell& cell : mesh.cells)
        for (const std::uint32_t corner : {cell[1], cell[2]}) values[corner] = ocean::missing_sample;
    return values;
  }

  void create(const ocean::Mesh& mesh, const std::optional<ocean::Axis>& depths_m, std::size_t bed_levels,
              std::size_t times = 1) {
    DatasetRepository{db_}.remove(id_);
    DatasetRepository{db_}.insert(sample_dataset(id_.value, DatasetKind::currents));
    std::vector<double> times_s;
    for (std::size_t i = 0; i < times; ++i) times_s.push_back(start_s + 3600.0 * static_cast<double>(i));
    fields_.create(id_, {ocean::lattice_for(mesh).value(), depths_m, ocean::Axis{times_s}},
                   {mesh, bed_levels});
  }

  std::optional<geo::VelocityEn> velocity(geo::LonLat place, double depth_m, double time_s = start_s) const {
    const auto found = fields_.load_currents(id_, at(place), std::nullopt, std::nullopt);
    return found ? found->at(place, {depth_m}, core::from_unix_seconds(time_s)) : std::nullopt;
  }

  const DatasetId id_{"native"};
  sql::Connection db_ = support::empty_store();
  FieldRepository fields_{db_};
};

TEST_F(NativeCurrents, AnswerAtAnyPlaceAsTheWholeMeshDoes) {
  for (const bool in_faces : {false, true}) {
    std::mt19937_64 rng{7};
    const ocean::Mesh mesh = in_blocks(mesh_of(rng, 90, 70, in_faces)).mesh;
    ASSERT_GT(mesh.points.size(), MeshBlocks::points_together);
    create(mesh, std::nullopt, 0);
    const std::vector<float> u = noise(rng, mesh);
    const std::vector<float> v = noise(rng, mesh);
    fields_.write_slice(id_, "u_m_s", 0, 0, u);
    fields_.write_slice(id_, "v_m_s", 0, 0, v);
    ocean::PointVelocities whole{u, v};
    if (in_faces) {
      fill_nodes_from_faces(mesh, whole.east);
      fill_nodes_from_faces(mesh, whole.north);
    }

    for (int i = 0; i < 150; ++i) {
      const bool own_point = i % 2 == 0;
      const geo::LonLat place = own_point
                                    ? mesh.points[rng() % mesh.points.size()]
                                    : geo::LonLat{geo::wrap_longitude(support::uniform(rng, 177.9, 181.6)),
                                                  support::uniform(rng, 65.9, 67.9)};
      const ocean::HorizontalGrid one{geo::GeographicFrame{}, ocean::Axis{{place.lon_deg}},
                                      ocean::Axis{{place.lat_deg}}};
      const auto expected = ocean::MeshSampling::of(mesh, one)->apply(whole);
      const auto found = velocity(place, 0.0);
      ASSERT_EQ(found.has_value(), !std::isnan(expected.east[0])) << place.lon_deg << " " << place.lat_deg;
      if (!found) continue;
      ASSERT_NEAR(found->east.value, expected.east[0], 1e-6) << place.lon_deg << " " << place.lat_deg;
      ASSERT_NEAR(found->north.value, expected.north[0], 1e-6);
    }
  }
}

TEST_F(NativeCurrents, OfAnAreaAreThoseOfItsPlaces) {
  for (const bool in_faces : {false, true}) {
    std::mt19937_64 rng{8};
    const ocean::Mesh mesh = in_blocks(mesh_of(rng, 60, 50, in_faces)).mesh;
    create(mesh, ocean::Axis{{0.0, 10.0}}, 0);
    for (std::size_t level = 0; level < 2; ++level) {
      fields_.write_slice(id_, "u_m_s", 0, level, noise(rng, mesh));
      fields_.write_slice(id_, "v_m_s", 0, level, noise(rng, mesh));
    }

    const auto area = fields_.load_currents(id_, {179.0, 66.4, -179.7, 66.8}, std::nullopt, std::nullopt);
    ASSERT_TRUE(area.has_value());
    const ocean::HorizontalGrid& nodes = area->samples().grid;
    for (int i = 0; i < 100; ++i) {
      const geo::LonLat node = nodes.place(rng() % nodes.x().size(), rng() % nodes.y().size());
      if (!geo::contains(geo::BoundingBox{179.0, 66.4, -179.7, 66.8}, node)) continue;
      const auto expected = velocity(node, 10.0);
      const auto found = area->at(node, {10.0}, core::from_unix_seconds(start_s));
      ASSERT_TRUE(expected.has_value() && found.has_value());
      EXPECT_NEAR(found->east.value, expected->east.value, 1e-5);
      EXPECT_NEAR(found->north.value, expected->north.value, 1e-5);
    }
  }
}

TEST_F(NativeCurrents, OfASmallAreaReadItsBlocksAlone) {
  std::mt19937_64 rng{9};
  const ocean::Mesh mesh = in_blocks(mesh_of(rng, 200, 200, false)).mesh;
  create(mesh, std::nullopt, 0);
  sql::Statement row{db_, "SELECT dataset_row FROM mesh"};
  ASSERT_TRUE(row.step());

  const MeshPart whole = MeshBlocks{db_}.around(row.integer(0), {-180.0, -90.0, 180.0, 90.0});
  const MeshPart part = MeshBlocks{db_}.around(row.integer(0), at(mesh.points[12'345]));

  EXPECT_EQ(whole.mesh.points.size(), mesh.points.size());
  EXPECT_EQ(whole.mesh.cells.size(), mesh.cells.size());
  EXPECT_LE(part.blocks.size(), 4U);
  EXPECT_LT(part.mesh.points.size(), mesh.points.size() / 2);
}

TEST_F(NativeCurrents, OnLevelsAboveTheBedAreTheModelsOwnAtEachLevelAndTime) {
  std::mt19937_64 rng{10};
  const ocean::Mesh mesh = in_blocks(mesh_of(rng, 12, 12, false)).mesh;
  constexpr std::size_t levels = 4;
  create(mesh, ocean::Axis{ocean::standard_depths_m(80.0)}, levels, 2);
  std::vector<std::vector<std::vector<float>>> u(2), depths_m(2);  // [time][level][point]
  for (std::size_t time = 0; time < 2; ++time) {
    for (std::size_t level = 0; level <= levels; ++level) {
      std::vector<float> here_m;
      for (std::size_t i = 0; i < mesh.points.size(); ++i)
        here_m.push_back((static_cast<float>(level) + 0.5F) / (levels + 0.5F) *
                             (70.0F + static_cast<float>(i % 10)) +
                         0.3F * static_cast<float>(time));
      fields_.write_slice(id_, "level_depth_m", time, level, here_m);
      depths_m[time].push_back(here_m);
      if (level == levels) continue;
      u[time].push_back(noise(rng, mesh));
      fields_.write_slice(id_, "u_m_s", time, level, u[time].back());
      fields_.write_slice(id_, "v_m_s", time, level, u[time].back());
    }
  }

  for (std::size_t i = 0; i < mesh.points.size(); i += 5) {
    for (std::size_t time = 0; time < 2; ++time) {
      for (std::size_t level = 0; level < levels; ++level) {
        const auto found = velocity(mesh.points[i], static_cast<double>(depths_m[time][level][i]),
                                    start_s + 3600.0 * static_cast<double>(time));
        ASSERT_TRUE(found.has_value());
        EXPECT_NEAR(found->east.value, u[time][level][i], 1e-6);
      }
      EXPECT_FALSE(velocity(mesh.points[i], static_cast<double>(depths_m[time][levels][i]) + 1.0,
                            start_s + 3600.0 * static_cast<double>(time)));
    }
  }
}

TEST_F(NativeCurrents, OfRunsWhoseLevelsLieAtOtherDepthsAreJoinedInTime) {
  std::mt19937_64 rng{11};
  const ocean::Mesh mesh = in_blocks(mesh_of(rng, 6, 6, false)).mesh;
  std::vector<JoinedPart> parts;
  for (const int run : {0, 1}) {
    const DatasetId id{"run-" + std::to_string(run)};
    const double time_s = start_s + 3600.0 * run;
    DatasetRepository{db_}.insert(sample_dataset(id.value, DatasetKind::currents));
    fields_.create(id, {ocean::lattice_for(mesh).value(), ocean::Axis{{0.0, 50.0}}, ocean::Axis{{time_s}}},
                   {mesh, 2});
    for (const float level : {0.0F, 1.0F, 2.0F})  // 2: the bed
      fields_.write_slice(
          id, "level_depth_m", 0, static_cast<std::size_t>(level),
          std::vector<float>(mesh.points.size(), (10.0F + static_cast<float>(run)) * (level + 0.5F)));
    for (const std::size_t level : {std::size_t{0}, std::size_t{1}})
      for (const char* component : {"u_m_s", "v_m_s"})
        fields_.write_slice(id, component, 0, level,
                            std::vector<float>(mesh.points.size(),
                                               static_cast<float>(level) + 2.0F * static_cast<float>(run)));
    parts.push_back({sample_dataset(id.value, DatasetKind::currents),
                     {core::from_unix_seconds(time_s), core::from_unix_seconds(time_s)}});
  }

  const geo::LonLat place = mesh.points[7];
  const auto joined = load_joined(db_, parts, at(place), core::from_unix_seconds(start_s), std::nullopt, {});
  ASSERT_TRUE(joined.has_value());
  const auto east = [&](double depth_m, double time_s) {
    return joined->at(place, {depth_m}, core::from_unix_seconds(time_s)).value().east.value;
  };
  EXPECT_NEAR(east(15.0, start_s), 1.0, 1e-6);           // the second level of the first run
  EXPECT_NEAR(east(16.5, start_s + 3600.0), 3.0, 1e-6);  // of the second one
  EXPECT_NEAR(east(11.0, start_s + 3600.0), 2.5, 1e-6);  // between its levels
  EXPECT_NEAR(east(5.0, start_s + 1800.0), 1.0, 1e-6);   // the mean of both times
}

TEST_F(NativeCurrents, AreNeverOnMoreNodesThanWereForetold) {
  std::mt19937_64 rng{3};
  const ocean::Mesh mesh = in_blocks(mesh_of(rng, 120, 100, false)).mesh;
  create(mesh, std::nullopt, 0);
  for (const char* component : {"u_m_s", "v_m_s"})
    fields_.write_slice(id_, component, 0, 0, std::vector<float>(mesh.points.size(), 0.1F));
  for (int i = 0; i < 20; ++i) {
    const double west = support::uniform(rng, 178.0, 180.0);
    const double south = support::uniform(rng, 66.0, 67.5);
    const geo::BoundingBox area{west, south, geo::wrap_longitude(west + support::uniform(rng, 0.1, 3.0)),
                                south + support::uniform(rng, 0.05, 1.0)};
    const auto found = fields_.load_currents(id_, area, std::nullopt, std::nullopt);
    ASSERT_TRUE(found.has_value());
    EXPECT_LE(found->samples().grid.size(), fields_.most_nodes(id_, area));
  }
  EXPECT_EQ(fields_.most_nodes(id_, {10.0, 10.0, 11.0, 11.0}), 0U);
}

}  // namespace
}  // namespace floeplan::repository::native_currents_test
