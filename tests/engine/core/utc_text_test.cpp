#include "engine/core/utc_text.hpp"

#include <gtest/gtest.h>

#include "tests/support/property.hpp"

namespace floeplan::core::utc_text_test {
namespace {

std::optional<double> seconds_of(const char* text) {
  const auto time = parse_iso8601(text);
  return time ? std::optional{unix_seconds(*time)} : std::nullopt;
}

TEST(Iso8601, WritesWholeSecondsWithZ) {
  EXPECT_EQ(iso8601(from_unix_seconds(0.0)), "1970-01-01T00:00:00Z");
  EXPECT_EQ(iso8601(from_unix_seconds(1'795'154'400.0)), "2026-11-20T06:00:00Z");
  EXPECT_EQ(iso8601(from_unix_seconds(-1.0)), "1969-12-31T23:59:59Z");
}

TEST(Iso8601, RoundsToTheNearestSecondAcrossMidnight) {
  EXPECT_EQ(iso8601(from_unix_seconds(86'399.7)), "1970-01-02T00:00:00Z");
  EXPECT_EQ(iso8601(from_unix_seconds(86'399.4)), "1970-01-01T23:59:59Z");
}

TEST(Iso8601, ReadsDateTimeWithZone) {
  EXPECT_EQ(seconds_of("2026-11-20T06:00:00Z"), 1'795'154'400.0);
  EXPECT_EQ(seconds_of("2026-11-20 06:00Z"), 1'795'154'400.0);
  EXPECT_EQ(seconds_of("2026-11-20t03:30:00-02:30"), 1'795'154'400.0);
  EXPECT_EQ(seconds_of("2026-11-20T07:00:00+0100"), 1'795'154'400.0);
  EXPECT_EQ(seconds_of("2026-11-20T06:00:00.25Z"), 1'795'154'400.25);
}

TEST(Iso8601, ReadsADateAloneAsItsMidnight) { EXPECT_EQ(seconds_of("1970-01-02"), 86'400.0); }

TEST(Iso8601, KnowsLeapDays) {
  EXPECT_EQ(iso8601(parse_iso8601("2024-02-29T12:00:00Z").value()), "2024-02-29T12:00:00Z");
  EXPECT_FALSE(parse_iso8601("2026-02-29").has_value());
  EXPECT_FALSE(parse_iso8601("2100-02-29").has_value());
}

TEST(Iso8601, RefusesWhatIsNoUnambiguousInstant) {
  for (const char* text : {"",
                           "2026",
                           "2026-11",
                           "2026-13-01",
                           "2026-02-30",
                           "2026-00-10",
                           "2026-11-20T",
                           "2026-11-20T06:00:00",
                           "2026-11-20T06Z",
                           "2026-11-20T24:00:00Z",
                           "2026-11-20T06:60:00Z",
                           "2026-11-20T23:59:60Z",
                           "2026-11-20T06:00:5Z",
                           "2026-11-20T06:00:00.Z",
                           "2026-11-20T06:00:00Zx",
                           "2026-11-20T06:00:00+1",
                           "2026-11-20T06:00:00+24:00",
                           " 2026-11-20",
                           "20261120",
                           "+026-11-20",
                           "2026-11-20T06:00:1e1Z",
                           "now"}) {
    EXPECT_FALSE(parse_iso8601(text).has_value()) << text;
  }
}

TEST(Iso8601, ReadsBackWhatItWrote) {
  support::for_each_seed(2000, [](std::mt19937_64& rng) {
    const auto whole =
        static_cast<double>(std::uniform_int_distribution<long long>{-2'000'000'000, 9'000'000'000}(rng));

    EXPECT_EQ(seconds_of(iso8601(from_unix_seconds(whole)).c_str()), whole);
  });
}

TEST(Iso8601, WritesLaterInstantsAsLaterText) {
  support::for_each_seed(500, [](std::mt19937_64& rng) {
    const double early = support::uniform(rng, 0.0, 4e9);
    const double late = early + support::uniform(rng, 0.0, 1e6);

    EXPECT_LE(iso8601(from_unix_seconds(early)), iso8601(from_unix_seconds(late)));
  });
}

TEST(Iso8601, NeverFailsBadlyOnRandomText) {
  constexpr std::string_view letters = "0123456789-:TZ+. PDHMSW";
  support::for_each_seed(2000, [&](std::mt19937_64& rng) {
    std::string text = "2026-11-20T06:00:00Z";
    for (int edits = support::uniform_int(rng, 1, 4); edits > 0; --edits) {
      const auto place =
          static_cast<std::size_t>(support::uniform_int(rng, 0, static_cast<int>(text.size()) - 1));
      text[place] = letters[static_cast<std::size_t>(
          support::uniform_int(rng, 0, static_cast<int>(letters.size()) - 1))];
    }
    const auto time = parse_iso8601(text);
    if (time) {
      EXPECT_EQ(parse_iso8601(iso8601(*time)).value(), std::chrono::round<std::chrono::seconds>(*time));
    }
  });
}

TEST(Iso8601Duration, AddsUpDaysAndTime) {
  EXPECT_EQ(parse_iso8601_duration("PT1H"), Seconds{3600.0});
  EXPECT_EQ(parse_iso8601_duration("P1DT30M"), Seconds{88'200.0});
  EXPECT_EQ(parse_iso8601_duration("PT90S"), Seconds{90.0});
  EXPECT_EQ(parse_iso8601_duration("P2W"), Seconds{1'209'600.0});
  EXPECT_EQ(parse_iso8601_duration("PT0.5S"), Seconds{0.5});
}

TEST(Iso8601Duration, RefusesMonthsDisorderAndEmptiness) {
  for (const char* text : {"", "P", "PT", "P1DT", "1H", "PT1", "P1M", "P1Y", "P1H", "PT1D", "PT1M1H",
                           "PT1H1H", "-PT1H", "PT-1H", "PT1Hx", "PT1.2.3S"}) {
    EXPECT_FALSE(parse_iso8601_duration(text).has_value()) << text;
  }
}

TEST(HoursMinutes, AreRoundedToWholeMinutes) {
  EXPECT_EQ(hours_minutes(Seconds{0.0}), "0 min");
  EXPECT_EQ(hours_minutes(Seconds{59.6 * 60.0}), "1 h 00 min");
  EXPECT_EQ(hours_minutes(Seconds{2.0 * 3600.0 + 40.0 * 60.0 + 29.0}), "2 h 40 min");
}

}  // namespace
}  // namespace floeplan::core::utc_text_test
