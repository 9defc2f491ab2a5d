#include "storage/ingest/notation/stated_period.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "engine/core/utc_text.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::stated_period_test {
namespace {

std::string span_of(std::string_view text) {
  const auto period = stated_period(text);
  return period ? core::iso8601(period->first) + "/" + core::iso8601(period->last) : "none";
}

TEST(StatedPeriod, OfADayAMonthOrAYearIsTheWholeOfIt) {
  EXPECT_EQ(span_of("2026-05-31"), "2026-05-31T00:00:00Z/2026-06-01T00:00:00Z");
  EXPECT_EQ(span_of("2026-06"), "2026-06-01T00:00:00Z/2026-07-01T00:00:00Z");
  EXPECT_EQ(span_of("2026-12"), "2026-12-01T00:00:00Z/2027-01-01T00:00:00Z");
  EXPECT_EQ(span_of("2028-02"), "2028-02-01T00:00:00Z/2028-03-01T00:00:00Z");
  EXPECT_EQ(span_of("2026"), "2026-01-01T00:00:00Z/2027-01-01T00:00:00Z");
}

TEST(StatedPeriod, IsReadAsGdalSpellsIt) {
  EXPECT_EQ(span_of("2026/05/31"), span_of("2026-05-31"));
  EXPECT_EQ(span_of("2026/05/31 00:00:00"), span_of("2026-05-31"));
  EXPECT_EQ(span_of("2026/05/31 06:30:00+00"), "2026-05-31T06:30:00Z/2026-05-31T06:30:00Z");
  EXPECT_EQ(span_of("2026/05/31 06:30:00-0330"), "2026-05-31T10:00:00Z/2026-05-31T10:00:00Z");
}

TEST(StatedPeriod, IsNoneWhereTheTextIsNoDateOrLacksItsZone) {
  for (const char* const text :
       {"", "tomorrow", "2026-05-31T06:00:00", "2026/05/31 06:00:00", "2026-13", "2026-02-30", "26-05-31",
        "31/05/2026", "05/31/2026", "2026-5", "20261301", "202", "20260", "2026-05-31Z "})
    EXPECT_EQ(span_of(text), "none") << text;
}

std::string interval_of(std::string_view text) {
  const auto interval = stated_interval(text);
  const auto words = [](const auto& moment) { return moment ? core::iso8601(*moment) : ".."; };
  return interval ? words(interval->first) + "/" + words(interval->last) : "none";
}

TEST(StatedInterval, IsBetweenTwoTextsOrTheSpanOfOne) {
  const std::string may = "2026-05-01T00:00:00Z/2026-06-01T00:00:00Z";
  for (const char* const text :
       {"2026-05", "2026-05-01/2026-05-31", "2026-05-01 to 2026-05-31", "20260501/20260531",
        "2026-05-01 - 2026-05-31", "2026-05-01 until 2026-05-31"})
    EXPECT_EQ(interval_of(text), may) << text;
  EXPECT_EQ(interval_of("2026-05-01/.."), "2026-05-01T00:00:00Z/..");
  EXPECT_EQ(interval_of("/2026-05-31"), "../2026-06-01T00:00:00Z");
  for (const char* const text : {"", "/", "..", "May", "2026-05-01/soon", "1 to 2"})
    EXPECT_EQ(interval_of(text), "none") << text;
}

TEST(StatedPeriod, IsFoundAmongTheWordsOfFreeText) {
  for (const char* const text :
       {"closed from 1 May 2026 on", "until 31.5.2026.", "<b>valid</b> 2026-05-01T06:00:00Z",
        "May 12: survey", "from 2026/05/31, daily", "ends 20260531"})
    EXPECT_EQ(mentions_date(text), true) << text;
  for (const char* const text : {"", "Act of 1998", "Marine park 2015", "69.20 -52.50", "call +45-12-34-56",
                                 "vessels may pass", "10/20 nets", "depth 12.5-20.5 m", "version 1.2.3"})
    EXPECT_EQ(mentions_date(text), false) << text;
}

TEST(StatedPeriod, IsToldFromOtherTextsByItsLook) {
  for (const char* const text :
       {"2026-05-01", "20260501", "31.5.2026", "5/31/26", "1 May 2026", "May 1, 2026", "2026-05",
        "1777593600000", "2026-05-01T06:00", "2026-05-01/2026-05-31", "01-JUN-2026"})
    EXPECT_TRUE(could_be_date(text)) << text;
  for (const char* const text :
       {"", "5", "2026", "69.2", "-52.525", "99999999", "Somewhere 2026", "SOR/2005-293", "MPA 12",
        "12345678901", "0.123456789", "Marine Reserve 2005"})
    EXPECT_FALSE(could_be_date(text)) << text;
}

/// A coarser text of the same moment spans no less.
TEST(StatedPeriod, HoldsEveryMomentThatItNames) {
  support::for_each_seed(500, [](std::mt19937_64& rng) {
    const core::UtcTime time = core::from_unix_seconds(std::floor(support::uniform(rng, 0.0, 4.0e9)));
    const std::string iso = core::iso8601(time);
    for (const std::size_t length : {4U, 7U, 10U, 20U}) {
      const auto period = stated_period(iso.substr(0, length));
      ASSERT_TRUE(period.has_value()) << iso.substr(0, length);
      EXPECT_LE(period->first, time);
      EXPECT_GE(period->last, time);
      EXPECT_TRUE(length == 20U || period->last - period->first >= core::Seconds{86'400.0});
    }
  });
}

}  // namespace
}  // namespace floeplan::ingest::stated_period_test
