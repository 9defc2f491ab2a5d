#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <string>

#include "engine/geo/geodesic.hpp"
#include "engine/messages/data_messages.hpp"
#include "engine/messages/sentence.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/publish/warnings.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::publish::drift_warnings_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr core::Seconds hour{3600.0};
const auto caution = HasSubstr("may come near the route");
const auto note = HasSubstr("too far away to come near the route");

/// Currents of 0.1 m/s northwards in the whole sea, known east of 55 W.
ocean::Environment northward_sea() {
  ocean::Environment environment;
  environment.currents = support::currents_from(
      [](geo::LonLat place, double) {
        return place.lon_deg < -55.0 ? geo::VelocityEn{{std::numeric_limits<double>::quiet_NaN()}, {}}
                                     : geo::VelocityEn{{0.0}, {0.1}};
      },
      60);
  return environment;
}

ocean::Iceberg berg(const std::string& name, geo::LonLat place, core::Seconds age) {
  ocean::Iceberg found = support::iceberg_at(place, 100.0);
  found.id = name;
  found.observed -= age;
  return found;
}

std::vector<std::string> told(const ocean::Environment& environment, const PlanRequest& request) {
  const auto plan = plan_route(environment, request, {}, {});
  EXPECT_TRUE(plan.has_value());
  return plan ? messages::sentences(plan->messages) : std::vector<std::string>{};
}

PlanRequest straight_request() {
  PlanRequest request = support::eastward_request();
  request.method = Method::direct;
  return request;
}

TEST(DriftWarnings, NameTheIcebergsThatMayComeNearTheRoute) {
  ocean::Environment environment = northward_sea();
  // 0.1 m/s for 20 h are 7.2 km; the largest keep-out distance is 5.55 km. When the vehicle passes, the first iceberg is
  // about 10 km from it.
  environment.icebergs = {berg("near", {-53.0, 69.04}, 20.0 * hour), berg("far", {-53.0, 69.6}, 20.0 * hour),
                          berg("followed", {-53.0, 69.12}, 0.0 * hour)};

  const auto messages = told(environment, straight_request());

  EXPECT_THAT(messages, Contains(AllOf(caution, HasSubstr("1 of 3 icebergs"), HasSubstr("(near)"))));
  EXPECT_THAT(messages, Contains(AllOf(note, HasSubstr("the drift of 1 of 3 icebergs"))));
}

TEST(DriftWarnings, TakeTheMeanSpeedOfAllWhereTheCurrentIsHardlyKnown) {
  ocean::Environment environment = northward_sea();
  const geo::LonLat unknown{-55.1, 69.0};
  PlanRequest request = straight_request();
  environment.icebergs = {berg("beyond", unknown, 0.0 * hour)};
  EXPECT_THAT(told(environment, request), Contains(AllOf(caution, HasSubstr("(beyond)"))))
      << "nothing tells how fast it is";

  environment.icebergs.push_back(berg("followed", {-52.0, 69.6}, 0.0 * hour));
  EXPECT_THAT(told(environment, request), AllOf(Contains(note), Not(Contains(caution))))
      << "at 0.1 m/s it is too far away";

  request.from = {-54.9, 69.0};
  request.to = {-54.0, 69.0};
  EXPECT_THAT(told(environment, request), Contains(AllOf(caution, HasSubstr("(beyond)"))));
}

TEST(DriftWarnings, AreLeftOutWhereTheDriftIsKnownOrNotAskedFor) {
  ocean::Environment environment = northward_sea();
  environment.icebergs = {berg("followed", {-53.0, 69.12}, 0.0 * hour)};
  EXPECT_THAT(told(environment, straight_request()), Not(Contains(HasSubstr("may come near the route"))));

  environment.icebergs = {berg("before", {-53.0, 69.12}, 20.0 * hour)};
  environment.steady_currents = true;
  EXPECT_THAT(told(environment, straight_request()), Not(Contains(HasSubstr("may come near the route"))));

  environment.steady_currents = false;
  PlanRequest standing = straight_request();
  standing.icebergs.drift = false;
  EXPECT_THAT(told(environment, standing), Not(Contains(HasSubstr("may come near the route"))));
}

/// Law: an iceberg whose current is unknown for longer is named, too.
TEST(DriftWarnings, NameNoFewerIcebergsTheLongerTheirDriftIsUnknown) {
  int named = 0;
  support::for_each_seed(12, [&](std::mt19937_64& rng) {
    ocean::Environment environment = northward_sea();
    const geo::LonLat place{support::uniform(rng, -53.4, -52.6), support::uniform(rng, 69.03, 69.1)};
    const double age_h = support::uniform(rng, 8.0, 30.0);
    const auto is_named = [&](double hours) {
      environment.icebergs = {berg("berg", place, hours * hour)};
      const auto messages = told(environment, straight_request());
      return std::ranges::any_of(messages, [](const std::string& text) {
        return text.find("may come near the route") != std::string::npos;
      });
    };
    const bool before = is_named(age_h);
    if (before) {
      EXPECT_TRUE(is_named(age_h + support::uniform(rng, 1.0, 30.0)));
    }
    named += before ? 1 : 0;
  });
  EXPECT_GT(named, 0);
  EXPECT_LT(named, 12);
}

TEST(DriftWarnings, StandInForWhatTheEnvironmentSaysOfAllIcebergs) {
  ocean::Environment environment;
  const std::string begin = "2027-01-15T08:00:00Z";
  environment.messages = {messages::data_message<"sightings-before-currents">(1, 1, begin),
                          messages::data_message<"icebergs-beyond-currents">(1, 1, "B-17")};
  EXPECT_THAT(messages_beside_drift(environment), IsEmpty());

  environment.messages.push_back(messages::data_message<"earlier-sightings-before-currents">(1, 1, begin));
  EXPECT_EQ(messages_beside_drift(environment).size(), 1U);
}

}  // namespace
}  // namespace floeplan::planning::publish::drift_warnings_test
