#include "engine/ocean/currents/current_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/property.hpp"

namespace floeplan::ocean::current_rows_test {
namespace {

using support::uniform;
using support::uniform_int;

constexpr float missing = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t columns = 3;
constexpr std::size_t rows = 4;
constexpr std::size_t levels = 2;

HorizontalGrid small_grid() {
  return {geo::GeographicFrame{}, Axis{{-54.0, -53.5, -53.0}}, Axis{{69.0, 69.1, 69.2, 69.3}}};
}

CurrentGrid::Samples random_samples(std::mt19937_64& rng, std::vector<double> times_s) {
  CurrentGrid::Samples samples{.grid = small_grid(),
                               .depths_m = Axis{{5.0, 50.0}},
                               .times_s = Axis{std::move(times_s)},
                               .u = {},
                               .v = {}};
  for (std::size_t i = 0; i < samples.times_s.size() * levels * rows * columns; ++i) {
    samples.u.push_back(uniform_int(rng, 0, 9) == 0 ? missing : static_cast<float>(uniform(rng, -1.0, 1.0)));
    samples.v.push_back(static_cast<float>(uniform(rng, -1.0, 1.0)));
  }
  return samples;
}

/// Constants at every node but the first.
std::shared_ptr<const TidalCurrents> a_tide(std::mt19937_64& rng) {
  TideGrid::Field east(rows * columns);
  for (auto& constant : east) constant = {static_cast<float>(uniform(rng, 0.1, 0.5)), 0.1F};
  east.front() = {missing, missing};
  const std::vector<TideGrid> models{
      TideGrid{{small_grid(), {{tide::find_constituent("M2").value(), {}, east, east}}}}};
  return std::make_shared<const TidalCurrents>(
      small_grid(), models, TidalCurrents::Times{core::from_unix_seconds(0.0), core::Seconds{600.0}, 13});
}

/// Expects the value that the column gives for its uppermost level.
void expect_as_columns(const CurrentGrid& currents) {
  for (std::size_t time = 0; time < currents.times_s().size(); ++time) {
    const CurrentRows part{currents, time, 1, 2};
    for (std::size_t iy = 1; iy < 3; ++iy) {
      for (std::size_t ix = 0; ix < columns; ++ix) {
        const std::size_t i = (iy - 1) * part.columns() + ix;
        const auto column = currents.column_at_node(ix, iy, time);
        ASSERT_EQ(column.has_value(), !std::isnan(part.u()[i]) && !std::isnan(part.v()[i]));
        if (!column) continue;
        EXPECT_NEAR(static_cast<double>(part.u()[i]), column->mean({0.0}, {0.0}).east.value, 1e-6);
        EXPECT_NEAR(static_cast<double>(part.v()[i]), column->mean({0.0}, {0.0}).north.value, 1e-6);
        const float below = part.u()[part.level_stride() + i];
        if (std::isnan(below)) continue;
        EXPECT_NEAR(static_cast<double>(below), column->mean({50.0}, {50.0}).east.value, 1e-6);
      }
    }
  }
}

TEST(CurrentRows, AreTheSamplesOfTheirRows) {
  support::for_each_seed(
      20, [](std::mt19937_64& rng) { expect_as_columns(CurrentGrid{random_samples(rng, {0.0, 3600.0})}); });
}

TEST(CurrentRows, HoldTheTideBetweenTheTimesOfTheSamplesToo) {
  support::for_each_seed(20, [](std::mt19937_64& rng) {
    expect_as_columns(CurrentGrid{random_samples(rng, {0.0, 3600.0, 7200.0}), a_tide(rng)});
    expect_as_columns(CurrentGrid{random_samples(rng, {0.0}), a_tide(rng)});
  });
}

TEST(CurrentRows, HoldTheAddedCurrentWithAndWithoutATide) {
  support::for_each_seed(20, [](std::mt19937_64& rng) {
    const auto with_added = [&](const CurrentGrid& currents) {
      CurrentGrid::Added added;
      for (std::size_t i = 0; i < currents.samples().times_s.size() * rows * columns; ++i) {
        added.u.push_back(static_cast<float>(uniform(rng, -0.5, 0.5)));
        added.v.push_back(static_cast<float>(uniform(rng, -0.5, 0.5)));
      }
      return currents.with_added(std::move(added));
    };
    expect_as_columns(with_added(CurrentGrid{random_samples(rng, {0.0, 3600.0})}));
    expect_as_columns(with_added(CurrentGrid{random_samples(rng, {0.0, 3600.0, 7200.0}), a_tide(rng)}));
    expect_as_columns(with_added(CurrentGrid{random_samples(rng, {0.0}), a_tide(rng)}));
  });
}

TEST(CurrentRows, MissWhereTheTideDoes) {
  std::mt19937_64 rng{7};
  const CurrentGrid currents{random_samples(rng, {0.0}), a_tide(rng)};

  EXPECT_TRUE(std::isnan(CurrentRows(currents, 3, 0, 1).u()[0]));
}

}  // namespace
}  // namespace floeplan::ocean::current_rows_test
