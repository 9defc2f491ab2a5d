#include "engine/planning/currents/depth_averages.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/support/property.hpp"

namespace floeplan::planning::currents::depth_averages_test {
namespace {

using support::uniform;
using support::uniform_int;

constexpr std::size_t columns = 5;
constexpr std::size_t rows = 6;
constexpr std::size_t levels = 4;

ocean::Axis even_axis(double first, std::size_t count) {
  std::vector<double> nodes;
  for (std::size_t i = 0; i < count; ++i) nodes.push_back(first + 0.1 * static_cast<double>(i));
  return ocean::Axis{std::move(nodes)};
}

/// A grid whose nodes have water down to different levels, or no water.
ocean::CurrentGrid random_currents(std::mt19937_64& rng) {
  constexpr float missing = std::numeric_limits<float>::quiet_NaN();
  constexpr std::size_t slice = columns * rows;
  ocean::CurrentGrid::Samples samples{
      .grid = {geo::GeographicFrame{}, even_axis(-53.0, columns), even_axis(69.0, rows)},
      .depths_m = ocean::Axis{{2.0, 20.0, 60.0, 150.0}},
      .times_s = ocean::Axis{{0.0}},
      .u = std::vector<float>(levels * slice, missing),
      .v = std::vector<float>(levels * slice, missing)};
  for (std::size_t node = 0; node < slice; ++node) {
    const int wet = std::max(0, uniform_int(rng, -3, static_cast<int>(levels)));
    for (std::size_t level = 0; level < static_cast<std::size_t>(wet); ++level) {
      samples.u[level * slice + node] = static_cast<float>(uniform(rng, -1.0, 1.0));
      samples.v[level * slice + node] = static_cast<float>(uniform(rng, -1.0, 1.0));
    }
  }
  return ocean::CurrentGrid{std::move(samples)};
}

/// A window without the grid's outermost nodes. The vectors of each node are turned by an angle of their own.
struct Scene {
  ocean::CurrentGrid currents;
  plane::NodeWindow window{
      .x = {-52.9, -52.8, -52.7}, .y = {69.1, 69.2, 69.3, 69.4}, .columns = {1, 2, 3}, .first_row = 1};
  std::vector<NodeTurn> turns;

  explicit Scene(std::mt19937_64& rng) : currents{random_currents(rng)} {
    for (std::size_t i = 0; i < window.size(); ++i) {
      const double angle = uniform(rng, -3.0, 3.0);
      turns.push_back({std::cos(angle), std::sin(angle)});
    }
  }

  [[nodiscard]] std::optional<motion::CurrentXy> own(std::size_t ix, std::size_t iy,
                                                     const vehicle::DiveBand& band) const {
    const auto column = currents.column_at_node(window.columns[ix], window.first_row + iy, 0);
    if (!column) return std::nullopt;
    const geo::VelocityEn mean = column->mean(band.top, band.bottom);
    const NodeTurn& turn = turns[iy * window.x.size() + ix];
    return motion::CurrentXy{mean.east.value * turn.cosine - mean.north.value * turn.sine,
                             mean.east.value * turn.sine + mean.north.value * turn.cosine};
  }

  /// The vector of the node, or the mean of its neighbours.
  [[nodiscard]] std::optional<motion::CurrentXy> at_node(std::size_t ix, std::size_t iy,
                                                         const vehicle::DiveBand& band) const {
    if (const auto here = own(ix, iy, band)) return here;
    motion::CurrentXy sum;
    int count = 0;
    for (std::size_t jy = 0; jy < window.y.size(); ++jy) {
      for (std::size_t jx = 0; jx < window.x.size(); ++jx) {
        const bool beside = jx + 1 >= ix && jx <= ix + 1 && jy + 1 >= iy && jy <= iy + 1;
        const auto there = own(jx, jy, band);
        if (!beside || !there) continue;
        sum.x_m_s += there->x_m_s;
        sum.y_m_s += there->y_m_s;
        ++count;
      }
    }
    if (count == 0) return std::nullopt;
    return motion::CurrentXy{sum.x_m_s / count, sum.y_m_s / count};
  }

  [[nodiscard]] std::optional<motion::CurrentXy> mean(const DepthAverages::Place& place) const {
    motion::CurrentXy sum;
    for (const std::size_t up : {0U, 1U}) {
      for (const std::size_t right : {0U, 1U}) {
        const double weight = (up == 1 ? place.y.share : 1.0 - place.y.share) *
                              (right == 1 ? place.x.share : 1.0 - place.x.share);
        if (weight == 0.0) continue;
        const auto node = at_node(place.x.cell + right, place.y.cell + up, place.band);
        if (!node) return std::nullopt;
        sum.x_m_s += weight * node->x_m_s;
        sum.y_m_s += weight * node->y_m_s;
      }
    }
    return sum;
  }
};

std::vector<DepthAverages::Place> random_places(std::mt19937_64& rng, const plane::NodeWindow& window) {
  const auto position = [&](std::size_t nodes) {
    const auto cell = static_cast<std::size_t>(uniform_int(rng, 0, static_cast<int>(nodes) - 1));
    return plane::CellPosition{cell, cell + 1 < nodes ? 0.25 * uniform_int(rng, 0, 3) : 0.0};
  };
  std::vector<DepthAverages::Place> places;
  for (int i = 0; i < 30; ++i) {
    const core::Metres top{uniform(rng, 0.0, 30.0)};
    places.push_back({position(window.x.size()),
                      position(window.y.size()),
                      {top, top + core::Metres{uniform(rng, 0.0, 200.0)}}});
  }
  return places;
}

TEST(DepthAverages, AreThoseOfTheColumnsAroundAPlace) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    const Scene scene{rng};
    const std::vector<DepthAverages::Place> places = random_places(rng, scene.window);
    const ocean::CurrentRows water{scene.currents, 0, scene.window.first_row, scene.window.y.size()};
    const WetLevels wet{scene.window, 0, scene.window.y.size(), water};

    const DepthAverages means{places, scene.currents.samples().depths_m, scene.window, scene.turns, wet,
                              water};

    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto mean = means.at(i, water);
      const auto expected = scene.mean(places[i]);
      ASSERT_EQ(mean.has_value(), expected.has_value());
      if (!mean) continue;
      EXPECT_NEAR(mean->current.x_m_s, expected->x_m_s, 1e-11);
      EXPECT_NEAR(mean->current.y_m_s, expected->y_m_s, 1e-11);
    }
  });
}

TEST(DepthAverages, SayWhereTheyReachBeyondTheDataOwnCoast) {
  support::for_each_seed(50, [](std::mt19937_64& rng) {
    const Scene scene{rng};
    const ocean::CurrentRows water{scene.currents, 0, scene.window.first_row, scene.window.y.size()};
    const WetLevels wet{scene.window, 0, scene.window.y.size(), water};
    const vehicle::DiveBand band{{5.0}, {100.0}};
    const std::vector<DepthAverages::Place> one_node{{{1, 0.0}, {2, 0.0}, band}};

    const DepthAverages means{one_node, scene.currents.samples().depths_m, scene.window, scene.turns, wet,
                              water};

    const auto mean = means.at(0, water);
    if (!mean) return;
    EXPECT_EQ(mean->extended, !scene.own(1, 2, band));
    EXPECT_EQ(mean->extended, wet.at(1, 2) == 0);
  });
}

}  // namespace
}  // namespace floeplan::planning::currents::depth_averages_test
