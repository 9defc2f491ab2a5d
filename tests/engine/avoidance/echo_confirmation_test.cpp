#include "engine/avoidance/echo_confirmation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "engine/core/random.hpp"

namespace floeplan::avoidance::echo_confirmation_test {
namespace {

Echo echo(double x, double y, double depth = 10.0) { return {{x, y}, depth, std::hypot(x, y)}; }

TEST(EchoConfirmation, TakesAnEchoThatComesBackInThreePings) {
  const auto confirmation = std::make_unique<EchoConfirmation>();
  confirmation->begin_ping();
  EXPECT_FALSE(confirmation->take(echo(100.0, 0.0)));
  confirmation->begin_ping();
  EXPECT_FALSE(confirmation->take(echo(101.0, 0.0)));
  confirmation->begin_ping();
  const auto found = confirmation->take(echo(102.0, 3.0));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->place.x_m, 101.0, 1e-12);
  EXPECT_NEAR(found->place.y_m, 1.0, 1e-12);
}

TEST(EchoConfirmation, CountsAPingOnce) {
  const auto confirmation = std::make_unique<EchoConfirmation>();
  confirmation->begin_ping();
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(confirmation->take(echo(100.0, 0.0)));
}

TEST(EchoConfirmation, ForgetsWhatDoesNotComeBackInTime) {
  const auto confirmation = std::make_unique<EchoConfirmation>();
  for (int ping = 0; ping < 30; ++ping) {
    confirmation->begin_ping();
    if (ping % 3 == 0) {
      EXPECT_FALSE(confirmation->take(echo(100.0, 0.0)));
    }
  }
}

TEST(EchoConfirmation, KeepsDepthsApart) {
  const auto confirmation = std::make_unique<EchoConfirmation>();
  for (int ping = 0; ping < 4; ++ping) {
    confirmation->begin_ping();
    EXPECT_FALSE(confirmation->take(echo(100.0, 0.0, ping % 2 == 0 ? 10.0 : 30.0))) << ping;
  }
}

/// Half a false alarm in each ping, anywhere in the fan: less than one false surface in an hour, as stated.
TEST(EchoConfirmation, RejectsFalseAlarmsAtTheStatedRate) {
  const auto confirmation = std::make_unique<EchoConfirmation>();
  auto rng = core::random_stream(1, "false alarms");
  constexpr int hours = 40;
  int confirmed = 0;
  for (int ping = 0; ping < hours * 3600; ++ping) {
    confirmation->begin_ping();
    const int alarms = core::poisson(rng, 0.5);
    for (int i = 0; i < alarms; ++i) {
      const double range_m = 200.0 * core::uniform(rng);
      const double bearing = (core::uniform(rng) - 0.5) * 2.0 * std::numbers::pi / 3.0;
      const double depth_m = 60.0 * core::uniform(rng);
      if (confirmation->take(echo(range_m * std::sin(bearing), range_m * std::cos(bearing), depth_m)))
        ++confirmed;
    }
  }
  EXPECT_LT(confirmed, hours);
}

}  // namespace
}  // namespace floeplan::avoidance::echo_confirmation_test
