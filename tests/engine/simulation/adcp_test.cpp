#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "engine/core/random.hpp"
#include "engine/simulation/sensors/adcp_beams.hpp"
#include "engine/simulation/sensors/adcp_error_model.hpp"

namespace floeplan::simulation::adcp_test {
namespace {

/// A jet in depth over a sheared flow: every derivative is there.
Vector jet(Vector place) {
  const double z = place.down;
  const double bell = std::exp(-(z - 100.0) * (z - 100.0) / (2.0 * 18.0 * 18.0));
  return {0.15 + 0.25 * bell, -0.1 + 0.002 * z - 0.1 * bell, 0.0};
}

AdcpMoment moment_at(double heading_deg, double pitch_deg, double roll_deg) {
  AdcpMoment moment;
  moment.state.position = {0.0, 0.0, 60.0};
  moment.state.attitude = {core::degrees_to_radians(heading_deg), core::degrees_to_radians(pitch_deg),
                           core::degrees_to_radians(roll_deg)};
  const Vector ahead = BodyAxes{{core::degrees_to_radians(heading_deg), 0.0, 0.0}}.forward();
  moment.state.through_water = 0.35 * ahead;
  moment.state.through_water.down = pitch_deg < 0.0 ? 0.15 : pitch_deg > 0.0 ? -0.15 : 0.0;
  moment.state.over_ground = moment.state.through_water + jet(moment.state.position);
  moment.sensed = moment.state.attitude;
  moment.column_m = 300.0;
  return moment;
}

/// Mean and covariance of the components of a profile over many runs; east of all bins, then north of all.
class Statistics {
 public:
  void add(std::span<const avoidance::CurrentBin> profile, std::size_t bins) {
    std::vector<double> values;
    for (std::size_t i = 0; i < bins; ++i) values.push_back(profile[i].velocity.east.value);
    for (std::size_t i = 0; i < bins; ++i) values.push_back(profile[i].velocity.north.value);
    runs_.push_back(std::move(values));
  }
  [[nodiscard]] double mean(std::size_t i) const {
    double sum = 0.0;
    for (const auto& run : runs_) sum += run[i];
    return sum / static_cast<double>(runs_.size());
  }
  [[nodiscard]] double covariance(std::size_t i, std::size_t j) const {
    const double mean_i = mean(i);
    const double mean_j = mean(j);
    double sum = 0.0;
    for (const auto& run : runs_) sum += (run[i] - mean_i) * (run[j] - mean_j);
    return sum / static_cast<double>(runs_.size() - 1);
  }

 private:
  std::vector<std::vector<double>> runs_;
};

struct Compared {
  Statistics beams;
  Statistics model;
  std::size_t bins{};
  double model_sigma{};  // that the model states of its first bin
};

constexpr int runs = 400;

Compared compare(const AdcpSettings& settings, AdcpMoment moment) {
  Compared result;
  AdcpErrorModel model{settings};
  auto beams_rng = core::random_stream(1, "beams");
  auto model_rng = core::random_stream(1, "model");
  for (int run = 0; run < runs; ++run) {
    const double never = 1e12;
    moment.reference = next_reference_error(settings, {}, never, beams_rng);
    const auto full = simulate_adcp_beams(settings, moment, jet, beams_rng);
    moment.reference = next_reference_error(settings, {}, never, model_rng);
    const auto cheap = model.profile(moment, jet, model_rng);
    if (run == 0) {
      // A bin at the end of the reach is good in some pings of the beams only, and never or always in the model.
      result.bins = std::min(full.size(), cheap.size()) - 1;
      result.model_sigma = cheap.front().one_sigma.value;
    }
    result.beams.add(full, result.bins);
    result.model.add(cheap, result.bins);
  }
  return result;
}

AdcpSettings small() {
  AdcpSettings settings;
  settings.cells = 10;
  settings.pings = 12;
  return settings;
}

/// The means within 5 standard errors of their difference and 2 mm/s, the covariances within 5 standard errors of
/// normal samples: sqrt((s_ii s_jj + s_ij^2) / n) each.
void expect_alike(const Compared& compared) {
  const std::size_t values = 2 * compared.bins;
  for (std::size_t i = 0; i < values; ++i) {
    const double variance = compared.beams.covariance(i, i);
    const double error = std::sqrt(2.0 * variance / runs);
    EXPECT_NEAR(compared.model.mean(i), compared.beams.mean(i), 5.0 * error + 0.002) << "value " << i;
    for (std::size_t j = i; j < values; ++j) {
      const double covariance = compared.beams.covariance(i, j);
      const double spread = variance * compared.beams.covariance(j, j) + covariance * covariance;
      EXPECT_NEAR(compared.model.covariance(i, j), covariance, 5.0 * std::sqrt(2.0 * spread / runs))
          << "values " << i << " and " << j;
    }
  }
}

TEST(AdcpErrorModel, HasTheMeanAndTheCovariancesOfTheBeamsWhenLevel) {
  expect_alike(compare(small(), moment_at(30.0, 0.0, 0.0)));
}

TEST(AdcpErrorModel, HasTheMeanAndTheCovariancesOfTheBeamsInADive) {
  const Compared dive = compare(small(), moment_at(200.0, -26.0, 3.0));

  EXPECT_GT(dive.bins, 3U);
  expect_alike(dive);
}

TEST(AdcpErrorModel, HasTheCovariancesOfTheBeamsWithoutTheErrorThatAllBinsShare) {
  AdcpSettings settings = small();
  settings.reference_sigma_m_s = 0.0;
  settings.attitude_sigma_rad = 0.0;
  settings.sway_sigma_rad = 0.0;

  expect_alike(compare(settings, moment_at(75.0, 15.0, -5.0)));
}

TEST(AdcpErrorModel, TurnsTheProfileLikeTheBeamsWhenTheCompassIsWrong) {
  AdcpSettings settings = small();
  settings.reference_sigma_m_s = 0.0;
  settings.ping_sigma_m_s = 0.005;
  AdcpMoment moment = moment_at(120.0, -20.0, 0.0);
  moment.sensed.heading_rad += core::degrees_to_radians(6.0);
  moment.sensed.pitch_rad += core::degrees_to_radians(1.5);

  const Compared wrong = compare(settings, moment);

  moment.sensed = moment.state.attitude;
  const Compared right = compare(settings, moment);
  expect_alike(wrong);
  EXPECT_GT(std::abs(wrong.beams.mean(0) - right.beams.mean(0)), 0.01);
}

TEST(AdcpErrorModel, StatesTheSigmaThatItHas) {
  const Compared level = compare(small(), moment_at(30.0, 0.0, 0.0));

  const double found =
      std::sqrt(0.5 * (level.model.covariance(0, 0) + level.model.covariance(level.bins, level.bins)));
  EXPECT_NEAR(level.model_sigma / found, 1.0, 0.12);
}

TEST(AdcpErrorModel, LooksIntoTheWaterATwentiethAsOftenAsTheBeams) {
  const AdcpSettings settings;
  int looks = 0;
  const auto counted = [&](Vector place) {
    ++looks;
    return jet(place);
  };
  auto rng = core::random_stream(2, "looks");
  const AdcpMoment moment = moment_at(0.0, -26.0, 0.0);

  (void)simulate_adcp_beams(settings, moment, counted, rng);
  const int beams = std::exchange(looks, 0);
  AdcpErrorModel model{settings};
  (void)model.profile(moment, counted, rng);

  EXPECT_LT(20 * looks, beams);
  EXPECT_EQ(looks, settings.cells + 2);
}

TEST(AdcpErrorModel, EndsAboveTheSeaBed) {
  AdcpErrorModel model{AdcpSettings{}};
  auto rng = core::random_stream(3, "bed");
  AdcpMoment moment = moment_at(0.0, 0.0, 0.0);
  moment.column_m = 30.0;

  const auto profile = model.profile(moment, jet, rng);

  ASSERT_FALSE(profile.empty());
  for (const auto& bin : profile) EXPECT_LT(bin.depth.value, moment.state.position.down + 30.0);
}

TEST(AdcpErrorModel, IsSilentWhereNoThreeBeamsReach) {
  AdcpErrorModel model{AdcpSettings{}};
  auto rng = core::random_stream(4, "steep");

  EXPECT_TRUE(model.profile(moment_at(0.0, 85.0, 0.0), jet, rng).empty());
}

TEST(AdcpErrorModel, ReportsStillWaterAsStillWithoutErrors) {
  AdcpSettings settings;
  settings.ping_sigma_m_s = 0.0;
  settings.attitude_sigma_rad = 0.0;
  AdcpErrorModel model{settings};
  auto rng = core::random_stream(5, "still");
  const auto still = [](Vector) { return Vector{}; };

  for (const auto& bin : model.profile(moment_at(123.0, -26.0, 4.0), still, rng)) {
    EXPECT_NEAR(bin.velocity.east.value, 0.0, 1e-12);
    EXPECT_NEAR(bin.velocity.north.value, 0.0, 1e-12);
  }
}

TEST(ReferenceError, KeepsItsSizeAndForgetsItself) {
  const AdcpSettings settings;
  auto rng = core::random_stream(6, "reference");
  ReferenceError error = next_reference_error(settings, {}, 1e12, rng);
  double squares = 0.0;
  double products = 0.0;
  constexpr int steps = 40'000;
  for (int i = 0; i < steps; ++i) {
    const ReferenceError next = next_reference_error(settings, error, settings.reference_time_s, rng);
    squares += next.east_m_s * next.east_m_s;
    products += next.east_m_s * error.east_m_s;
    error = next;
  }

  const double variance = settings.reference_sigma_m_s * settings.reference_sigma_m_s;
  EXPECT_NEAR(squares / steps / variance, 1.0, 0.05);
  EXPECT_NEAR(products / steps / variance, std::exp(-1.0), 0.05);
}

TEST(AdcpSettings, AreRefusedWithEveryReason) {
  AdcpSettings settings;
  settings.cells = 1;
  settings.pings = 100;
  settings.ping_sigma_m_s = -1.0;

  EXPECT_EQ(settings.violations().size(), 3U);
  EXPECT_THROW(AdcpErrorModel{settings}, std::invalid_argument);
}

}  // namespace
}  // namespace floeplan::simulation::adcp_test
