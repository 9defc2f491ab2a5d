#include "engine/ocean/ice/ice_field.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tests/support/property.hpp"

namespace floeplan::ocean::ice_field_test {
namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();

/// Three by two nodes, two times a day apart; the concentration rises eastwards and with time.
IceField::Samples rising() {
  return {.grid = {geo::GeographicFrame{}, Axis{{-54.0, -53.0, -52.0}}, Axis{{69.0, 70.0}}},
          .times_s = Axis{{0.0, 86400.0}},
          .concentration = {0.0F, 0.2F, 0.4F, 0.0F, 0.2F, 0.4F, 0.5F, 0.7F, 0.9F, 0.5F, 0.7F, 0.9F},
          .thickness_m = {}};
}

core::UtcTime at_hour(double hour) { return core::from_unix_seconds(3600.0 * hour); }

TEST(IceField, IsBilinearInPlaceAndLinearInTime) {
  const IceField field{rising()};

  EXPECT_NEAR(field.at({-53.5, 69.5}, at_hour(0.0))->concentration, 0.1, 1e-7);
  EXPECT_NEAR(field.at({-53.5, 69.5}, at_hour(12.0))->concentration, 0.35, 1e-7);
  EXPECT_NEAR(field.at({-52.0, 70.0}, at_hour(24.0))->concentration, 0.9, 1e-7);
}

TEST(IceField, SaysNothingBeyondItsAreaAndItsPeriod) {
  const IceField field{rising()};

  EXPECT_FALSE(field.at({-54.5, 69.5}, at_hour(0.0)));
  EXPECT_FALSE(field.at({-53.5, 68.9}, at_hour(0.0)));
  EXPECT_FALSE(field.at({-53.5, 69.5}, at_hour(-0.1)));
  EXPECT_FALSE(field.at({-53.5, 69.5}, at_hour(24.1)));
}

TEST(IceField, SaysNothingBetweenStepsThatAreMoreThanAWeekApart) {
  IceField::Samples samples = rising();
  samples.times_s = Axis{{0.0, 20.0 * 86400.0}};
  const IceField field{samples};

  EXPECT_TRUE(field.at({-53.5, 69.5}, at_hour(0.0)));
  EXPECT_FALSE(field.at({-53.5, 69.5}, at_hour(24.0)));
  EXPECT_TRUE(field.at({-53.5, 69.5}, at_hour(480.0)));
}

TEST(IceField, SaysNothingWhereANodeThatCountsIsMissing) {
  IceField::Samples samples = rising();
  samples.concentration[1] = missing;  // 53 W 69 N at the first time

  const IceField field{samples};

  EXPECT_FALSE(field.at({-53.5, 69.5}, at_hour(0.0)));
  EXPECT_FALSE(field.at({-53.5, 69.5}, at_hour(6.0)));
  EXPECT_TRUE(field.at({-53.5, 70.0}, at_hour(0.0)));
  EXPECT_TRUE(field.at({-53.5, 69.5}, at_hour(24.0)));
}

TEST(IceField, GivesTheThicknessWhereItIsKnown) {
  IceField::Samples samples = rising();
  EXPECT_FALSE(IceField{samples}.at({-53.0, 69.0}, at_hour(0.0))->thickness);
  samples.thickness_m.assign(12, 1.5F);
  samples.thickness_m[0] = missing;

  const IceField field{samples};

  EXPECT_DOUBLE_EQ(field.at({-53.0, 69.0}, at_hour(0.0))->thickness->value, 1.5);
  const auto open_water = field.at({-54.0, 69.0}, at_hour(0.0));
  ASSERT_TRUE(open_water);
  EXPECT_FALSE(open_water->thickness);
}

TEST(IceField, AnswersInAPolarStereographicGrid) {
  const geo::PolarStereographicFrame frame{.north = true, .lat_ts_deg = 70.0, .lon_0_deg = -45.0};
  IceField::Samples samples{.grid = {frame, Axis{{-1e6, 0.0, 1e6}}, Axis{{-1e6, 0.0, 1e6}}},
                            .times_s = Axis{{0.0}},
                            .concentration = {0.0F, 0.0F, 0.0F, 0.5F, 0.5F, 0.5F, 1.0F, 1.0F, 1.0F},
                            .thickness_m = {}};

  const IceField field{samples};

  EXPECT_NEAR(field.at({-45.0, 90.0}, at_hour(0.0))->concentration, 0.5, 1e-6);
  const geo::LonLat below_the_pole = geo::FrameProjection{frame}.to_lon_lat({0.0, -500'000.0});
  EXPECT_NEAR(field.at(below_the_pole, at_hour(0.0))->concentration, 0.25, 1e-6);
  EXPECT_FALSE(field.at({135.0, 70.0}, at_hour(0.0)));
}

TEST(IceField, StaysBetweenTheExtremesOfItsNodes) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    IceField::Samples samples = rising();
    for (float& value : samples.concentration) value = static_cast<float>(support::uniform(rng, 0.2, 0.8));

    const auto state =
        IceField{samples}.at({support::uniform(rng, -54.0, -52.0), support::uniform(rng, 69.0, 70.0)},
                             at_hour(support::uniform(rng, 0.0, 24.0)));

    ASSERT_TRUE(state);
    EXPECT_GE(state->concentration, 0.2);
    EXPECT_LE(state->concentration, 0.8 + 1e-7);
  });
}

TEST(IceField, RefusesSizesThatDoNotAgree) {
  IceField::Samples samples = rising();
  samples.concentration.pop_back();
  EXPECT_THROW(IceField{samples}, std::invalid_argument);
  samples = rising();
  samples.thickness_m = {1.0F};
  EXPECT_THROW(IceField{samples}, std::invalid_argument);
  EXPECT_THROW((void)IceField{rising()}.at({missing, 69.0}, at_hour(0.0)), std::invalid_argument);
}

}  // namespace
}  // namespace floeplan::ocean::ice_field_test
