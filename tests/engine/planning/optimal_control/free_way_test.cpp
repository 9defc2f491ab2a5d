#include "engine/planning/optimal_control/free_way.hpp"

#include <gtest/gtest.h>

#include "tests/engine/planning/paper_waters.hpp"
#include "tests/support/river_crossing.hpp"

namespace floeplan::planning::optimal_control::free_way_test {
namespace {

/// The jet as stored data give it: bilinear between nodes, linear between times.
class GriddedJet {
 public:
  GriddedJet() {
    for (int t = 0; t < times; ++t) {
      for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
          const geo::PlanePoint node{west + spacing * x, south + spacing * y};
          nodes_.push_back(currents::MeanderingJet{}(node, core::Seconds{interval * t}).value());
        }
      }
    }
  }

  std::optional<motion::CurrentXy> operator()(geo::PlanePoint p, core::Seconds time) const {
    const double x = (p.x_m - west) / spacing;
    const double y = (p.y_m - south) / spacing;
    const double t = time.count() / interval;
    const int ix = static_cast<int>(std::floor(x));
    const int iy = static_cast<int>(std::floor(y));
    const int it = static_cast<int>(std::floor(t));
    if (ix < 0 || iy < 0 || it < 0 || ix + 1 >= columns || iy + 1 >= rows || it + 1 >= times)
      return std::nullopt;
    motion::CurrentXy sum{};
    for (int corner = 0; corner < 8; ++corner) {
      const int i = corner & 1;
      const int j = (corner >> 1) & 1;
      const int k = corner >> 2;
      const double weight =
          std::abs(1 - i - (x - ix)) * std::abs(1 - j - (y - iy)) * std::abs(1 - k - (t - it));
      const motion::CurrentXy& c =
          nodes_[static_cast<std::size_t>(((it + k) * rows + iy + j) * columns + ix + i)];
      sum.x_m_s += weight * c.x_m_s;
      sum.y_m_s += weight * c.y_m_s;
    }
    return sum;
  }

 private:
  static constexpr double west = -10.5;
  static constexpr double south = -4.0;
  static constexpr double spacing = 0.1;
  static constexpr double interval = 0.5;
  static constexpr int columns = 216;
  static constexpr int rows = 81;
  static constexpr int times = 50;

  std::vector<motion::CurrentXy> nodes_;  // [time][row][column]
};

TEST(FreeWay, TakesTheTimeOfTheExtremalOverTheRiver) {
  const currents::RiverCurrent river;
  const LegTimer timer = legs_in(river, over_the_river.through_water);
  const auto start = time_way({over_the_river.from, over_the_river.to}, core::Seconds{0.0}, timer);

  const auto way = find_free_way(start.value(), timer);

  ASSERT_TRUE(way.has_value());
  const double exact_s =
      support::river_crossing_by_optimal_control(river, over_the_river.through_water).count();
  EXPECT_NEAR(way->duration.count(), exact_s, 1e-5 * exact_s);
  EXPECT_LT(way->accuracy, 1e-5);
}

TEST(FreeWay, TakesTheTimeOfTheExtremalThroughTheJet) {
  const currents::MeanderingJet jet;
  const LegTimer timer = legs_in(jet, along_the_jet.through_water);
  for (const auto& points : ways_along_the_jet(2)) {
    const auto way = find_free_way(time_way(points, core::Seconds{0.0}, timer).value(), timer);

    if (!way) continue;  // the corridor's route is far from any optimum; it says so
    EXPECT_NEAR(way->duration.count(), 17.1588, 1e-4);
  }
}

/// Law: if two rough routes are said to lead to one way, the routes found from both have the same duration.
TEST(FreeWay, IsOneFromRoughWaysThatLieTogether) {
  const currents::RiverCurrent river;
  const LegTimer timer = legs_in(river, over_the_river.through_water);
  const geo::PlanePoint from = over_the_river.from;
  const geo::PlanePoint to = over_the_river.to;
  const double length = geo::distance_m(from, to);
  const auto rough_way_past = [&](double across) {
    const geo::PlanePoint past{0.5 * (from.x_m + to.x_m), 0.5 * (from.y_m + to.y_m) + across * length};
    return find_rough_free_way(time_way({from, past, to}, core::Seconds{0.0}, timer).value(), timer);
  };
  const TimedWay straight = rough_way_past(0.0);
  const TimedWay bent = rough_way_past(0.2);

  ASSERT_TRUE(lead_to_one_way(straight, bent));
  const double seconds = find_coarse_free_way(straight, timer).value().duration().count();
  EXPECT_NEAR(find_coarse_free_way(bent, timer).value().duration().count(), seconds, 1e-5 * seconds);
  TimedWay aside = straight;
  for (std::size_t i = 1; i + 1 < aside.points.size(); ++i) aside.points[i].y_m += 0.05 * length;
  EXPECT_FALSE(lead_to_one_way(straight, aside));
  EXPECT_FALSE(lead_to_one_way(straight, time_way({from, to}, core::Seconds{0.0}, timer).value()));
}

TEST(FreeWay, NeedsNoSmoothCurrent) {
  const GriddedJet jet;
  const LegTimer timer = [&](geo::PlanePoint a, geo::PlanePoint b,
                             core::Seconds depart) -> std::optional<core::Seconds> {
    const core::Metres length{std::hypot(b.x_m - a.x_m, b.y_m - a.y_m)};
    const auto time = motion::edge_time({a, b, length}, depart, along_the_jet.through_water, jet,
                                        {.relative_tolerance = 1e-6, .longest_step = {0.05}});
    return time ? std::optional{*time} : std::nullopt;
  };
  const auto start = time_way(ways_along_the_jet(1).front(), core::Seconds{0.0}, timer);

  const auto way = find_free_way(start.value(), timer);

  ASSERT_TRUE(way.has_value()) << static_cast<int>(way.error());
  EXPECT_NEAR(way->duration.count(), 17.1588, 0.001 * 17.1588);
  EXPECT_LT(way->accuracy, 1e-3);
}

TEST(FreeWay, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  const currents::MeanderingJet jet;
  const LegTimer timer = legs_in(jet, along_the_jet.through_water);
  const auto start = time_way(ways_along_the_jet(1).front(), core::Seconds{0.0}, timer);

  const auto way = find_free_way(start.value(), timer, source.get_token());

  ASSERT_FALSE(way.has_value());
  EXPECT_EQ(way.error(), NoFreeWay::cancelled);
}

}  // namespace
}  // namespace floeplan::planning::optimal_control::free_way_test
