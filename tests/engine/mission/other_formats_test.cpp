#include <gmock/gmock.h>

#include <cstdint>
#include <sstream>

#include "engine/mission/reading/read_document.hpp"
#include "engine/mission/writing/nmea_route.hpp"
#include "engine/mission/writing/seaglider_files.hpp"
#include "tests/engine/mission/random_plan.hpp"

namespace floeplan::mission::other_formats_test {
namespace {

using support::plan_of;
using testing::HasSubstr;

TEST(NmeaRoute, HoldsEachWaypointByItsNameOnTheMapAndTheirOrder) {
  const MissionFile file = write_nmea_route(plan_of({{-53.5, 69.25}, {-0.25, -0.5}}), "p12ab-;\r\n$x");

  EXPECT_EQ(file.text,
            "$GPWPL,6915.0000,N,05330.0000,W,S*04\r\n"
            "$GPWPL,0030.0000,S,00015.0000,W,1*72\r\n"
            "$GPRTE,1,1,c,p12abx,S,1*5D\r\n");
}

TEST(NmeaRoute, HasSoundSentencesForAnyPlan) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    const auto places = support::random_places(rng, 2, 200);
    std::istringstream lines{write_nmea_route(plan_of(places), "p0123456789ab").text};
    std::vector<std::string> routed;
    for (std::string line; std::getline(lines, line);) {
      ASSERT_EQ(line.back(), '\r');
      ASSERT_LE(line.size() + 1, 82U);
      std::uint8_t sum = 0;
      for (std::size_t i = 1; i < line.find('*'); ++i) sum ^= static_cast<std::uint8_t>(line[i]);
      ASSERT_EQ(std::stoi(line.substr(line.find('*') + 1, 2), nullptr, 16), sum) << line;
      if (!line.starts_with("$GPRTE")) continue;
      std::istringstream fields{line.substr(0, line.find('*'))};
      constexpr int before_names = 5;  // GPRTE, how many, which, c, the route
      int field = 0;
      for (std::string name; std::getline(fields, name, ',');)
        if (field++ >= before_names) routed.push_back(name);
    }
    ASSERT_EQ(routed.size(), places.size());
    EXPECT_EQ(routed.front(), "S");
    EXPECT_EQ(routed.back(), std::to_string(places.size() - 1));
  });
}

TEST(SeagliderTargets, LeadEachToTheNextAndTheLastToItself) {
  const MissionFile file =
      write_targets(plan_of({{-53.5, 69.0}, {-53.25, 69.25}, {-52.5, 69.5}}), core::Metres{500.0},
                    {.plan_id = "p1", .plan_name = "x\nWP1 lat=1 lon=1"});

  EXPECT_EQ(file.name, "targets");
  EXPECT_THAT(file.text, HasSubstr("/ plan id p1\n"));
  EXPECT_THAT(file.text, HasSubstr("WP1 lat=6915.0000 lon=-5315.0000 radius=500 goto=WP2\n"
                                   "WP2 lat=6930.0000 lon=-5230.0000 radius=500 goto=WP2\n"));
}

TEST(SeagliderTargets, OfAnyPlanReadBackWithinATenthOfAMetre) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    const auto places = support::random_places(rng, 2, 40);
    const Document read =
        read_document("targets", write_targets(plan_of(places), core::Metres{500.0}, {}).text);

    ASSERT_EQ(read.verdict(), Verdict::ok);
    ASSERT_EQ(read.waypoints.size(), places.size() - 1);
    for (std::size_t i = 0; i < read.waypoints.size(); ++i)
      EXPECT_LT(geo::geodesic_between(places[i + 1], read.waypoints[i].place).length.value, 0.14);
  });
}

}  // namespace
}  // namespace floeplan::mission::other_formats_test
