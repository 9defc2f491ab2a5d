#include "storage/ingest/notation/cf_time.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <tuple>

#include "engine/core/utc_text.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::cf_time_test {
namespace {

struct Decoding {
  std::string units;
  std::string calendar;
  double value;
  std::string expected;  // ISO 8601; empty: refused
};

std::string decoded(const Decoding& row) {
  const auto decoder = CfTime::parse(row.units, row.calendar);
  if (!decoder) return "";
  const auto time = decoder->at(row.value);
  return time ? core::iso8601(*time) : "";
}

class CfTimeDecodes : public testing::TestWithParam<Decoding> {};

TEST_P(CfTimeDecodes, AsTheConventionsSay) {
  EXPECT_EQ(decoded(GetParam()), GetParam().expected) << GetParam().units;
}

// Expected times obtained with cftime 1.6.
INSTANTIATE_TEST_SUITE_P(
    RealCalendars, CfTimeDecodes,
    testing::Values(
        Decoding{"hours since 1950-01-01 0:0:0", "standard", 613752.5, "2020-01-07T00:30:00Z"},
        Decoding{"days since 1950-01-01 00:00:00", "gregorian", 25255.0, "2019-02-23T00:00:00Z"},
        Decoding{"hours since 2023-02-25 12:00:00", "proleptic_gregorian", 120.0, "2023-03-02T12:00:00Z"},
        Decoding{"hours since 2021-05-04T12:00:00+00:00", "", 6.0, "2021-05-04T18:00:00Z"},
        Decoding{"seconds since 1970-1-1", "", 1.0e9, "2001-09-09T01:46:40Z"},
        Decoding{"days since 2000-12-31", "STANDARD", 1.0, "2001-01-01T00:00:00Z"},
        Decoding{"days since 1900-12-31 00:00:00", "", 38716.5, "2006-12-31T12:00:00Z"},
        Decoding{"minutes since 2000-01-01 00:00:00.9Z", "", 1.0, "2000-01-01T00:01:01Z"},
        Decoding{"hours since 2000-01-01 06:00 +05:30", "", 0.0, "2000-01-01T00:30:00Z"},
        Decoding{"hours since 2000-01-01 00:00:00 -3", "", 0.0, "2000-01-01T03:00:00Z"},
        Decoding{"seconds since 2000-01-01 00:00:00 UTC", "", 90.0, "2000-01-01T00:01:30Z"},
        Decoding{"Days Since 0001-01-01 00:00:00", "proleptic_gregorian", 737790.0, "2021-01-01T00:00:00Z"},
        Decoding{"days since 0001-01-01 00:00:00", "standard", 737792.0, "2021-01-01T00:00:00Z"},
        Decoding{"days since 0000-01-01", "proleptic_gregorian", 738156.0, "2021-01-01T00:00:00Z"},
        Decoding{"days since 1582-10-04", "standard", 160000.0, "2020-11-06T00:00:00Z"},
        Decoding{"weeks since 2000-01-01", "", 2.0, "2000-01-15T00:00:00Z"}));

INSTANTIATE_TEST_SUITE_P(
    ModelCalendars, CfTimeDecodes,
    testing::Values(Decoding{"days since 1900-01-01", "NOLEAP", 18250.5, "1950-01-01T12:00:00Z"},
                    Decoding{"days since 2000-01-01", "365_day", 59.0, "2000-03-01T00:00:00Z"},
                    Decoding{"days since 2001-01-01", "366_day", 60.0, "2001-03-01T00:00:00Z"},
                    Decoding{"days since 2001-01-01", "all_leap", 59.0, ""},
                    Decoding{"days since 1990-01-01", "julian", 0.0, "1990-01-01T00:00:00Z"},
                    Decoding{"days since 1990-01-01", "julian", 10957.25, "2020-01-01T06:00:00Z"},
                    Decoding{"days since 0001-01-01", "julian", 737439.0, "2020-01-01T00:00:00Z"},
                    Decoding{"days since 1900-02-28", "julian", 1.0, ""},
                    Decoding{"days since 1900-02-28", "julian", 2.0, "1900-03-01T00:00:00Z"},
                    Decoding{"days since 2000-01-01", "360_day", 360.0, "2001-01-01T00:00:00Z"},
                    Decoding{"days since 2000-01-01", "360_day", 59.0, ""}));

// The Julian Day of 2000-01-01T12:00:00Z is 2451545, that of 1970-01-01T00:00:00Z 2440587.5 (Meeus, table 7.A).
INSTANTIATE_TEST_SUITE_P(
    JulianDays, CfTimeDecodes,
    testing::Values(
        Decoding{"days since -4713-01-01 12:00:00", "", 2451545.0, "2000-01-01T12:00:00Z"},
        Decoding{"days since -4713-01-01", "standard", 2451545.5, "2000-01-01T12:00:00Z"},
        Decoding{"days since -4713-1-1 12:00:00", "gregorian", 2440587.5, "1970-01-01T00:00:00Z"},
        Decoding{"hours since -4713-01-01T12:00:00Z", "julian", 58837080.0, "2000-01-01T12:00:00Z"},
        Decoding{"days since -4713-11-24 12:00:00", "proleptic_gregorian", 2451545.0, "2000-01-01T12:00:00Z"},
        Decoding{"days since -4714-11-24 12:00:00", "proleptic_gregorian", 2451545.0, "2000-01-01T12:00:00Z"},
        Decoding{"days since -0001-12-31", "standard", 719165.0, "1970-01-01T00:00:00Z"},
        Decoding{"days since 1858-11-17", "standard", 40587.0, "1970-01-01T00:00:00Z"}));

INSTANTIATE_TEST_SUITE_P(
    OfDoubtfulYears, CfTimeDecodes,
    testing::Values(Decoding{"days since 0000-01-01", "", 737791.0, ""},
                    Decoding{"days since 0000-01-01", "julian", 737791.0, ""},
                    Decoding{"days since -4713-01-01", "proleptic_gregorian", 2451545.0, ""},
                    Decoding{"days since -0001-01-01", "proleptic_gregorian", 737791.0, ""},
                    Decoding{"days since 1582-10-05", "standard", 160000.0, ""},
                    Decoding{"days since 1582-10-14", "gregorian", 160000.0, ""}));

INSTANTIATE_TEST_SUITE_P(
    Refused, CfTimeDecodes,
    testing::Values(Decoding{"seconds", "", 0.0, ""}, Decoding{"", "", 0.0, ""},
                    Decoding{"months since 2000-01-01", "", 1.0, ""},
                    Decoding{"days since yesterday", "", 1.0, ""},
                    Decoding{"days since 2000-02-30", "", 1.0, ""},
                    Decoding{"days since 2000-13-01", "", 1.0, ""},
                    Decoding{"days since 2000-01-01 25:00", "", 1.0, ""},
                    Decoding{"days since 2000-01-01 12:00 CET", "", 1.0, ""},
                    Decoding{"days since 2000-01-01", "martian", 1.0, ""},
                    Decoding{"days since 2000-01-01", "", 1e20, ""},
                    Decoding{"days since 2000-01-01", "", std::numeric_limits<double>::quiet_NaN(), ""},
                    Decoding{"seconds since 0000-01-01 00:00:00", "gregorian", 0.0, ""}));

/// Days from 1 January 4713 BC to a date of a calendar that history used, by counting its years and months; years
/// before Christ are negative, and none is 0.
int days_since_4713_bc(int year, int month, int day) {
  const auto counted = [](int named) { return named < 0 ? named + 1 : named; };
  const bool by_gregory = std::tuple{year, month, day} >= std::tuple{1582, 10, 15};
  const auto is_leap = [](int of, bool gregorian) {
    return of % 4 == 0 && (!gregorian || of % 100 != 0 || of % 400 == 0);
  };
  int days = 0;
  for (int y = -4712; y < counted(year); ++y) days += is_leap(y, by_gregory && y > 1582) ? 366 : 365;
  constexpr std::array lengths{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  for (int m = 1; m < month; ++m)
    days += lengths[static_cast<std::size_t>(m - 1)] + (m == 2 && is_leap(counted(year), by_gregory) ? 1 : 0);
  return days + day - 1 - (by_gregory ? 10 : 0);
}

TEST(CfTime, OfTheStandardCalendarIsADayCountFromWhicheverDate) {
  support::for_each_seed(2000, [](std::mt19937_64& rng) {
    const int year = support::uniform_int(rng, -4713, 2100);
    const int month = support::uniform_int(rng, 1, 12);
    const int day = support::uniform_int(rng, 1, 28);
    const bool left_out = year == 1582 && month == 10 && day > 4 && day < 15;
    if (year == 0 || left_out) return;
    std::array<char, 40> units{};
    std::snprintf(units.data(), units.size(), "days since %s%04d-%02d-%02d 06:00:00", year < 0 ? "-" : "",
                  std::abs(year), month, day);
    // A day of the years 1800 to 2200; 1970-01-01 is the Julian Day 2440587.5.
    const int target = support::uniform_int(rng, 2378497, 2524593);
    const double expected_s = (target - 2440588) * 86400.0;

    const auto decoder = CfTime::parse(units.data(), year < 1 && year % 2 == 0 ? "julian" : "standard");
    ASSERT_TRUE(decoder) << reason_of(decoder.error());
    const auto time = decoder->at(target - days_since_4713_bc(year, month, day) - 0.25);

    ASSERT_TRUE(time) << units.data() << reason_of(time.error());
    EXPECT_NEAR(core::unix_seconds(*time), expected_s, 1e-3) << units.data();
  });
}

TEST(CfTime, QuotesTheFilesOwnTextWhenItRefuses) {
  const auto decoder = CfTime::parse("fortnights since the flood", "standard");
  ASSERT_FALSE(decoder);
  EXPECT_THAT(reason_of(decoder.error()), testing::HasSubstr("fortnights since the flood"));
}

TEST(CfTime, KnowsACalendarThatIsNotOurs) {
  EXPECT_TRUE(CfTime::parse("days since 1900-01-01", "noleap")->is_model_calendar());
  EXPECT_FALSE(CfTime::parse("days since 1900-01-01", "julian")->is_model_calendar());
  EXPECT_TRUE(CfTime::parse("days since 1900-01-01", "julian")->is_julian());
  EXPECT_FALSE(CfTime::parse("days since -4713-01-01 12:00", "julian")->is_julian());
}

}  // namespace
}  // namespace floeplan::ingest::cf_time_test
