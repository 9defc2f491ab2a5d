#include "engine/ocean/grids/staggered_sampling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "engine/geo/tangent_plane.hpp"
#include "engine/ocean/grids/mesh_lattice.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ocean::staggered_sampling_test {
namespace {

constexpr std::uint32_t cells = 8;  // of the model, on each side

/// Cells of a model about a place on a plane, turned: cell (i, j) has its centre there; faces lie half a cell beside it.
/// The first component's point (i, j) is at (i + 1/2, j), the second one's at (i, j + 1/2).
class ModelCells {
 public:
  ModelCells(geo::LonLat middle, double spacing_deg, double turned_rad) : step_{spacing_deg * radians} {
    up_ = geo::unit_vector(middle);
    const geo::UnitVector aside = geo::unit_vector({middle.lon_deg + 90.0, 0.0});
    const geo::UnitVector along{up_.y * aside.z - up_.z * aside.y, up_.z * aside.x - up_.x * aside.z,
                                up_.x * aside.y - up_.y * aside.x};
    const double c = std::cos(turned_rad);
    const double s = std::sin(turned_rad);
    first_ = {c * aside.x + s * along.x, c * aside.y + s * along.y, c * aside.z + s * along.z};
    second_ = {c * along.x - s * aside.x, c * along.y - s * aside.y, c * along.z - s * aside.z};
    for (std::uint32_t row = 0; row < cells; ++row)
      for (std::uint32_t column = 0; column < cells; ++column) add_point(column + 0.5, row, true);
    for (std::uint32_t row = 0; row < cells; ++row)
      for (std::uint32_t column = 0; column < cells; ++column) add_point(column, row + 0.5, false);
    for (std::uint32_t row = 0; row + 1 < cells; ++row) {
      for (std::uint32_t column = 0; column + 1 < cells; ++column) {
        mesh.cells.push_back(
            {u(column, row), u(column + 1, row), u(column + 1, row + 1), u(column, row + 1)});
        mesh.cells.push_back(
            {v(column, row), v(column, row + 1), v(column + 1, row + 1), v(column + 1, row)});
      }
    }
  }

  static std::uint32_t u(std::uint32_t column, std::uint32_t row) { return row * cells + column; }
  static std::uint32_t v(std::uint32_t column, std::uint32_t row) { return cells * cells + u(column, row); }

  [[nodiscard]] geo::LonLat place(double i, double j) const {
    const double x = step_ * (i - 0.5 * cells);
    const double y = step_ * (j - 0.5 * cells);
    return geo::lon_lat({up_.x + x * first_.x + y * second_.x, up_.y + x * first_.y + y * second_.y,
                         up_.z + x * first_.z + y * second_.z});
  }
  [[nodiscard]] double axis_rad(double i, double j, bool first) const {
    const double hair = 1e-3;
    return geo::direction_at(place(i, j), first ? place(i - hair, j) : place(i, j - hair),
                             first ? place(i + hair, j) : place(i, j + hair))
        .value();
  }
  /// What a current on the plane, the same everywhere, is along the axis of each point.
  [[nodiscard]] std::vector<float> components(float along_first, float along_second) const {
    std::vector<float> values(mesh.points.size(), along_second);
    std::fill_n(values.begin(), cells * cells, along_first);
    return values;
  }

  Mesh mesh;
  ComponentAxes axes;

 private:
  static constexpr double radians = std::numbers::pi / 180.0;

  void add_point(double i, double j, bool first) {
    mesh.points.push_back(place(i, j));
    const auto angle = static_cast<float>(axis_rad(i, j, first));
    axes.first_rad.push_back(first ? angle : missing_sample);
    axes.second_rad.push_back(first ? missing_sample : angle);
  }

  double step_;
  geo::UnitVector up_;
  geo::UnitVector first_;
  geo::UnitVector second_;
};

geo::LonLat somewhere(std::mt19937_64& rng) {
  const std::vector<geo::LonLat> hard{{180.0, 70.0}, {0.0, 89.9}, {30.0, -89.5}, {-179.9, 0.0}, {0.0, 89.7}};
  if (support::uniform_int(rng, 0, 2) == 0) return hard[rng() % hard.size()];
  return {support::uniform(rng, -180.0, 180.0), support::uniform(rng, -88.0, 88.0)};
}

ModelCells random_cells(std::mt19937_64& rng) {
  return {somewhere(rng), support::uniform(rng, 0.0005, 0.3), support::uniform(rng, -3.1, 3.1)};
}

struct Found {
  float east;
  float north;
};

Found at(const ModelCells& model, const std::vector<float>& components, geo::LonLat place) {
  const HorizontalGrid here{geo::GeographicFrame{}, Axis{{place.lon_deg}}, Axis{{place.lat_deg}}};
  const auto sampling = StaggeredSampling::of(model.mesh, model.axes, here);
  const PointVelocities found = sampling.value().apply(components);
  return {found.east[0], found.north[0]};
}

float along(const Found& found, double axis_rad) {
  return static_cast<float>(static_cast<double>(found.east) * std::cos(axis_rad) +
                            static_cast<double>(found.north) * std::sin(axis_rad));
}

TEST(StaggeredSampling, HasTheModelsOwnComponentAtEachPointOfTheModel) {
  support::for_each_seed(40, [](std::mt19937_64& rng) {
    const ModelCells model = random_cells(rng);
    std::vector<float> values;
    for (std::size_t i = 0; i < model.mesh.points.size(); ++i)
      values.push_back(static_cast<float>(support::uniform(rng, -2.0, 2.0)));

    for (std::uint32_t row = 1; row + 1 < cells; ++row) {
      for (std::uint32_t column = 1; column + 1 < cells; ++column) {
        for (const std::uint32_t point : {ModelCells::u(column, row), ModelCells::v(column, row)}) {
          const auto axis = static_cast<double>(point < cells * cells ? model.axes.first_rad[point]
                                                                      : model.axes.second_rad[point]);
          const Found found = at(model, values, model.mesh.points[point]);
          ASSERT_NEAR(along(found, axis), values[point], 1e-6F) << column << " " << row;
        }
      }
    }
  });
}

TEST(StaggeredSampling, IsTurnedToTrueNorthWhereverTheGridLies) {
  support::for_each_seed(40, [](std::mt19937_64& rng) {
    const ModelCells model = random_cells(rng);
    const double i = support::uniform(rng, 1.0, cells - 2.0);
    const double j = support::uniform(rng, 1.0, cells - 2.0);

    const Found found = at(model, model.components(0.3F, -0.2F), model.place(i, j));

    EXPECT_NEAR(along(found, model.axis_rad(i, j, true)), 0.3F, 2e-4F);
    EXPECT_NEAR(along(found, model.axis_rad(i, j, false)), -0.2F, 2e-4F);
  });
}

TEST(StaggeredSampling, IsLinearBetweenOpenFaces) {
  const ModelCells model{{12.0, 60.0}, 0.01, 0.4};
  std::vector<float> values = model.components(0.1F, 0.2F);
  values[ModelCells::u(3, 3)] = 0.2F;
  values[ModelCells::u(4, 3)] = 0.4F;
  values[ModelCells::u(3, 4)] = 0.6F;
  values[ModelCells::u(4, 4)] = 1.0F;

  const Found found = at(model, values, model.place(3.5 + 0.25, 3.0 + 0.4));

  const float expected = 0.6F * (0.75F * 0.2F + 0.25F * 0.4F) + 0.4F * (0.75F * 0.6F + 0.25F * 1.0F);
  EXPECT_NEAR(along(found, model.axis_rad(3.75, 3.4, true)), expected, 1e-4F);
}

/// A wall across the flow: the faces after a column are closed from the first row up to another.
std::vector<float> with_wall(const ModelCells& model, std::uint32_t column, std::uint32_t rows) {
  std::vector<float> values = model.components(0.5F, 0.1F);
  for (std::uint32_t row = 0; row < rows; ++row) values[ModelCells::u(column, row)] = 0.0F;
  return values;
}

TEST(StaggeredSampling, LetsNothingFlowThroughAClosedFace) {
  support::for_each_seed(60, [](std::mt19937_64& rng) {
    const ModelCells model = random_cells(rng);
    const std::vector<float> values = with_wall(model, 3, 5);
    const double j = support::uniform(rng, 1.0, 4.49);

    EXPECT_NEAR(along(at(model, values, model.place(3.5, j)), model.axis_rad(3.5, j, true)), 0.0F, 1e-4F);
    // Half a cell before it the mean of the closed face and the open one.
    EXPECT_NEAR(along(at(model, values, model.place(3.0, j)), model.axis_rad(3.0, j, true)), 0.25F, 1e-3F);
    // Past its end the flow is whole.
    EXPECT_NEAR(along(at(model, values, model.place(3.5, 4.6)), model.axis_rad(3.5, 4.6, true)), 0.5F, 1e-3F);
  });
}

TEST(StaggeredSampling, WaterAlongACoastIsNotSlowedDown) {
  const ModelCells model{{-40.0, -70.0}, 0.02, 1.0};
  std::vector<float> values = model.components(0.5F, 0.0F);
  for (std::uint32_t row = 5; row < cells; ++row)  // land from row 5 on
    for (std::uint32_t column = 0; column < cells; ++column) {
      values[ModelCells::u(column, row)] = missing_sample;
      values[ModelCells::v(column, row)] = missing_sample;
    }
  for (const double j : {3.9, 4.0, 4.3, 4.49})
    EXPECT_NEAR(along(at(model, values, model.place(3.2, j)), model.axis_rad(3.2, j, true)), 0.5F, 1e-4F)
        << j;
  for (const double j : {4.52, 4.8, 5.0, 6.3})
    EXPECT_TRUE(std::isnan(at(model, values, model.place(3.2, j)).east)) << j;
}

TEST(StaggeredSampling, AnIslandOfOneCellIsNoStillWater) {
  const ModelCells model{{-40.0, 70.0}, 0.02, 0.3};
  std::vector<float> values = model.components(0.5F, 0.1F);
  for (const std::uint32_t face :
       {ModelCells::u(3, 4), ModelCells::u(4, 4), ModelCells::v(4, 3), ModelCells::v(4, 4)})
    values[face] = 0.0F;

  EXPECT_TRUE(std::isnan(at(model, values, model.place(4.1, 4.2)).east));
  EXPECT_FALSE(std::isnan(at(model, values, model.place(3.2, 4.2)).east));
  EXPECT_EQ(at(model, model.components(0.0F, 0.0F), model.place(4.1, 4.2)).east, 0.0F);  // a sea at rest
}

TEST(StaggeredSampling, AxesThatPointTheOtherWayBeyondAFoldAreTurnedBack) {
  ModelCells model{{20.0, 75.0}, 0.02, 0.0};
  std::vector<float> values = model.components(0.5F, 0.1F);
  for (std::uint32_t row = 4; row < cells; ++row)
    for (std::uint32_t column = 0; column < cells; ++column) {
      const std::uint32_t u = ModelCells::u(column, row);
      const std::uint32_t v = ModelCells::v(column, row);
      model.axes.first_rad[u] += std::numbers::pi_v<float>;
      model.axes.second_rad[v] += std::numbers::pi_v<float>;
      values[u] = -0.5F;
      values[v] = -0.1F;
    }
  for (const double j : {3.2, 3.5, 3.8}) {
    const Found found = at(model, values, model.place(3.3, j));
    EXPECT_NEAR(along(found, model.axis_rad(3.3, j, true)), 0.5F, 1e-4F) << j;
    EXPECT_NEAR(along(found, model.axis_rad(3.3, j, false)), 0.1F, 1e-4F) << j;
  }
}

TEST(StaggeredSampling, GivesDepthsAtThePointsOfEachComponent) {
  const ModelCells model{{-40.0, 70.0}, 0.02, 0.3};
  std::vector<float> depths(model.mesh.points.size(), 50.0F);
  depths[ModelCells::u(3, 3)] = 20.0F;
  const geo::LonLat place = model.mesh.points[ModelCells::u(3, 3)];
  const HorizontalGrid here{geo::GeographicFrame{}, Axis{{place.lon_deg}}, Axis{{place.lat_deg}}};

  const auto [first, second] =
      StaggeredSampling::of(model.mesh, model.axes, here).value().apply_to_numbers(depths);

  EXPECT_EQ(first[0], 20.0F);
  EXPECT_EQ(second[0], 50.0F);
}

}  // namespace
}  // namespace floeplan::ocean::staggered_sampling_test
