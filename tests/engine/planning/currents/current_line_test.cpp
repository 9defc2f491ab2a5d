#include "engine/planning/currents/current_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/motion/edge_time.hpp"
#include "engine/planning/currents/plane_currents.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::currents::current_line_test {
namespace {

constexpr int hours = 48;
constexpr core::MetresPerSecond glider{0.35};
const FlownDepths dive{{}, nullptr};
const geo::LocalProjection projection{{-53.0, 69.0}};
const plane::PlaneBox area{{-60'000.0, -60'000.0}, {60'000.0, 60'000.0}};

/// Random currents up to this strength in each component, and an island without water.
PlaneCurrents random_currents(std::mt19937_64& rng, double strongest_m_s, bool steady = false) {
  const auto field = [&](geo::LonLat place, double) -> geo::VelocityEn {
    if (std::hypot(place.lon_deg + 52.0, 2.8 * (place.lat_deg - 69.2)) < 0.5) return {{NAN}, {NAN}};
    return {{support::uniform(rng, -strongest_m_s, strongest_m_s)},
            {support::uniform(rng, -strongest_m_s, strongest_m_s)}};
  };
  return {*support::currents_from(field, hours),        steady, dive, projection, area,
          core::from_unix_seconds(support::sea_start_s)};
}

motion::PlaneEdge random_edge(std::mt19937_64& rng, double longest_m) {
  const auto inside = [&](double most) { return support::uniform(rng, -most, most); };
  const geo::PlanePoint from{inside(50'000.0), inside(50'000.0)};
  const double length_m = support::uniform(rng, 100.0, longest_m);
  const double angle = inside(3.14159);
  const geo::PlanePoint to{from.x_m + length_m * std::cos(angle), from.y_m + length_m * std::sin(angle)};
  if (!area.contains(to)) return random_edge(rng, longest_m);
  return {from, to, {length_m}};
}

TEST(CurrentLine, IsTheCurrentOfEveryPlaceOnTheEdgeAtEveryTime) {
  support::for_each_seed(60, [](std::mt19937_64& rng) {
    const PlaneCurrents currents = random_currents(rng, 0.3, rng() % 3 == 0);
    for (int i = 0; i < 20; ++i) {
      const motion::PlaneEdge edge = random_edge(rng, 30'000.0);
      const motion::EdgeDirection direction{edge};
      CurrentLine line = currents.line(edge);
      double way_m = 0.0;
      bool is_known = line.begin(core::Seconds{support::uniform(rng, 0.0, 3'600.0)});
      while (is_known && way_m < edge.ground_length.value) {
        const motion::QuadraticStretch& stretch = line.stretch();
        const double share = support::uniform(rng, 0.0, 1.0);
        const double at_m = way_m + share * (stretch.end_way_m - way_m);
        const double at_s = std::min(stretch.end_s, 1e5) - support::uniform(rng, 0.0, 3'600.0);
        const double part = at_m / edge.ground_length.value;
        const auto expected = currents({edge.from.x_m + part * (edge.to.x_m - edge.from.x_m),
                                        edge.from.y_m + part * (edge.to.y_m - edge.from.y_m)},
                                       core::Seconds{at_s});

        // An error of 1/4000 of a cell, between neighbours that differ by up to 0.6 m/s.
        ASSERT_TRUE(expected.has_value());
        EXPECT_NEAR(stretch.at(at_m, at_s)->along_m_s, direction(*expected).along_m_s, 4e-4);
        EXPECT_NEAR(stretch.at(at_m, at_s)->across_m_s, direction(*expected).across_m_s, 4e-4);

        way_m = stretch.end_way_m;
        is_known = way_m >= edge.ground_length.value ||
                   (rng() % 2 == 0 && std::isfinite(stretch.end_s) ? line.pass_time() && line.pass_way()
                                                                   : line.pass_way());
      }
    }
  });
}

TEST(CurrentLine, GivesTheTravelTimesAndVerdictsOfTheCurrentAskedPointByPoint) {
  int open = 0;
  int closed = 0;
  int differ = 0;
  support::for_each_seed(40, [&](std::mt19937_64& rng) {
    const PlaneCurrents currents = random_currents(rng, support::uniform(rng, 0.05, 0.35));
    const auto point_by_point = [&](geo::PlanePoint point, core::Seconds time) {
      return currents(point, time);
    };
    for (int i = 0; i < 50; ++i) {
      const motion::PlaneEdge there = random_edge(rng, 8'000.0);
      const motion::PlaneEdge back{there.to, there.from, there.ground_length};
      const core::Seconds depart{support::uniform(rng, 0.0, 40'000.0)};
      for (const motion::PlaneEdge& edge : {there, back}) {
        const auto by_line = motion::edge_time(edge, depart, glider, currents, {.relative_tolerance = 1e-6});
        const auto by_points = motion::edge_time(
            edge, depart, glider, point_by_point,
            {.relative_tolerance = 1e-6, .longest_step = core::Metres{edge.ground_length.value / 20.0}});
        (by_line ? open : closed) += 1;
        if (by_line.has_value() != by_points.has_value()) {
          ++differ;
        } else if (by_line) {
          EXPECT_NEAR(by_line->count(), by_points->count(), 1e-3 * by_points->count());
        } else {
          EXPECT_EQ(by_line.error(), by_points.error());
        }
      }
    }
  });
  EXPECT_GT(open, 1'000);
  EXPECT_GT(closed, 200);
  EXPECT_LT(differ, 10);  // currents within 4e-4 m/s of closing the edge
}

TEST(CurrentLine, EndsWhereTheWaterEndsAndNotBefore) {
  const auto west_of_53 = [](geo::LonLat place, double) -> geo::VelocityEn {
    if (place.lon_deg > -52.95) return {{NAN}, {NAN}};
    return {{0.1}, {0.0}};
  };
  const PlaneCurrents currents{*support::currents_from(west_of_53, hours),   false, dive, projection, area,
                               core::from_unix_seconds(support::sea_start_s)};
  // The node at 53 W is the last with water; the one at 52.9 W takes its neighbours' mean.
  const auto eastward_to = [&](double lon_deg) {
    const geo::PlanePoint from = projection.to_plane({-53.2, 69.0});
    const geo::PlanePoint to = projection.to_plane({lon_deg, 69.0});
    const motion::PlaneEdge edge{from, to, {std::hypot(to.x_m - from.x_m, to.y_m - from.y_m)}};
    return motion::edge_time(edge, core::Seconds{0.0}, glider, currents, {});
  };

  EXPECT_TRUE(eastward_to(-52.9 - 1e-6).has_value());
  ASSERT_FALSE(eastward_to(-52.9 + 1e-3).has_value());
  EXPECT_EQ(eastward_to(-52.9 + 1e-3).error(), motion::EdgeClosed::outside_data);
}

TEST(CurrentLine, EndsWhenTheDataEnd) {
  std::mt19937_64 rng{1};
  const PlaneCurrents currents = random_currents(rng, 0.0);
  const motion::PlaneEdge edge{{-40'000.0, 0.0}, {-39'000.0, 0.0}, {1'000.0}};
  const core::Seconds end{3'600.0 * hours};
  const core::Seconds time{1'000.0 / glider.value};

  EXPECT_TRUE(motion::edge_time(edge, end - time - core::Seconds{1.0}, glider, currents, {}).has_value());
  const auto late = motion::edge_time(edge, end - time + core::Seconds{1.0}, glider, currents, {});
  ASSERT_FALSE(late.has_value());
  EXPECT_EQ(late.error(), motion::EdgeClosed::outside_data);
}

}  // namespace
}  // namespace floeplan::planning::currents::current_line_test
