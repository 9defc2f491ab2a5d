#include "storage/ingest/cf_time.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "engine/core/utc_text.hpp"

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

TEST(CfTime, QuotesTheFilesOwnTextWhenItRefuses) {
  const auto decoder = CfTime::parse("fortnights since the flood", "standard");
  ASSERT_FALSE(decoder);
  EXPECT_THAT(decoder.error(), testing::HasSubstr("fortnights since the flood"));
}

TEST(CfTime, KnowsACalendarThatIsNotOurs) {
  EXPECT_TRUE(CfTime::parse("days since 1900-01-01", "noleap")->is_model_calendar());
  EXPECT_FALSE(CfTime::parse("days since 1900-01-01", "julian")->is_model_calendar());
  EXPECT_TRUE(CfTime::parse("days since 1900-01-01", "julian")->is_julian());
}

}  // namespace
}  // namespace floeplan::ingest::cf_time_test
