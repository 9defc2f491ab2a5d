#include "engine/ocean/currents/current_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/ocean/currents/current_rows.hpp"

namespace floeplan::ocean::current_error_test {
namespace {

constexpr CurrentErrorModel model{{0.1}, {20'000.0}, core::Seconds{6.0 * 3600.0}};

/// Still water on about 200 x 200 km around 69 N for two days, one node without water.
CurrentGrid still_water() {
  std::vector<double> lons;
  std::vector<double> lats;
  std::vector<double> times;
  for (int i = 0; i <= 40; ++i) {
    lons.push_back(-55.0 + 0.125 * i);
    lats.push_back(68.0 + 0.045 * i);
  }
  for (int i = 0; i <= 16; ++i) times.push_back(1.8e9 + 10'800.0 * i);
  CurrentGrid::Samples samples{.grid = {geo::GeographicFrame{}, Axis{lons}, Axis{lats}},
                               .depths_m = std::nullopt,
                               .times_s = Axis{times},
                               .u = std::vector<float>(lons.size() * lats.size() * times.size(), 0.0F),
                               .v = std::vector<float>(lons.size() * lats.size() * times.size(), 0.0F)};
  samples.u[5] = NAN;
  samples.v[5] = NAN;
  return CurrentGrid{std::move(samples)};
}

/// The currents at all nodes and times, [time][y][x].
CurrentGrid::Added values(const CurrentGrid& currents) {
  CurrentGrid::Added all;
  const std::size_t rows = currents.samples().grid.y().size();
  for (std::size_t time = 0; time < currents.times_s().size(); ++time) {
    const CurrentRows part{currents, time, 0, rows};
    all.u.insert(all.u.end(), part.u().begin(), part.u().end());
    all.v.insert(all.v.end(), part.v().begin(), part.v().end());
  }
  return all;
}

double mean_product(const std::vector<float>& a, const std::vector<float>& b, std::size_t shift) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i + shift < a.size(); ++i) {
    if (std::isnan(a[i]) || std::isnan(b[i + shift])) continue;
    sum += static_cast<double>(a[i]) * static_cast<double>(b[i + shift]);
    count += 1.0;
  }
  return sum / count;
}

TEST(CurrentError, HasTheDeviationOfItsModelAndNoBias) {
  const CurrentGrid still = still_water();
  double variance = 0.0;
  double mean = 0.0;
  constexpr int draws = 40;
  for (int seed = 1; seed <= draws; ++seed) {
    std::mt19937_64 rng{static_cast<std::uint64_t>(seed)};
    const auto erring = values(with_error(still, model, rng));
    variance += (mean_product(erring.u, erring.u, 0) + mean_product(erring.v, erring.v, 0)) / (2.0 * draws);
    const std::vector<float> ones(erring.u.size(), 1.0F);
    mean += mean_product(erring.u, ones, 0) / draws;
  }
  EXPECT_NEAR(std::sqrt(variance), 0.1, 0.01);
  EXPECT_NEAR(mean, 0.0, 0.01);
}

TEST(CurrentError, IsAlikeNearbyAndForgottenFarAwayAndLater) {
  const CurrentGrid still = still_water();
  const std::size_t slice = 41 * 41;
  double near_by = 0.0;
  double later = 0.0;
  double much_later = 0.0;
  double all = 0.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    std::mt19937_64 rng{seed};
    const auto samples = values(with_error(still, model, rng));
    all += mean_product(samples.v, samples.v, 0);
    near_by += mean_product(samples.v, samples.v, 41);             // 5 km north
    later += mean_product(samples.v, samples.v, slice);            // 3 hours
    much_later += mean_product(samples.v, samples.v, 12 * slice);  // 36 hours
  }
  // v varies along y like the bell itself: exp(-d^2 / 2 L^2) and exp(-t^2 / 2 T^2).
  EXPECT_NEAR(near_by / all, std::exp(-0.5 * std::pow(5.0 / 20.0, 2)), 0.03);
  EXPECT_NEAR(later / all, std::exp(-0.5 * std::pow(3.0 / 6.0, 2)), 0.05);
  EXPECT_NEAR(much_later / all, 0.0, 0.1);
}

TEST(CurrentError, IsTheSameForTheSameSeedAndLeavesMissingNodesMissing) {
  const CurrentGrid still = still_water();
  std::mt19937_64 first{7};
  std::mt19937_64 second{7};
  std::mt19937_64 other{8};

  const auto a = values(with_error(still, model, first)).u;
  const auto b = values(with_error(still, model, second)).u;
  const auto c = values(with_error(still, model, other)).u;

  EXPECT_TRUE(std::isnan(a[5]));
  EXPECT_EQ(a[0], b[0]);
  EXPECT_EQ(a.back(), b.back());
  EXPECT_NE(a.back(), c.back());
}

TEST(CurrentError, IsTheSameAtEveryDepthAndSharesTheData) {
  CurrentGrid::Samples samples{.grid = {geo::GeographicFrame{}, Axis{{-54.0, -53.0}}, Axis{{69.0, 69.2}}},
                               .depths_m = Axis{{0.0, 100.0}},
                               .times_s = Axis{{1.8e9, 1.8e9 + 3600.0}},
                               .u = std::vector<float>(16, 0.25F),
                               .v = std::vector<float>(16, -0.5F)};
  const CurrentGrid currents{std::move(samples)};
  std::mt19937_64 rng{3};
  const CurrentGrid erring = with_error(currents, model, rng);

  EXPECT_EQ(&erring.samples(), &currents.samples());
  for (const double time_s : {1.8e9, 1.8e9 + 900.0}) {
    const core::UtcTime time = core::from_unix_seconds(time_s);
    const geo::LonLat place{-53.4, 69.05};
    const auto above = erring.at(place, {0.0}, time).value();
    const auto below = erring.at(place, {80.0}, time).value();
    EXPECT_NE(above.east.value, 0.25);
    EXPECT_EQ(above.east.value, below.east.value);
    EXPECT_EQ(above.north.value, below.north.value);
  }
}

TEST(CurrentError, NamesEveryFaultOfAModel) {
  EXPECT_EQ((CurrentErrorModel{{0.0}, {10.0}, core::Seconds{NAN}}.violations().size()), 3U);
  EXPECT_TRUE(model.violations().empty());
}

}  // namespace
}  // namespace floeplan::ocean::current_error_test
