#include "engine/mission/writing/seaglider_files.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "engine/messages/sentence.hpp"
#include "engine/mission/document/document_text.hpp"
#include "engine/mission/reading/read_document.hpp"
#include "tests/engine/mission/random_plan.hpp"

namespace floeplan::mission::seaglider_files_test {
namespace {

using support::plan_of;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;

auto has(const std::string& code, Severity severity) {
  return Contains(AllOf(Field(&Message::code, code), Field(&Message::severity, severity)));
}

std::string codes(const Document& document) {
  std::string text;
  for (const Message& message : document.messages) text += message.code + " ";
  return text;
}

TEST(SeagliderTargets, AreFollowedFromTheFirstToTheLast) {
  const Document read = read_document(
      "targets.12",
      "/ Targets of sg123\r\nA lat=6915.5 lon=-5315.0 radius=2000 goto=C timeout=3 timeout-goto=B\r\n"
      "B goto=B radius=500.0 lon=-5230.00 lat=6930.00\r\nC lat=+6920. lon=-5300.0000 radius=1e3 goto=B\r\n");

  EXPECT_EQ(read.verdict(), Verdict::ok) << codes(read);
  EXPECT_EQ(read.kind, DocumentKind::targets);
  ASSERT_EQ(read.waypoints.size(), 3U);
  EXPECT_EQ(read.waypoints[1].line, 4);
  EXPECT_NEAR(read.waypoints[0].place.lat_deg, 69.0 + 15.5 / 60.0, 1e-12);
  EXPECT_NEAR(read.waypoints[2].place.lon_deg, -52.5, 1e-12);
}

TEST(SeagliderSet, IsNotWrittenForAPlanBelowIceOrIcebergs) {
  planning::Plan plan = plan_of({{-53.0, 69.0}, {-52.75, 69.0}});
  ASSERT_TRUE(write_seaglider_set(plan, {}).has_value());
  plan.surfacing.emplace();
  plan.surfacing->waypoints.resize(2);
  plan.surfacing->waypoints[1].leg_upper_turn = core::Metres{18.0};

  const auto set = write_seaglider_set(plan, {});

  ASSERT_FALSE(set.has_value());
  EXPECT_THAT(set.error(), Contains(Field(&core::Violation::field, "/format")));
}

TEST(SeagliderSet, NamesTheVehicleThatThePlanWasMadeFor) {
  planning::Plan plan = plan_of({{-53.0, 69.0}, {-52.75, 69.0}});
  plan.vehicle = "slocum-g3-200";

  const auto set = write_seaglider_set(plan, {});

  EXPECT_THAT(messages::sentences(set->messages), Contains(HasSubstr("for the vehicle slocum-g3-200")));
}

TEST(SeagliderSet, NamesTheShoalestWaterOnTheWay) {
  const planning::Plan plan = plan_of({{-53.0, 69.0}, {-52.75, 69.0}, {-52.5, 69.0}});
  SeagliderOptions options;  // dives to 200 m, margin 10 m
  options.shoals = {{}, Shoal{{300.0}, {-52.8, 69.0}, 1}, Shoal{{45.5}, {-52.6, 69.0}, 2}};

  const auto over_a_bank = write_seaglider_set(plan, options);
  options.shoals[2]->bed = core::Metres{210.0};
  const auto over_enough = write_seaglider_set(plan, options);

  ASSERT_TRUE(over_a_bank.has_value());
  EXPECT_THAT(
      messages::sentences(over_a_bank->messages),
      Contains(HasSubstr("$D_TGT is 200 m, but the sea is only 45 m deep at -52.6000, 69.0000, before "
                         "waypoint 2. The plan dives only to 35 m")));
  ASSERT_TRUE(over_enough.has_value());
  EXPECT_THAT(messages::sentences(over_enough->messages),
              testing::Not(Contains(HasSubstr("but the sea is"))));
}

TEST(SeagliderTargets, AreReadStrictly) {
  const std::string good = "A lat=6915.5 lon=-5315.0 radius=2000 goto=A\n";
  const auto code_of = [&](const std::string& text) { return codes(read_document("targets", text)); };

  EXPECT_THAT(code_of(""), HasSubstr("no_target"));
  EXPECT_THAT(code_of("A lat=6915.5 lon=-5315.0 goto=A\n"), HasSubstr("fields_missing"));
  EXPECT_THAT(code_of("A lat=6915.5 lon=-5315.0 radius=2000 goto=B\n"), HasSubstr("unknown_target"));
  EXPECT_THAT(code_of("A lat=6915.5 lon=-5315.0 radius=2000 goto=A fence-goto=B\n"),
              HasSubstr("unknown_target"));
  EXPECT_THAT(code_of("A lat = 6915.5 lon=-5315.0 radius=2000 goto=A\n"), HasSubstr("malformed_field"));
  EXPECT_THAT(code_of("A lat=6915,5 lon=-5315.0 radius=2000 goto=A\n"), HasSubstr("value_not_a_number"));
  EXPECT_THAT(code_of("A lat=-5315.0 lon=-18915.5 radius=2000 goto=A\n"), HasSubstr("out_of_range"));
  EXPECT_THAT(code_of("A lat=6915.5 lon=-5315.0 radius=0 goto=A\n"), HasSubstr("bad_radius"));
  EXPECT_THAT(code_of(good + good), HasSubstr("target_twice"));
  EXPECT_THAT(code_of("lat=6915.5 lon=-5315.0 radius=2000 goto=A\n"), HasSubstr("no_name"));
  EXPECT_THAT(code_of("\xC3\x84 lat=6915.5 lon=-5315.0 radius=2000 goto=\xC3\x84\n"), HasSubstr("not_ascii"));
  for (const char* bad : {"A lat=6915.5 lon=-5315.0 goto=A\n", "A goto=A\n", "A\n"})
    EXPECT_EQ(read_document("targets", bad).verdict(), Verdict::reject) << bad;

  EXPECT_THAT(read_document("targets", "A lat=69.25 lon=-53.25 radius=500 goto=A\n").messages,
              has("decimal_degrees", Severity::warning));
  EXPECT_THAT(read_document("targets", "A lat=6915 lon=-5315 radius=500 goto=A colour=3\n").messages,
              has("unknown_field", Severity::warning));
  EXPECT_THAT(read_document("targets", good + "H head=90 goto=A\n").messages,
              has("target_off_the_way", Severity::note));
  EXPECT_THAT(read_document("targets", "H head=90 goto=A\n" + good).messages,
              has("target_without_place", Severity::warning));
}

TEST(SeagliderScience, IsReadInBothForms) {
  const Document named = read_document(
      "science", "/ bands\n20 seconds=5 sensors=1110 gc=60\nloiter gc=300 sensors=1000 seconds=60\n");
  const Document columns = read_document("science", "20 5 1110 60\n200 10 1100 180\n");

  EXPECT_EQ(named.verdict(), Verdict::ok) << codes(named);
  EXPECT_EQ(columns.verdict(), Verdict::ok) << codes(columns);
  ASSERT_EQ(named.bands.size(), 2U);
  EXPECT_EQ(named.bands[0].sensors, "1110");
  EXPECT_FALSE(named.bands[1].depth.has_value());
  ASSERT_EQ(columns.bands.size(), 2U);
  EXPECT_EQ(columns.bands[1].guidance_seconds, 180.0);
  for (const char* bad :
       {"", "20 5 1110\n", "20 5 1110 60 1\n", "-5 5 1110 60\n", "20 0 1110 60\n", "20 5 1x10 60\n",
        "20 seconds=5 sensors=1110\n", "20 5 1110 60\n200 5 111 60\n", "deep 5 111 60\n"})
    EXPECT_EQ(read_document("science", bad).verdict(), Verdict::reject) << bad;
  EXPECT_EQ(read_document("science", "200 5 1110 60\n20 5 1110 60\n").verdict(), Verdict::warn);
}

TEST(SeagliderCmdfile, IsReadStrictly) {
  const Document read =
      read_document("cmdfile", "/ deeper\r\n$D_TGT,990\r\n$T_DIVE,330\r\n$T_MISSION,360\r\n$GO\r\n");
  EXPECT_EQ(read.verdict(), Verdict::ok) << codes(read);
  ASSERT_EQ(read.sensors.size(), 3U);
  EXPECT_EQ(read.sensors[0].name, "D_TGT");

  for (const char* bad : {"", "$D_TGT,100\n", "D_TGT,100\n$GO\n", "$D_TGT,deep\n$GO\n", "$D_TGT 100\n$GO\n",
                          "$D_TGT,2000\n$GO\n", "$T_DIVE,30.5\n$GO\n", "$T_DIVE,60\n$T_MISSION,60\n$GO\n",
                          "$D_TGT,1000\n$D_ABORT,990\n$GO\n", "$D_TGT,100\n$D_TGT,200\n$GO\n", "$GOO\n"})
    EXPECT_EQ(read_document("cmdfile", bad).verdict(), Verdict::reject) << bad;
  EXPECT_EQ(read_document("cmdfile", "$GO\n$D_TGT,100\n").verdict(), Verdict::warn);
  EXPECT_EQ(read_document("cmdfile", "$NEW_ONE,1\n$GO\n").verdict(), Verdict::ok);
}

TEST(SeagliderFiles, AreKnownByTheirContentToo) {
  EXPECT_EQ(read_document("", "/ c\nA lat=6915 lon=-5315 radius=500 goto=A\n").kind, DocumentKind::targets);
  EXPECT_EQ(read_document("", "20 seconds=5 sensors=1 gc=60\n").kind, DocumentKind::science);
  EXPECT_EQ(read_document("", "$GO\n").kind, DocumentKind::cmdfile);
  EXPECT_EQ(read_document("science.mi", "behavior: abend\n").kind, DocumentKind::mission);
}

TEST(SeagliderSet, IsTakenByTheStrictReaderForAnyPlan) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    SeagliderOptions options;
    options.vehicle = vehicle::known_profiles().front();
    options.vehicle.depth_rating = core::Metres{1000.0};
    options.vehicle.dive_depth = core::Metres{support::uniform(rng, 60.0, 1000.0)};
    options.bands = {*parse_science_band("20:5:1110:60"), *parse_science_band("loiter:60:1000:300")};
    options.origin = {.plan_id = "p1", .plan_name = "x\n$QUIT\n$D_TGT,1"};
    const auto set = write_seaglider_set(plan_of(support::random_places(rng, 2, 20)), options);

    ASSERT_TRUE(set.has_value());
    ASSERT_EQ(set->files.size(), 3U);
    for (const MissionFile& file : set->files) {
      const Document read = read_document(file.name, file.text);
      ASSERT_EQ(read.verdict(), Verdict::ok) << file.text << codes(read);
      EXPECT_EQ(write_document(read), file.text);
      if (read.kind != DocumentKind::cmdfile) continue;
      EXPECT_EQ(read.sensors.at(0).value, std::ceil(options.vehicle.dive_depth.value));
      const auto target = std::ranges::find(read.sensors, "D_TGT", &Argument::name);
      ASSERT_NE(target, read.sensors.end());
      EXPECT_EQ(target->value, std::ceil(options.vehicle.dive_depth.value));
    }
  });
}

TEST(SeagliderSet, SetsDepthAndTimeOfADiveAndCarriesOn) {
  SeagliderOptions options;
  options.vehicle = vehicle::known_profiles().front();
  const auto set = write_seaglider_set(plan_of({{-53.5, 69.0}, {-53.25, 69.25}}), options);

  ASSERT_TRUE(set.has_value());
  ASSERT_EQ(set->files.size(), 2U) << "no science without bands";
  // 400 m at 0.35 m/s tan 26 degrees = 0.171 m/s: 39.05 minutes.
  EXPECT_THAT(set->files[1].text, HasSubstr("\n$D_TGT,200\n$T_DIVE,"));
  EXPECT_TRUE(set->files[1].text.ends_with("\n$GO\n"));
  const double minutes = read_document("cmdfile", set->files[1].text).sensors.at(1).value;
  const double rate = options.vehicle.vertical_speed(options.vehicle.speed_through_water).value;
  EXPECT_EQ(minutes, std::ceil(400.0 / rate / 60.0));
}

TEST(SeagliderSet, SaysWhatThePilotHasToDoWhereThePlanHolds) {
  planning::Plan plan = plan_of({{-53.0, 69.0}, {-52.9, 69.0}, {-52.75, 69.0}});
  plan.waypoints[1].wait = core::Seconds{9600.0};

  const auto set = write_seaglider_set(plan, {});

  ASSERT_TRUE(set.has_value());
  EXPECT_THAT(messages::sentences(set->messages), Contains(HasSubstr("holds for 2 h 40 min at waypoint 1")));
}

TEST(SeagliderSet, RefusesWhatNoSeagliderTakes) {
  SeagliderOptions options;
  options.vehicle = vehicle::known_profiles().front();
  options.vehicle.dive_depth = core::Metres{1200.0};
  options.bands = {*parse_science_band("200:5:1110:60"), *parse_science_band("20:0:111:60")};
  const auto set = write_seaglider_set(plan_of({{-53.5, 69.0}}), options);

  ASSERT_FALSE(set.has_value());
  std::string fields;
  for (const core::Violation& violation : set.error()) fields += violation.field + " ";
  for (const char* field : {"/waypoints", "/dive_depth_m", "/science/1"})
    EXPECT_THAT(fields, HasSubstr(field));
  for (const char* bad : {"", "20:5:1110", "20:5:11x0:60", "deep:5:1:60", "20:5:1:60:1"})
    EXPECT_FALSE(parse_science_band(bad).has_value()) << bad;
}

}  // namespace
}  // namespace floeplan::mission::seaglider_files_test
