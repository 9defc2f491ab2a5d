#include "engine/ocean/currents/tidal_currents.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "engine/ocean/currents/current_grid.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ocean::tidal_currents_test {
namespace {

using support::for_each_seed;
using support::uniform;

const core::UtcTime start = core::from_unix_seconds(1'795'000'000.0);

HorizontalGrid small_grid() {
  return {geo::GeographicFrame{}, Axis{{-54.0, -53.5, -53.0}}, Axis{{69.0, 69.25}}};
}

/// A tide of the named lines with random constants at each node.
TideGrid random_tide(std::mt19937_64& rng, const HorizontalGrid& grid,
                     const std::vector<std::string>& names) {
  TideGrid::Samples samples{grid, {}};
  const auto field = [&] {
    TideGrid::Field values;
    for (std::size_t i = 0; i < grid.size(); ++i)
      values.push_back(
          {static_cast<float>(uniform(rng, -0.5, 0.5)), static_cast<float>(uniform(rng, -0.5, 0.5))});
    return values;
  };
  for (const std::string& name : names)
    samples.lines.push_back({tide::find_constituent(name).value(), field(), field(), field()});
  return TideGrid{std::move(samples)};
}

TEST(TideGrid, IsBilinearInTheConstants) {
  std::mt19937_64 rng{1};
  const TideGrid model = random_tide(rng, small_grid(), {"M2"});
  const auto& field = model.samples().lines.front().elevation;

  const auto middle = model.constants(TideQuantity::elevation, {-53.75, 69.125});

  ASSERT_TRUE(middle);
  const std::complex<double> mean = 0.25 * std::complex<double>{field[0] + field[1] + field[3] + field[4]};
  EXPECT_LT(std::abs(middle->front().value - mean), 1e-6);
}

TEST(TideGrid, AtACoastTakesTheNodesThatHaveWater) {
  std::mt19937_64 rng{1};
  TideGrid::Samples samples = random_tide(rng, small_grid(), {"M2"}).samples();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  samples.lines.front().elevation[0] = {nan, nan};
  const TideGrid model{samples};

  EXPECT_FALSE(model.constants(TideQuantity::elevation, {-54.0, 69.0}));
  const auto beside = model.constants(TideQuantity::elevation, {-53.75, 69.0});
  ASSERT_TRUE(beside);
  EXPECT_LT(std::abs(beside->front().value - std::complex<double>{samples.lines.front().elevation[1]}), 1e-6);
}

TEST(TideGrid, RefusesFieldsOfAnotherSize) {
  EXPECT_THROW(
      (TideGrid{{small_grid(), {{tide::Constituent{}, {}, TideGrid::Field(5), TideGrid::Field(5)}}}}),
      std::invalid_argument);
}

TEST(JoinedConstants, TakeEachLineFromTheFirstModelThatHasItAndInferTheMinorOnes) {
  std::mt19937_64 rng{2};
  const std::vector<TideGrid> models{random_tide(rng, small_grid(), {"S2", "K1", "O1", "Q1"}),
                                     random_tide(rng, small_grid(), {"M2", "S2", "N2"})};

  const auto constants = joined_constants(models, TideQuantity::east, {-53.5, 69.25});

  ASSERT_TRUE(constants);
  EXPECT_EQ(constants->size(), 6U + 16U);
  const auto s2 = std::ranges::find(*constants, tide::find_constituent("S2").value(),
                                    &tide::HarmonicConstant::constituent);
  EXPECT_LT(std::abs(s2->value - std::complex<double>{models[0].samples().lines[0].east[4]}), 1e-6);
}

TEST(JoinedConstants, AreMissingWhereOneModelEnds) {
  std::mt19937_64 rng{3};
  const HorizontalGrid smaller{geo::GeographicFrame{}, Axis{{-54.0, -53.5}}, Axis{{69.0, 69.25}}};
  const std::vector<TideGrid> models{random_tide(rng, small_grid(), {"M2"}),
                                     random_tide(rng, smaller, {"K1"})};

  EXPECT_TRUE(joined_constants(models, TideQuantity::east, {-53.6, 69.1}));
  EXPECT_FALSE(joined_constants(models, TideQuantity::east, {-53.1, 69.1}));
}

TEST(TidalCurrents, AreThePredictionAtEveryNodeAndTime) {
  for_each_seed(10, [](std::mt19937_64& rng) {
    const std::vector<TideGrid> models{
        random_tide(rng, small_grid(), {"M2", "S2", "N2", "K2", "K1", "O1", "P1", "Q1", "M4"})};
    const TidalCurrents tide{small_grid(), models, {start, core::Seconds{1200.0}, 500}};
    ASSERT_EQ(tide.known_nodes(), 6U);

    for (int trial = 0; trial < 50; ++trial) {
      const std::size_t ix = rng() % 3;
      const std::size_t iy = rng() % 2;
      const std::size_t i = rng() % 500;
      const auto place = small_grid().place(ix, iy);
      const core::UtcTime time = core::from_unix_seconds(tide.times_s()[i]);

      const auto fast = tide.at_node(ix, iy, i);

      ASSERT_TRUE(fast);
      EXPECT_NEAR(fast->east.value, tide::predict(*joined_constants(models, TideQuantity::east, place), time),
                  1e-3);
      EXPECT_NEAR(fast->north.value,
                  tide::predict(*joined_constants(models, TideQuantity::north, place), time), 1e-3);
    }
  });
}

CurrentGrid::Samples uniform_flow(double east_m_s, std::vector<double> times_s) {
  const std::size_t count = small_grid().size() * times_s.size();
  return {.grid = small_grid(),
          .depths_m = std::nullopt,
          .times_s = Axis{std::move(times_s)},
          .u = std::vector<float>(count, static_cast<float>(east_m_s)),
          .v = std::vector<float>(count, 0.0F)};
}

TEST(CurrentsWithATide, AreTheSumOfBoth) {
  for_each_seed(10, [](std::mt19937_64& rng) {
    const std::vector<TideGrid> models{random_tide(rng, small_grid(), {"M2", "K1"})};
    const double begin_s = core::unix_seconds(start);
    const CurrentGrid::Samples flow = uniform_flow(0.2, {begin_s, begin_s + 21'600.0, begin_s + 43'200.0});
    const auto tide = std::make_shared<const TidalCurrents>(
        small_grid(), models, TidalCurrents::Times{start, core::Seconds{600.0}, 73});
    const CurrentGrid both{flow, tide};
    ASSERT_EQ(both.times_s().size(), 73U);

    const geo::LonLat place{uniform(rng, -54.0, -53.0), uniform(rng, 69.0, 69.25)};
    const core::UtcTime time = start + core::Seconds{uniform(rng, 0.0, 43'000.0)};
    const auto current = both.at(place, core::Metres{50.0}, time);

    ASSERT_TRUE(current);
    // The error of linear interpolation between two steps: 2 x 0.7 m/s x (1.4e-4 x 600)^2 / 8.
    EXPECT_NEAR(current->east.value,
                0.2 + tide::predict(*joined_constants(models, TideQuantity::east, place), time), 2e-3);
    EXPECT_NEAR(current->north.value,
                tide::predict(*joined_constants(models, TideQuantity::north, place), time), 2e-3);
  });
}

TEST(CurrentsWithATide, HoldSteadyDataForEveryStepOfTheTide) {
  std::mt19937_64 rng{4};
  const std::vector<TideGrid> models{random_tide(rng, small_grid(), {"M2"})};
  const auto tide = std::make_shared<const TidalCurrents>(
      small_grid(), models, TidalCurrents::Times{start, core::Seconds{900.0}, 10});
  const CurrentGrid both{uniform_flow(0.2, {0.0}), tide};

  const auto column = both.column_at_node(1, 1, 7);

  ASSERT_TRUE(column);
  EXPECT_NEAR(column->mean({0.0}, {100.0}).east.value, 0.2 + tide->at_node(1, 1, 7)->east.value, 1e-6);
}

TEST(CurrentsWithATide, AreMissingWhereTheTideIs) {
  std::mt19937_64 rng{5};
  TideGrid::Samples samples = random_tide(rng, small_grid(), {"M2"}).samples();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  samples.lines.front().east[0] = {nan, nan};
  const auto tide = std::make_shared<const TidalCurrents>(
      small_grid(), std::vector{TideGrid{samples}}, TidalCurrents::Times{start, core::Seconds{900.0}, 10});
  const CurrentGrid both{uniform_flow(0.2, {0.0}), tide};

  EXPECT_EQ(tide->known_nodes(), 5U);
  EXPECT_FALSE(both.column_at_node(0, 0, 3));
  EXPECT_FALSE(both.at({-53.9, 69.05}, {0.0}, start));
  EXPECT_TRUE(both.at({-53.2, 69.05}, {0.0}, start));
}

TEST(CurrentsWithATide, RefuseATideThatOutlastsTheData) {
  std::mt19937_64 rng{6};
  const std::vector<TideGrid> models{random_tide(rng, small_grid(), {"M2"})};
  const auto tide = std::make_shared<const TidalCurrents>(
      small_grid(), models, TidalCurrents::Times{start, core::Seconds{900.0}, 10});
  const double begin_s = core::unix_seconds(start);

  EXPECT_THROW((CurrentGrid{uniform_flow(0.2, {begin_s, begin_s + 3600.0}), tide}), std::invalid_argument);
}

TEST(StraightStep, IsShorterTheStrongerAndFasterTheTide) {
  const auto model = [](const char* name, float speed_m_s) {
    const TideGrid::Field east(small_grid().size(), {speed_m_s, 0.0F});
    const TideGrid::Field north(small_grid().size());
    return std::vector{TideGrid{{small_grid(), {{tide::find_constituent(name).value(), {}, east, north}}}}};
  };

  // sqrt(8 x 0.005 / (1 x (1.4052e-4)^2)) = 1423 s.
  EXPECT_NEAR(straight_step(model("M2", 1.0F)).count(), 1423.0, 1.0);
  EXPECT_NEAR(straight_step(model("M4", 1.0F)).count(), 711.5, 1.0);
  EXPECT_EQ(straight_step(model("K1", 0.01F)).count(), 3600.0);
  EXPECT_EQ(straight_step(model("M8", 5.0F)).count(), 300.0);
}

}  // namespace
}  // namespace floeplan::ocean::tidal_currents_test
