#include "engine/ocean/currents/vehicle_axes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace floeplan::ocean::vehicle_axes_test {
namespace {

constexpr geo::LonLat disko_bay{-52.5, 69.2};
constexpr core::UtcTime autumn_2026 = core::from_unix_seconds(1.795e9);

/// Axes after these rows, from the first on.
std::optional<VehicleAxes> axes_after(const std::vector<AxesRow>& rows) {
  LoggedAxes logged;
  for (const AxesRow& row : rows) EXPECT_EQ(logged.note(row), 0U);
  return logged.axes(0);
}

double variation_rad(const std::optional<VehicleAxes>& known) {
  return known ? known->axes.variation_west().value : std::nan("");
}

TEST(LoggedAxes, TakeTheMatrixBeforeTheVariationAndTheVariationBeforeTheModel) {
  AxesRow row{.time = autumn_2026, .fix = disko_bay};
  const auto by_model = axes_after({row});
  row.variation_rad = 0.46;
  const auto by_variation = axes_after({row});
  row.cosine = std::cos(0.48);
  row.sine = std::sin(0.48);
  const auto by_matrix = axes_after({row});

  ASSERT_TRUE(by_model && by_variation && by_matrix);
  EXPECT_EQ(by_model->source, VariationSource::magnetic_model);
  EXPECT_NEAR(core::radians_to_degrees(variation_rad(by_model)), 27.2, 0.1);
  EXPECT_EQ(by_variation->source, VariationSource::log_variation);
  EXPECT_EQ(variation_rad(by_variation), 0.46);
  EXPECT_EQ(by_matrix->source, VariationSource::log_axes);
  EXPECT_NEAR(variation_rad(by_matrix), 0.48, 1e-12);
}

TEST(LoggedAxes, PassOverWhatCanBeNoneOfItsSensor) {
  const auto known = axes_after({{.time = autumn_2026,
                                  .fix = geo::LonLat{0.0, 0.0},
                                  .cosine = 0.0,  // before the vehicle has set its axes
                                  .sine = 0.0,
                                  .variation_rad = 69'696'969.0,
                                  .utm_zone = 0.0},
                                 {.fix = disko_bay, .cosine = 0.5, .sine = 0.5, .utm_zone = 61.0},
                                 {.variation_rad = 0.475, .utm_zone = 22.5}});

  ASSERT_TRUE(known);
  EXPECT_EQ(known->source, VariationSource::log_variation);
  EXPECT_EQ(known->axes.utm_zone(), 22);
}

TEST(LoggedAxes, AreThoseOfTheMissionsStart) {
  const auto known = axes_after({{.time = autumn_2026, .place = geo::LonLat{3.0, 50.0}, .variation_rad = 0.0},
                                 {.fix = disko_bay, .variation_rad = 0.475},
                                 {.fix = geo::LonLat{-59.0, 70.0}, .variation_rad = 0.55}});

  ASSERT_TRUE(known);
  EXPECT_EQ(variation_rad(known), 0.475);
  EXPECT_EQ(known->axes.utm_zone(), 22);
}

TEST(LoggedAxes, AreUntoldWithoutAPlaceAndWithoutAVariationBeforeTheModel) {
  EXPECT_FALSE(axes_after({{.time = autumn_2026, .variation_rad = 0.475}}));
  EXPECT_FALSE(axes_after({{.time = core::from_unix_seconds(1.2e9), .fix = disko_bay}}));
  EXPECT_TRUE(axes_after({{.variation_rad = 0.475, .utm_zone = 22.0}}));
}

TEST(LoggedAxes, OfAVariationOfNothingTurnByTheGridAlone) {
  const auto known = axes_after({{.time = autumn_2026, .fix = disko_bay, .variation_rad = 0.0}});

  ASSERT_TRUE(known);
  EXPECT_EQ(known->source, VariationSource::log_variation);
  EXPECT_EQ(variation_rad(known), 0.0);
}

TEST(VehicleAxes, SayWhatTheyWereTurnedBy) {
  EXPECT_EQ(words_of({{22, {0.475}}, VariationSource::log_variation}),
            "UTM zone 22, magnetic variation 27.2 degrees west by the log's m_gps_mag_var");
  EXPECT_THAT(words_of({{31, {-0.1}}, VariationSource::magnetic_model}),
              testing::HasSubstr("5.7 degrees east by the World Magnetic Model"));
  for (const auto source :
       {VariationSource::log_axes, VariationSource::log_variation, VariationSource::magnetic_model})
    EXPECT_EQ(parse_variation_source(source_name(source)), source);
  EXPECT_FALSE(parse_variation_source("compass"));
}

}  // namespace
}  // namespace floeplan::ocean::vehicle_axes_test
