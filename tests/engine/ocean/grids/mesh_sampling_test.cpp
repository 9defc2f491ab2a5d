#include "engine/ocean/grids/mesh_sampling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "engine/geo/tangent_plane.hpp"
#include "engine/ocean/grids/cell_minima.hpp"
#include "engine/ocean/grids/cell_weights.hpp"
#include "engine/ocean/grids/mesh_lattice.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ocean::mesh_sampling_test {
namespace {

constexpr std::uint32_t side = 9;  // points

/// A square of shaken points about a place, each cell of it two triangles or one of four corners.
Mesh mesh_about(std::mt19937_64& rng, geo::LonLat middle, double spacing_deg) {
  const geo::UnitVector up = geo::unit_vector(middle);
  const geo::UnitVector aside = geo::unit_vector({middle.lon_deg + 90.0, 0.0});
  const geo::UnitVector along{up.y * aside.z - up.z * aside.y, up.z * aside.x - up.x * aside.z,
                              up.x * aside.y - up.y * aside.x};
  Mesh mesh;
  for (std::uint32_t row = 0; row < side; ++row) {
    for (std::uint32_t column = 0; column < side; ++column) {
      const double step = spacing_deg * std::numbers::pi / 180.0;
      const double x = step * (column - 0.5 * (side - 1) + support::uniform(rng, -0.2, 0.2));
      const double y = step * (row - 0.5 * (side - 1) + support::uniform(rng, -0.2, 0.2));
      mesh.points.push_back(geo::lon_lat({up.x + x * aside.x + y * along.x, up.y + x * aside.y + y * along.y,
                                          up.z + x * aside.z + y * along.z}));
    }
  }
  for (std::uint32_t row = 0; row + 1 < side; ++row) {
    for (std::uint32_t column = 0; column + 1 < side; ++column) {
      const std::uint32_t a = row * side + column;
      if (support::uniform_int(rng, 0, 1) == 0) {
        mesh.cells.push_back({a, a + 1, a + side + 1, a + side});
      } else {
        mesh.cells.push_back({a, a + 1, a + side, a + side});
        mesh.cells.push_back({a + 1, a + side + 1, a + side, a + side});
      }
    }
  }
  return mesh;
}

geo::LonLat somewhere(std::mt19937_64& rng) {
  const std::vector<geo::LonLat> hard{{180.0, 70.0}, {0.0, 90.0}, {30.0, -89.5}, {-179.9, 0.0}, {0.0, 89.7}};
  if (support::uniform_int(rng, 0, 2) == 0) return hard[rng() % hard.size()];
  return {support::uniform(rng, -180.0, 180.0), support::uniform(rng, -88.0, 88.0)};
}

std::vector<float> noise(std::mt19937_64& rng, std::size_t count) {
  std::vector<float> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(static_cast<float>(support::uniform(rng, -2.0, 2.0)));
  return values;
}

HorizontalGrid at_place(geo::LonLat place) {
  return {geo::GeographicFrame{}, Axis{{place.lon_deg}}, Axis{{place.lat_deg}}};
}

/// A mean of the corners with random weights.
geo::LonLat place_in(std::mt19937_64& rng, const Mesh& mesh, const Mesh::Cell& cell) {
  geo::UnitVector sum;
  for (const std::uint32_t corner : cell) {
    const geo::UnitVector each = geo::unit_vector(mesh.points[corner]);
    const double weight = support::uniform(rng, 0.0, 1.0);
    sum = {sum.x + weight * each.x, sum.y + weight * each.y, sum.z + weight * each.z};
  }
  const double length = std::sqrt(geo::dot(sum, sum));
  return geo::lon_lat({sum.x / length, sum.y / length, sum.z / length});
}

Axis every(const Axis& axis, std::size_t stride) {
  std::vector<double> nodes;
  for (std::size_t i = 0; i < axis.size(); i += stride) nodes.push_back(axis[i]);
  return Axis{std::move(nodes)};
}

TEST(LeastOfCells, IsNoMoreThanTheLeastKnownCornerAtAnyPlaceOfACell) {
  support::for_each_seed(50, [](std::mt19937_64& rng) {
    const Mesh mesh = mesh_about(rng, somewhere(rng), support::uniform(rng, 0.0005, 0.5));
    std::vector<float> values = noise(rng, mesh.points.size());
    for (float& value : values)
      if (support::uniform_int(rng, 0, 5) == 0) value = std::nanf("");
    const HorizontalGrid fine = lattice_for(mesh).value();
    const auto stride = static_cast<std::size_t>(support::uniform_int(rng, 1, 6));
    const HorizontalGrid grid{fine.frame(), every(fine.x(), stride), every(fine.y(), stride)};

    const std::vector<float> least = least_of_cells(mesh, grid, values);

    for (const Mesh::Cell& cell : mesh.cells) {
      const geo::LonLat place = place_in(rng, mesh, cell);
      const auto at = grid.locate(place);
      float corner_m = INFINITY;
      for (const std::uint32_t corner : cell) corner_m = std::fmin(corner_m, values[corner]);
      if (!at || corner_m == INFINITY) continue;
      float found_m = INFINITY;
      for (const std::size_t iy : {at->y.lower, at->y.upper})
        for (const std::size_t ix : {at->x.lower, at->x.upper})
          found_m = std::fmin(found_m, least[iy * grid.x().size() + ix]);
      ASSERT_LE(found_m, corner_m) << place.lon_deg << " " << place.lat_deg << ", every " << stride;
    }
  });
}

TEST(MeshSampling, HasAsLeastTheLeastOfTheValuesThatCountAtAPlace) {
  support::for_each_seed(20, [](std::mt19937_64& rng) {
    const Mesh mesh = mesh_about(rng, somewhere(rng), support::uniform(rng, 0.0005, 0.5));
    const std::vector<float> values = noise(rng, mesh.points.size());
    for (const Mesh::Cell& cell : mesh.cells) {
      const auto sampling = MeshSampling::of(mesh, at_place(place_in(rng, mesh, cell)));
      float corner = INFINITY;
      for (const std::uint32_t point : cell) corner = std::fmin(corner, values[point]);
      ASSERT_EQ(sampling.value().least(values)[0], corner);
    }
    const auto at_a_point = MeshSampling::of(mesh, at_place(mesh.points[40]));
    ASSERT_EQ(at_a_point.value().least(values)[0], values[40]);
  });
}

TEST(MeshSampling, HasTheModelsOwnValueAtAPointOfTheModel) {
  support::for_each_seed(50, [](std::mt19937_64& rng) {
    const Mesh mesh = mesh_about(rng, somewhere(rng), support::uniform(rng, 0.0005, 0.5));
    const PointVelocities model{noise(rng, mesh.points.size()), noise(rng, mesh.points.size())};

    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      const auto sampling = MeshSampling::of(mesh, at_place(mesh.points[i]));
      ASSERT_TRUE(sampling.has_value());
      const PointVelocities found = sampling->apply(model);
      ASSERT_NEAR(found.east[0], model.east[i], 1e-6F)
          << mesh.points[i].lon_deg << " " << mesh.points[i].lat_deg;
      ASSERT_NEAR(found.north[0], model.north[i], 1e-6F);
    }
  });
}

/// The first cell that holds a place, looked for among all of them.
std::optional<float> slowly(const Mesh& mesh, const std::vector<float>& values, geo::LonLat place) {
  for (const Mesh::Cell& cell : mesh.cells) {
    CellWeights::Corners corners{};
    for (std::size_t i = 0; i < 4; ++i) corners[i] = geo::unit_vector(mesh.points[cell[i]]);
    const auto weights = CellWeights{corners, cell[2] == cell[3]}.at(geo::unit_vector(place));
    if (!weights) continue;
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) sum += (*weights)[i] * static_cast<double>(values[cell[i]]);
    return static_cast<float>(sum);
  }
  return std::nullopt;
}

TEST(MeshSampling, FindsTheCellOfEveryNodeThatASearchOfAllCellsFinds) {
  support::for_each_seed(60, [](std::mt19937_64& rng) {
    const Mesh mesh = mesh_about(rng, somewhere(rng), support::uniform(rng, 0.01, 0.5));
    const auto lattice = lattice_for(mesh);
    ASSERT_TRUE(lattice.has_value());
    const auto values = noise(rng, mesh.points.size());
    const auto sampling = MeshSampling::of(mesh, *lattice);
    ASSERT_TRUE(sampling.has_value());
    const std::vector<float> found = sampling->apply(values);

    for (std::size_t i = 0; i < 300; ++i) {
      const std::size_t node = rng() % lattice->size();
      const geo::LonLat place = lattice->place(node % lattice->x().size(), node / lattice->x().size());
      const auto expected = slowly(mesh, values, place);
      ASSERT_EQ(std::isnan(found[node]), !expected.has_value()) << place.lon_deg << " " << place.lat_deg;
      if (expected) {
        ASSERT_NEAR(found[node], *expected, 2e-5F) << place.lon_deg << " " << place.lat_deg;
      }
    }
  });
}

TEST(MeshSampling, CarriesAVectorAsTheGreatCircleDoes) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    const geo::LonLat from = somewhere(rng);
    const geo::LonLat to{from.lon_deg + support::uniform(rng, -0.3, 0.3),
                         std::clamp(from.lat_deg + support::uniform(rng, -0.3, 0.3), -89.99, 89.99)};
    const geo::UnitVector a = geo::unit_vector(from);
    const geo::UnitVector m = geo::unit_vector(to);
    const geo::UnitVector across{a.y * m.z - a.z * m.y, a.z * m.x - a.x * m.z, a.x * m.y - a.y * m.x};
    const auto beyond = [&](double aside) {
      return geo::lon_lat({1.5 * m.x - 0.5 * a.x + aside * across.x, 1.5 * m.y - 0.5 * a.y + aside * across.y,
                           1.5 * m.z - 0.5 * a.z + aside * across.z});
    };
    // The place is in the middle of a triangle all of whose current is at one corner: only that vector's turn is seen.
    const Mesh mesh{{from, beyond(1.0), beyond(-1.0)}, {{0, 1, 2, 2}}};
    const auto sampling = MeshSampling::of(mesh, at_place(to));
    ASSERT_TRUE(sampling.has_value());
    const PointVelocities found = sampling->apply({{1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}});
    ASSERT_NEAR(std::hypot(found.east[0], found.north[0]), 1.0F / 3.0F, 1e-3F);

    // Clockwise from east: a bearing that grew.
    const double turned =
        std::atan2(-static_cast<double>(found.north[0]), static_cast<double>(found.east[0]));
    EXPECT_NEAR(std::remainder(turned - geo::convergence(from, to), 2.0 * std::numbers::pi), 0.0, 1e-5);
  });
}

TEST(MeshSampling, NeverCountsLandAsStillWater) {
  const float land = missing_sample;
  const Mesh mesh{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}, {{0, 1, 2, 2}}};
  const auto at = [&](geo::LonLat place) {
    return MeshSampling::of(mesh, at_place(place))->apply({{1.0F, 1.0F, land}, {0.5F, 0.5F, land}});
  };

  EXPECT_NEAR(at({0.3, 0.3}).east[0], 1.0F, 1e-3F);  // most of the weight lies on water
  EXPECT_NEAR(at({0.3, 0.3}).north[0], 0.5F, 1e-3F);
  EXPECT_TRUE(std::isnan(at({0.2, 0.6}).east[0]));  // on land
  EXPECT_TRUE(std::isnan(at({0.0, 1.0}).east[0]));
  EXPECT_TRUE(std::isnan(at({0.8, 0.8}).east[0]));  // in no cell
}

TEST(MeshOfFaces, GivesANodeTheMeanOfTheKnownFacesRoundIt) {
  // Two triangles with a side in common: middles 0 and 1, nodes 2 to 5.
  const Mesh mesh{{{0.3, 0.3}, {0.7, 0.7}, {0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}},
                  {{0, 2, 3, 3}, {0, 3, 4, 4}, {0, 4, 2, 2}, {1, 3, 5, 5}, {1, 5, 4, 4}, {1, 4, 3, 3}},
                  true};
  std::vector<float> values{1.0F, 3.0F, 99.0F, 99.0F, 99.0F, 99.0F};
  fill_nodes_from_faces(mesh, values);
  EXPECT_EQ(values, (std::vector<float>{1.0F, 3.0F, 1.0F, 2.0F, 2.0F, 3.0F}));

  values = {missing_sample, 3.0F, 99.0F, 99.0F, 99.0F, 99.0F};
  fill_nodes_from_faces(mesh, values);
  EXPECT_TRUE(std::isnan(values[0]));
  EXPECT_TRUE(std::isnan(values[2]));
  EXPECT_EQ(values[3], 3.0F);
}

TEST(MeshLattice, IsRefinedWhereTheModelIsFineAndNoFinerThanFourNodesForEachPoint) {
  std::mt19937_64 rng{1};
  const Mesh fine = mesh_about(rng, {-50.0, 65.0}, 0.01);
  const HorizontalGrid coarse{geo::GeographicFrame{}, Axis{{-50.2, -50.1, -50.0, -49.9, -49.8}},
                              Axis{{64.9, 65.0, 65.1}}};

  const HorizontalGrid found = refined(coarse, fine);

  EXPECT_EQ(found.x().front(), coarse.x().front());
  EXPECT_EQ(found.x().back(), coarse.x().back());
  EXPECT_GT(found.size(), 10 * coarse.size());
  EXPECT_LE(found.size(), 5 * fine.points.size());
  EXPECT_EQ(refined(found, fine).size(), found.size());
  const HorizontalGrid globe{geo::GeographicFrame{}, Axis{{-180.0, -90.0, 0.0, 90.0}}, Axis{{64.0, 66.0}}};
  EXPECT_EQ(refined(globe, fine).size(), globe.size());
}

}  // namespace
}  // namespace floeplan::ocean::mesh_sampling_test
