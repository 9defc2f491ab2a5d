#include <gtest/gtest.h>

#include <cmath>

#include "engine/planning/currents/plane_currents.hpp"
#include "engine/planning/ice/under_ice.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::currents::flown_currents_test {
namespace {

using support::sea_start_s;
using support::shear_east_m_s;
using support::shear_level_m;
using support::steps;

const geo::LocalProjection projection{{-53.0, 69.0}};
const plane::PlaneBox area{{-30'000.0, -30'000.0}, {30'000.0, 30'000.0}};
constexpr vehicle::DiveLimits limits{.climb_to = {5.0}, .dive_to = {200.0}, .altimeter_margin = {10.0}};
double sheared_at(double depth_m) {
  for (std::size_t i = 1; i < std::size(shear_level_m); ++i) {
    if (depth_m > shear_level_m[i]) continue;
    const double share = (depth_m - shear_level_m[i - 1]) / (shear_level_m[i] - shear_level_m[i - 1]);
    return shear_east_m_s[i - 1] + share * (shear_east_m_s[i] - shear_east_m_s[i - 1]);
  }
  return shear_east_m_s[std::size(shear_level_m) - 1];
}

/// A bank of 40 m depth in a sea of 400 m; by default hardly wider than a cell of the currents.
double bank_m(geo::LonLat place, double half_width_deg = 0.06) {
  const double away = std::abs(place.lon_deg + 53.05) / half_width_deg;
  return 400.0 - 360.0 * std::exp(-away * away);
}

std::shared_ptr<const ocean::Bathymetry> fine_bathymetry(double half_width_deg = 0.06,
                                                         double step_deg = 0.01) {
  const auto nodes = [&](double extent_deg) {
    return static_cast<int>(std::lround(extent_deg / step_deg)) + 1;
  };
  const ocean::HorizontalGrid grid{geo::GeographicFrame{}, steps(-54.0, step_deg, nodes(2.0)),
                                   steps(68.5, step_deg, nodes(1.0))};
  std::vector<float> depth_m;
  for (std::size_t iy = 0; iy < grid.y().size(); ++iy) {
    for (std::size_t ix = 0; ix < grid.x().size(); ++ix) {
      depth_m.push_back(static_cast<float>(bank_m(grid.place(ix, iy), half_width_deg)));
    }
  }
  return std::make_shared<const ocean::Bathymetry>(grid, std::move(depth_m));
}

PlaneCurrents over(std::shared_ptr<const ocean::Bathymetry> bed) {
  return {*support::sheared_currents(),        true, {limits, std::move(bed)}, projection, area,
          core::from_unix_seconds(sea_start_s)};
}

PlaneCurrents over_the_bank() { return over(fine_bathymetry()); }

/// Mean of the current over the time of one dive and climb at one place.
double mean_of_a_yo(double top_m, double bottom_m) {
  double sum = 0.0;
  constexpr int samples = 20'000;
  for (int i = 0; i < samples; ++i) {
    const double phase = 2.0 * (i + 0.5) / samples;  // down in the first half, up in the second
    const double share = phase < 1.0 ? phase : 2.0 - phase;
    sum += sheared_at(top_m + share * (bottom_m - top_m));
  }
  return sum / samples;
}

TEST(FlownCurrents, AreTheMeanOfAYoOverTheSeaBedAtEveryNodeOfTheCutCells) {
  const PlaneCurrents currents = over_the_bank();

  for (int i = 0; i <= 8; ++i) {  // cells of 0.1 degrees in four parts
    const geo::LonLat place{-53.1 + 0.025 * i, 69.0};
    const double bottom_m = std::min(200.0, bank_m(place) - 10.0);
    const auto flown = currents(projection.to_plane(place), core::Seconds{0.0});

    ASSERT_TRUE(flown.has_value());
    EXPECT_NEAR(std::hypot(flown->x_m_s, flown->y_m_s), std::abs(mean_of_a_yo(5.0, bottom_m)), 5e-3) << i;
  }
}

/// A sill a quarter as wide as a cell of the currents. Four samples of the cell would miss it.
TEST(FlownCurrents, FeelABankMuchNarrowerThanACellOfTheData) {
  constexpr double half_width_deg = 0.012;
  const PlaneCurrents currents = over(fine_bathymetry(half_width_deg, 0.0025));

  double most_missed_m_s = 0.0;
  for (double lon_deg = -53.1; lon_deg <= -53.0; lon_deg += 0.001) {
    const geo::LonLat place{lon_deg, 69.0};
    const double bottom_m = std::min(200.0, bank_m(place, half_width_deg) - 10.0);
    const auto flown = currents(projection.to_plane(place), core::Seconds{0.0});
    ASSERT_TRUE(flown.has_value());
    most_missed_m_s = std::max(most_missed_m_s, std::abs(std::hypot(flown->x_m_s, flown->y_m_s) -
                                                         std::abs(mean_of_a_yo(5.0, bottom_m))));
  }
  EXPECT_LT(most_missed_m_s, 0.05) << "four parts of a cell miss 0.3 m/s of it";
}

TEST(FlownCurrents, CutNoCellMoreThanABankIsSteep) {
  const core::Metres cell = support::sheared_currents()->samples().grid.spacing();

  EXPECT_NEAR(over(fine_bathymetry(0.6)).spacing().value, 0.25 * cell.value, 1.0);
}

TEST(FlownCurrents, CarryAGliderOverABankAsItsSimulatedYoDoes) {
  const PlaneCurrents currents = over_the_bank();
  constexpr double sink_m_s = 0.19;
  constexpr double speed_m_s = 0.35;
  constexpr double step_s = 5.0;
  constexpr int starts = 10;  // of the saw-tooth, whose phase over the bank nobody can choose
  double drift_yo_m = 0.0;
  double drift_plane_m = 0.0;

  for (int start = 0; start < starts; ++start) {
    double depth_m = 5.0 + 195.0 * start / starts;
    double direction = start % 2 == 0 ? 1.0 : -1.0;
    for (double x_m = -12'000.0; x_m < 8'000.0; x_m += speed_m_s * step_s) {
      const geo::PlanePoint point{x_m, 0.0};
      const double bottom_m = std::min(200.0, bank_m(projection.to_lon_lat(point)) - 10.0);
      if (depth_m >= bottom_m) direction = -1.0;
      if (depth_m <= 5.0) direction = 1.0;
      depth_m += direction * sink_m_s * step_s;
      drift_yo_m += sheared_at(depth_m) * step_s / starts;
      drift_plane_m += currents(point, core::Seconds{0.0})->x_m_s * step_s / starts;
    }
  }

  const double over_deep_water_m = mean_of_a_yo(5.0, 200.0) * 20'000.0 / speed_m_s;
  EXPECT_GT(std::abs(drift_yo_m - over_deep_water_m), 1'500.0);  // the bank matters
  EXPECT_NEAR(drift_plane_m, drift_yo_m, 0.06 * std::abs(drift_yo_m - over_deep_water_m));
}

TEST(FlownCurrents, NeedNoFinerCellsWhereTheSeaBedIsOutOfReach) {
  const auto deep = support::bathymetry_from([](geo::LonLat) { return 500.0; });
  const PlaneCurrents plain{*support::sheared_currents(), true, {limits, nullptr}, projection, area,
                            core::from_unix_seconds(0.0)};
  const PlaneCurrents over_deep{*support::sheared_currents(), true, {limits, deep}, projection, area,
                                core::from_unix_seconds(0.0)};

  EXPECT_EQ(over_deep.spacing(), plain.spacing());
  EXPECT_LT(over_the_bank().spacing(), plain.spacing());
}

TEST(FlownCurrents, BeginAtTheTopOfTheSawTooth) {
  const PlaneCurrents deeper{*support::sheared_currents(),
                             true,
                             {{.climb_to = {75.0}, .dive_to = {200.0}, .altimeter_margin = {10.0}}, nullptr},
                             projection,
                             area,
                             core::from_unix_seconds(0.0)};

  const auto current = deeper({0.0, 0.0}, core::Seconds{0.0});

  EXPECT_LT(current->x_m_s, -0.1);
}

/// Law: while ice lies above, the band begins where the dives turn below it; before and beside it, at their usual top.
TEST(FlownCurrents, BeginBelowTheIceWhileItIsThere) {
  const auto ice = support::ice_from(
      [](geo::LonLat p, double hour) { return p.lon_deg > -53.0 && hour > 10.5 ? 1.0 : 0.0; },
      {0.0, 10.0, 11.0, 20.0}, 6.0);
  const PlanRequest request = support::eastward_request();
  const ocean::Environment environment{.ice = ice};
  PlanRequest at_start = request;
  at_start.depart = core::from_unix_seconds(sea_start_s);
  const ice::UnderIce below{environment, at_start, projection, area, core::Metres{500.0}, nullptr};
  const auto lasting = support::sheared_currents(20);
  const PlaneCurrents currents{*lasting, false, {limits, nullptr}, projection, area, at_start.depart,
                               {},       &below};
  const geo::PlanePoint east{20'000.0, 0.0};
  const geo::PlanePoint west{-20'000.0, 0.0};
  const core::Seconds open{5.0 * 3600.0};
  const core::Seconds closed{15.0 * 3600.0};
  const double turn_m = std::ceil(below.least_upper_turn(east, closed).value);
  ASSERT_GT(turn_m, 40.0);

  EXPECT_NEAR(currents(east, closed)->x_m_s, mean_of_a_yo(turn_m, 200.0), 2e-3);
  EXPECT_NEAR(currents(east, open)->x_m_s, mean_of_a_yo(5.0, 200.0), 2e-3);
  EXPECT_NEAR(currents(west, closed)->x_m_s, mean_of_a_yo(5.0, 200.0), 2e-3);
}

}  // namespace
}  // namespace floeplan::planning::currents::flown_currents_test
