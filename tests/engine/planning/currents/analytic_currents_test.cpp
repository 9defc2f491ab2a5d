#include "engine/planning/currents/analytic_currents.hpp"

#include <gtest/gtest.h>

#include "tests/support/property.hpp"

namespace floeplan::planning::currents::analytic_currents_test {
namespace {

constexpr double step = 1e-4;
constexpr double tolerance = 1e-6;

/// Slopes against difference quotients of the velocity, and the velocity against itself.
template <motion::SlopedPlaneCurrent Current>
void expect_slopes_match(const Current& current, geo::PlanePoint at, core::Seconds time) {
  const auto sloped = current.slopes_at(at, time).value();
  const auto here = current(at, time).value();
  const auto west = current(geo::PlanePoint{at.x_m - step, at.y_m}, time).value();
  const auto east = current(geo::PlanePoint{at.x_m + step, at.y_m}, time).value();
  const auto south = current(geo::PlanePoint{at.x_m, at.y_m - step}, time).value();
  const auto north = current(geo::PlanePoint{at.x_m, at.y_m + step}, time).value();

  EXPECT_DOUBLE_EQ(sloped.velocity.x_m_s, here.x_m_s);
  EXPECT_DOUBLE_EQ(sloped.velocity.y_m_s, here.y_m_s);
  EXPECT_NEAR(sloped.dx_dx, (east.x_m_s - west.x_m_s) / (2.0 * step), tolerance);
  EXPECT_NEAR(sloped.dy_dx, (east.y_m_s - west.y_m_s) / (2.0 * step), tolerance);
  EXPECT_NEAR(sloped.dx_dy, (north.x_m_s - south.x_m_s) / (2.0 * step), tolerance);
  EXPECT_NEAR(sloped.dy_dy, (north.y_m_s - south.y_m_s) / (2.0 * step), tolerance);
}

TEST(AnalyticCurrents, HaveTheSlopesOfTheirVelocities) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    const core::Seconds time{support::uniform(rng, 0.0, 30.0)};
    expect_slopes_match(MeanderingJet{},
                        {support::uniform(rng, -10.0, 10.0), support::uniform(rng, -5.0, 5.0)}, time);
    expect_slopes_match(RiverCurrent{}, {support::uniform(rng, 1.0, 299.0), 0.0}, time);
  });
}

}  // namespace
}  // namespace floeplan::planning::currents::analytic_currents_test
