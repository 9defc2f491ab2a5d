#include "engine/simulation/logs/logged_positions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "engine/geo/geodesic.hpp"
#include "engine/mission/document/packed_degrees.hpp"
#include "tests/support/property.hpp"

namespace floeplan::simulation::logged_positions_test {
namespace {

using testing::HasSubstr;

std::string text_of(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.8f", value);
  return text;
}

std::string angle(double degrees, bool decimal) {
  const double whole = std::floor(std::abs(degrees));
  const double packed = std::copysign(100.0 * whole + 60.0 * (std::abs(degrees) - whole), degrees);
  return text_of(decimal ? degrees : packed);
}

/// The notation in which a converter writes positions, and the other columns that it writes.
struct Writing {
  bool decimal{};
  std::string lat_unit{"lat"};
  std::string lon_unit{"lon"};
  bool local_metres{};
  bool speed{};
};

/// A straight way of rows a minute apart, at 0.3 m/s.
struct Way {
  std::vector<geo::LonLat> places;
  std::string log;
};

Way way_from(geo::LonLat start, double bearing_rad, const Writing& writing, int rows = 200) {
  constexpr double step_m = 18.0;
  constexpr double metres_of_degree = 111'195.0;  // of the mean sphere
  Way way;
  way.log = "m_present_time,m_lat,m_lon,m_gps_lat,m_gps_lon,m_x_lmc,m_y_lmc,m_speed\ntimestamp," +
            writing.lat_unit + "," + writing.lon_unit + "," + writing.lat_unit + "," + writing.lon_unit +
            ",m,m,m/s\n";
  for (int i = 0; i < rows; ++i) {
    const double north_m = i * step_m * std::cos(bearing_rad);
    const double east_m = i * step_m * std::sin(bearing_rad);
    const double lat = start.lat_deg + north_m / metres_of_degree;
    const geo::LonLat place{
        geo::wrap_longitude(start.lon_deg +
                            east_m / (metres_of_degree * std::cos(core::degrees_to_radians(start.lat_deg)))),
        lat};
    way.places.push_back(place);
    const std::string both =
        angle(place.lat_deg, writing.decimal) + "," + angle(place.lon_deg, writing.decimal);
    const bool fixed = i % 50 == 0;
    way.log += std::to_string(1'700'000'000 + 60 * i) + "," + both + "," +
               (fixed ? both : "69696969,69696969") + "," +
               (writing.local_metres ? text_of(east_m) + "," + text_of(north_m) : ",") + "," +
               (writing.speed ? "0.3" : "") + "\n";
  }
  return way;
}

/// Expects every place unchanged after the notation of the log was found.
void expect_places(const LogTable& log, const Way& way) {
  for (std::size_t row = 0; row < way.places.size(); ++row) {
    const auto place = mission::unpack_place(log["m_lon"][row].value(), log["m_lat"][row].value());
    ASSERT_TRUE(place.has_value());
    ASSERT_LT(geo::geodesic_between(*place, way.places[row]).length.value, 0.01) << row;
    const auto fix = mission::unpack_place(log["m_gps_lon"][row].value_or(69696969.0),
                                           log["m_gps_lat"][row].value_or(69696969.0));
    ASSERT_EQ(fix.has_value(), row % 50 == 0) << row;
    if (fix) {
      ASSERT_LT(geo::geodesic_between(*fix, way.places[row]).length.value, 0.01) << row;
    }
  }
}

/// Whether numbers of a place can stand in either notation.
bool could_be_both(geo::LonLat place, bool decimal) {
  return decimal ? std::abs(place.lat_deg) < 61.0 && std::abs(place.lon_deg) < 161.0
                 : std::abs(place.lat_deg) < 1.0 && std::abs(place.lon_deg) < 2.7;
}

TEST(LoggedPositions, AreNeverPlacedElsewhere) {
  int refused = 0;
  support::for_each_seed(300, [&](std::mt19937_64& rng) {
    const bool near_the_equator = support::uniform_int(rng, 0, 2) == 0;
    const double most = near_the_equator ? 2.5 : 85.0;
    const geo::LonLat start{
        support::uniform(rng, near_the_equator ? -most : -180.0, near_the_equator ? most : 180.0),
        support::uniform(rng, -most, most)};
    const Writing writing{.decimal = support::uniform_int(rng, 0, 1) == 0,
                          .lat_unit = "lat",
                          .lon_unit = "lon",
                          .local_metres = support::uniform_int(rng, 0, 1) == 0,
                          .speed = support::uniform_int(rng, 0, 1) == 0};
    const Way way = way_from(start, support::uniform(rng, 0.0, 6.28), writing);
    auto log = LogTable::read(way.log);
    ASSERT_TRUE(log.has_value());

    const auto settled = settle_positions(*log);

    SCOPED_TRACE(way.log.substr(0, 300));
    if (!settled) {
      ++refused;
      EXPECT_TRUE(could_be_both(start, writing.decimal));
      EXPECT_FALSE(writing.local_metres || writing.speed);
      return;
    }
    EXPECT_EQ(settled->has_value(), writing.decimal) << "who reads decimal degrees tells it";
    expect_places(*log, way);
  });
  EXPECT_GT(refused, 0) << "the law should meet logs that nothing decides";
}

TEST(LoggedPositions, AreReadByTheirUnitWhereItSaysDegrees) {
  for (const char* const unit : {"deg", "degrees", "Degree", "degrees_north", "decimal_degrees"}) {
    const Way way = way_from({7.4, 54.3}, 1.0, {.decimal = true, .lat_unit = unit, .lon_unit = unit}, 4);
    auto log = LogTable::read(way.log);
    const auto settled = settle_positions(*log);
    ASSERT_TRUE(settled.has_value()) << unit;
    EXPECT_FALSE(settled->has_value()) << unit;
    expect_places(*log, way);
  }
  const Way packed = way_from({0.4, 0.3}, 1.0, {.lat_unit = "ddmm.mmmm", .lon_unit = "ddmm.mmmm"}, 4);
  auto log = LogTable::read(packed.log);
  ASSERT_TRUE(settle_positions(*log).has_value());
  expect_places(*log, packed);
}

std::string refusal_of(const std::string& text) {
  auto log = LogTable::read(text);
  const auto settled = settle_positions(*log);
  return settled ? "none" : settled.error().field + " " + settled.error().rule;
}

TEST(LoggedPositions, ThatContradictTheirUnitOrEachOtherAreRefused) {
  EXPECT_THAT(refusal_of("m_present_time,m_lat,m_lon\ntimestamp,deg,deg\n1,5418.9,724.6\n"),
              HasSubstr("but hold 5418.9, which is in degrees and minutes; correct the unit"));
  EXPECT_THAT(refusal_of("m_present_time,m_lat,m_lon\ntimestamp,ddmm,ddmm\n1,69.2,-52.5\n"),
              HasSubstr("but hold 69.2, which is in decimal degrees"));
  EXPECT_THAT(refusal_of("m_present_time,m_lat,m_lon\ntimestamp,lat,lon\n1,69.2,-52.5\n2,6912.0,-5231.0\n"),
              HasSubstr("hold both degrees and minutes"));
  EXPECT_THAT(refusal_of("m_present_time,m_lat,m_lon\ntimestamp,deg,ddmm\n1,54.3,7.4\n"),
              HasSubstr("their notations differ"));
}

TEST(LoggedPositions, ThatNothingTellsAreRefusedWithBothPlacesAndWhatToDo) {
  const std::string refusal = refusal_of("m_present_time,m_lat,m_lon\ntimestamp,lat,lon\n1,54.3,7.5\n");
  EXPECT_THAT(refusal, HasSubstr("/m_lat and m_lon may be"));
  EXPECT_THAT(refusal, HasSubstr("0.905 N 0.125 E or 54.3 N 7.5 E"));
  EXPECT_THAT(refusal, HasSubstr("Write the unit ddmm or deg"));
}

/// A program may have converted the fixes alone.
TEST(LoggedPositions, OfTwoNotationsInOneLogAreReadBesideEachOther) {
  auto log = LogTable::read(
      "m_present_time,m_lat,m_lon,m_gps_lat,m_gps_lon\ntimestamp,lat,lon,lat,lon\n"
      "1,5418.9,724.6,54.315,7.41\n2,5418.9,724.6,54.315,7.41\n");
  const auto settled = settle_positions(*log);

  ASSERT_TRUE(settled.has_value());
  EXPECT_THAT(settled->value(), HasSubstr("(m_gps_lat, m_gps_lon) were read as decimal degrees"));
  EXPECT_NEAR((*log)["m_gps_lat"][0].value(), 5418.9, 1e-9);
  EXPECT_NEAR((*log)["m_lat"][0].value(), 5418.9, 1e-9);
}

TEST(LoggedPositions, NearTheEquatorAreToldByTheirZone) {
  auto log = LogTable::read(
      "m_present_time,m_lat,m_lon,x_lmc_utm_zone_digit\ntimestamp,lat,lon,byte\n1,30.0,50.0,31\n2,30.0,50.0,"
      "31\n");
  const auto settled = settle_positions(*log);
  ASSERT_TRUE(settled.has_value());
  EXPECT_FALSE(settled->has_value());
  EXPECT_EQ((*log)["m_lat"][0], 30.0);
}

}  // namespace
}  // namespace floeplan::simulation::logged_positions_test
