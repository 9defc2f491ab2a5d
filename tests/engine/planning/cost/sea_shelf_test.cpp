#include "engine/planning/cost/sea_shelf.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/planning/cost/sea.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::cost::sea_shelf_test {
namespace {

constexpr core::Metres cell{2000.0};

plane::PlaneBox box_about(double half_width_m) {
  return {{-half_width_m, -half_width_m}, {half_width_m, half_width_m}};
}

/// Currents that differ from place to place, from level to level and from hour to hour.
std::shared_ptr<const ocean::CurrentGrid> uneven_currents() {
  const ocean::HorizontalGrid grid = support::sea_grid();
  ocean::CurrentGrid::Samples samples{.grid = grid,
                                      .depths_m = ocean::Axis{{0.0, 20.0, 60.0, 150.0, 300.0}},
                                      .times_s = support::steps(support::sea_start_s, 3600.0, 13),
                                      .u = {},
                                      .v = {}};
  for (int hour = 0; hour <= 12; ++hour) {
    for (const double depth_m : samples.depths_m->nodes()) {
      for (std::size_t i = 0; i < grid.size(); ++i) {
        const double angle = 0.4 * hour + 0.01 * depth_m + 0.001 * static_cast<double>(i);
        samples.u.push_back(static_cast<float>(0.3 * std::cos(angle)));
        samples.v.push_back(static_cast<float>(0.3 * std::sin(angle)));
      }
    }
  }
  return std::make_shared<const ocean::CurrentGrid>(std::move(samples));
}

ocean::Environment icy_sea() {
  ocean::Environment environment;
  environment.currents = uneven_currents();
  environment.ice = support::ice_from(
      [](geo::LonLat p, double hour) {
        return 0.5 + 0.5 * std::sin(20.0 * p.lon_deg + 15.0 * p.lat_deg + 0.2 * hour);
      },
      {0.0, 6.0, 12.0}, 1.0);
  return environment;
}

PlanRequest request_in_the_sea() {
  PlanRequest request = support::eastward_request();
  request.depart = core::from_unix_seconds(support::sea_start_s);
  return request;
}

void expect_the_same(const currents::PlaneCurrents& taken, const currents::PlaneCurrents& fresh,
                     double half_width_m, std::mt19937_64& rng) {
  EXPECT_EQ(taken.end(), fresh.end());
  for (int i = 0; i < 200; ++i) {
    const geo::PlanePoint point{support::uniform(rng, -half_width_m, half_width_m),
                                support::uniform(rng, -half_width_m, half_width_m)};
    const core::Seconds time{support::uniform(rng, -3600.0, 13.0 * 3600.0)};
    const auto here = taken(point, time);
    const auto there = fresh(point, time);
    ASSERT_EQ(here.has_value(), there.has_value());
    if (!here) continue;
    ASSERT_EQ(here->x_m_s, there->x_m_s);
    ASSERT_EQ(here->y_m_s, there->y_m_s);
  }
}

TEST(SeaShelf, GivesWhatWouldBeLaidOut) {
  const ocean::Environment environment = icy_sea();
  support::for_each_seed(4, [&](std::mt19937_64& rng) {
    SeaShelf shelf;
    PlanRequest request = request_in_the_sea();
    double half_width_m = 20'000.0;
    geo::LonLat origin{-53.0, 69.0};
    for (int i = 0; i < 12; ++i) {
      switch (support::uniform_int(rng, 0, 7)) {
        case 0: request.depart += core::Seconds{3600.0 * support::uniform_int(rng, -1, 1)}; break;
        case 1: request.vehicle.dive_depth = core::Metres{support::uniform(rng, 100.0, 300.0)}; break;
        case 2: request.under_ice.margin_below_ice = core::Metres{support::uniform(rng, 5.0, 40.0)}; break;
        case 3: request.under_ice.max_concentration_to_surface = support::uniform(rng, 0.0, 1.0); break;
        case 4: half_width_m = support::uniform(rng, 15'000.0, 25'000.0); break;
        case 5: origin.lon_deg = support::uniform(rng, -53.2, -52.8); break;
        case 6: request.icebergs.margin = core::Metres{support::uniform(rng, 0.0, 1000.0)}; break;
        default: request.holds.longest = core::Seconds{support::uniform(rng, 0.0, 7200.0)};
      }
      const geo::LocalProjection projection{origin};
      const plane::PlaneBox area = box_about(half_width_m);

      const Sea with{environment, request, projection, area, cell, {}, &shelf};

      const Sea without{environment, request, projection, area, cell};
      expect_the_same(*with.domain().currents(), *without.domain().currents(), half_width_m, rng);
      EXPECT_TRUE(shelf.holds_currents(environment, request, projection, area));
    }
  });
}

TEST(SeaShelf, LaysCurrentsOutOnceWhereTheRequestsDifferInOtherThings) {
  const ocean::Environment environment = icy_sea();
  const geo::LocalProjection projection{{-53.0, 69.0}};
  SeaShelf shelf;
  const PlanRequest request = request_in_the_sea();
  PlanRequest patient = request;
  patient.holds.longest = core::Seconds{7200.0};
  patient.icebergs.margin = core::Metres{100.0};
  patient.vehicle.speed_through_water = {1.0};
  patient.under_ice.max_time_without_surfacing = core::Seconds{7200.0};

  const Sea first{environment, request, projection, box_about(10'000.0), cell, {}, &shelf};
  const Sea wider{environment, request, projection, box_about(20'000.0), cell, {}, &shelf};
  const Sea again{environment, patient, projection, box_about(10'000.0), cell, {}, &shelf};

  EXPECT_NE(first.domain().currents(), wider.domain().currents());
  EXPECT_EQ(first.domain().currents(), again.domain().currents());
}

TEST(SeaShelf, KeepsNothingThatWasNotFinished) {
  const ocean::Environment environment = icy_sea();
  const geo::LocalProjection projection{{-53.0, 69.0}};
  SeaShelf shelf;
  std::stop_source stopped;
  stopped.request_stop();

  const Sea unfinished{environment, request_in_the_sea(), projection, box_about(10'000.0),
                       cell,        stopped.get_token(),  &shelf};

  EXPECT_FALSE(shelf.holds_currents(environment, request_in_the_sea(), projection, box_about(10'000.0)));
}

TEST(SeaShelf, HasNoneInStillWater) {
  const ocean::Environment still;
  SeaShelf shelf;

  const Sea sea{
      still, request_in_the_sea(), geo::LocalProjection{{-53.0, 69.0}}, box_about(10'000.0), cell, {},
      &shelf};

  EXPECT_EQ(sea.domain().currents(), nullptr);
}

TEST(SeaShelf, SharesTheIcebergsWhereOnlyTheCurrentsOfTheVehicleDiffer) {
  ocean::Environment environment = icy_sea();
  environment.icebergs = {support::iceberg_at({-53.0, 69.02}, 200.0)};
  environment.drift_currents = environment.currents;
  ocean::Environment other_currents = environment;
  other_currents.currents = uneven_currents();
  ocean::Environment other_drift = other_currents;
  other_drift.drift_currents = other_currents.currents;
  ocean::Environment moved = environment;
  moved.icebergs.front().place.lat_deg += 0.01;
  const geo::LocalProjection projection{{-53.0, 69.0}};
  const PlanRequest request = request_in_the_sea();
  PlanRequest later = request;
  later.depart += core::Seconds{3600.0};
  PlanRequest passing_under = request;
  passing_under.icebergs.pass_under = true;
  SeaShelf shelf;
  const auto icebergs = [&](const ocean::Environment& sea, const PlanRequest& asked) {
    return shelf.icebergs(sea, asked, projection, box_about(10'000.0), nullptr, {});
  };

  const auto first = icebergs(environment, request);

  EXPECT_EQ(icebergs(other_currents, request), first);
  EXPECT_NE(icebergs(other_drift, request), first);
  EXPECT_EQ(icebergs(environment, request), first);
  EXPECT_NE(icebergs(moved, request), first);
  EXPECT_NE(icebergs(environment, later), first);
  EXPECT_NE(icebergs(environment, passing_under), icebergs(environment, passing_under));
}

TEST(SeaShelf, SharesTheBedWhereOnlyTheDepartureDiffers) {
  ocean::Environment environment = icy_sea();
  environment.bathymetry = support::bathymetry_from([](geo::LonLat) { return 300.0; });
  const geo::LocalProjection projection{{-53.0, 69.0}};
  const PlanRequest request = request_in_the_sea();
  PlanRequest later = request;
  later.depart += core::Seconds{3600.0};
  PlanRequest shallower = request;
  shallower.vehicle.dive_depth = core::Metres{100.0};
  SeaShelf shelf;
  const auto bed = [&](const PlanRequest& asked, core::Metres step) {
    return shelf.bed_below(environment, asked, projection, box_about(10'000.0), step, {});
  };

  const auto first = bed(request, cell);

  ASSERT_NE(first, nullptr);
  EXPECT_EQ(bed(later, cell), first);
  EXPECT_NE(bed(shallower, cell), first);
  EXPECT_EQ(bed(request, cell), first);
  EXPECT_NE(bed(request, core::Metres{1000.0}), first);
}

}  // namespace
}  // namespace floeplan::planning::cost::sea_shelf_test
