#include "engine/messages/kind.hpp"

#include <gmock/gmock.h>

namespace floeplan::messages::kind_test {
namespace {

inline constexpr auto kinds = std::to_array<Kind>({
    {.code = "slow-legs",
     .rank = Rank::caution,
     .text = "on {legs} {legs:leg|legs} of {vehicle} the speed falls to {least_m_s:.2f} m/s at {time}",
     .hint = "depart before {time}",
     .slots = {{{"legs", 2}, {"vehicle", "a glider"}, {"least_m_s", 0.1}, {"time", "2027-01-12T06:00:00Z"}}}},
    {.code = "far-and-late",
     .text = "{ice_km:distance} and {bed_m:distance} away, {late_h:duration} late of {limit_h:duration}",
     .slots = {{{"ice_km", 0.136}, {"bed_m", 8260.0}, {"late_h", 14.73}, {"limit_h", 30.0}}}},
    {.code = "at-waypoint", .text = "at waypoint {waypoint:label}", .slots = {{{"waypoint", 3}}}},
    {.code = "no-ice", .rank = Rank::note, .text = "there is no ice", .hint = "Ingest some"},
});

TEST(Message, CarriesTheValuesThatItsTextSpeaksOf) {
  const Message message = make_message<kinds, "slow-legs">(std::size_t{3}, "B-17", 0.126, core::UtcTime{});

  EXPECT_EQ(message.code, "slow-legs");
  EXPECT_EQ(message.rank, Rank::caution);
  EXPECT_EQ(message.place, std::nullopt);
  EXPECT_THAT(
      message.values,
      testing::ElementsAre(NamedValue{"legs", std::int64_t{3}}, NamedValue{"vehicle", "B-17"},
                           NamedValue{"least_m_s", 0.126}, NamedValue{"time", "1970-01-01T00:00:00Z"}));
  EXPECT_EQ(message.text, "on 3 legs of B-17 the speed falls to 0.13 m/s at 1970-01-01T00:00:00Z");
  EXPECT_EQ(message.hint, "depart before 1970-01-01T00:00:00Z");
}

TEST(Message, SaysOneInTheSingular) {
  const Message message = make_message<kinds, "slow-legs">(1, "B-17", 0.5, "noon");

  EXPECT_THAT(message.text, testing::StartsWith("on 1 leg of B-17"));
}

TEST(Message, SaysDistancesAndDurationsInOneForm) {
  const Message message = make_message<kinds, "far-and-late">(0.136, 8260.0, 14.73, 30.0);

  EXPECT_EQ(message.text, "136 m and 8.3 km away, 14 h 44 min late of 30 h");
}

TEST(Message, NamesWaypointsAsTheMap) {
  EXPECT_EQ((make_message<kinds, "at-waypoint">(0).text), "at waypoint S");
  EXPECT_EQ((make_message<kinds, "at-waypoint">(3).text), "at waypoint 3");
}

TEST(Message, TakesWordsForWhatTheyAre) {
  const Message message = make_message<kinds, "slow-legs">(1, "{legs} {", 0.5, "%s}");

  EXPECT_EQ(message.text, "on 1 leg of {legs} { the speed falls to 0.50 m/s at %s}");
}

TEST(Message, MayHaveAPlace) {
  const Message message = make_message<kinds, "no-ice">().at({-60.0, 69.0});

  EXPECT_EQ(message.place, (geo::LonLat{-60.0, 69.0}));
}

}  // namespace
}  // namespace floeplan::messages::kind_test
