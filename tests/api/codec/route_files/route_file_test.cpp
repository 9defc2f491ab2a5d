#include "api/codec/route_files/route_file.hpp"

#include <gmock/gmock.h>

#include "api/codec/inputs/plan_inputs.hpp"
#include "engine/core/violation_list.hpp"
#include "nlohmann/json.hpp"
#include "tests/support/property.hpp"

namespace floeplan::codec::route_file_test {
namespace {

using nlohmann::json;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const geo::LonLat first{-53.5, 69.25};
const geo::LonLat second{-52.75, 69.0};

std::string fault_of(const std::string& name, const std::string& text) {
  const auto read = read_route_file(name, text);
  return read ? "" : read.error().front().field + ": " + read.error().front().rule;
}

TEST(RouteFile, TakesLongitudesCountedEastwardsToAFullTurn) {
  const auto read = read_route_file("a.csv", "lon,lat\n306.5,69.25\n-52.75,69\n");
  ASSERT_TRUE(read.has_value());
  EXPECT_THAT(read->places, ElementsAre(first, second));
}

TEST(RouteFile, NamesAHundredOfVeryManyFaults) {
  std::string gpx = "<gpx>";
  std::string kml = "<kml>";
  for (int i = 0; i < 10'000; ++i) {
    gpx += "<rtept lat='95' lon='0'/>\n";
    kml += "<Point><coordinates>0,95</coordinates></Point>\n";
  }

  for (const auto& [name, text] : {std::pair{"a.gpx", gpx + "</gpx>"}, std::pair{"a.kml", kml + "</kml>"}}) {
    const auto read = read_route_file(name, text);
    ASSERT_FALSE(read.has_value()) << name;
    EXPECT_EQ(read.error().size(), core::most_violations + 1) << name;
  }
}

TEST(RouteFile, ReadsEveryFormatAlike) {
  const std::vector<std::pair<std::string, std::string>> files{
      {"a.gpx",
       "<?xml version=\"1.0\"?>\n<gpx><!-- <rtept lat='1' lon='1'/> --><wpt lat='3' lon='3'/><rte>"
       "<rtept lat=\"69.25\" lon=\"-53.5\"><name>a &gt; b</name></rtept><rtept lon='-52.75' lat='69'/>"
       "</rte></gpx>"},
      {"a.kml",
       "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><Placemark><Point><coordinates>1,1"
       "</coordinates></Point></Placemark><Placemark><LineString><coordinates>\n -53.5,69.25,0\n\t"
       "-52.75,69,0 </coordinates></LineString></Placemark></Document></kml>"},
      {"a.geojson", R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":
                       {"type":"LineString","coordinates":[[-53.5,69.25],[-52.75,69,-3]]}}]})"},
      {"a.csv",
       "\xEF\xBB\xBF"
       "name;Longitude;Latitude\r\n\r\na;-53.5;69.25\r\nb;-52.75;69\r\n"},
      {"plan.csv", "index,lon_deg,lat_deg,eta_utc\n0,-53.5,69.25,2026-11-20T06:00:00Z\n1,-52.75,69.0,\n"},
      {"goto_l10.ma",
       "behavior_name=goto_list\n<start:b_arg>\nb_arg: num_waypoints(nodim) 2\n<end:b_arg>\n"
       "<start:waypoints>\n-5330.0 6915.0\n-5245 6900\n<end:waypoints>\n"},
      {"route.nmea",
       "$GPGGA,120000,6900,N,05300,W,1,8,1,0,M,,,,*00\r\n$GPWPL,6900.0000,N,05245.0000,W,B*12\r\n"
       "$IIWPL,6915.0000,N,05330.0000,W,A\r\n$GPRTE,2,1,c,r,A*2B\r\n$GPRTE,2,2,c,r,B*2B\r\n"},
      {"targets",
       "/ comment\nB lat=6900.00 lon=-5245.00 radius=100 goto=B\nA lat=6915 lon=-5330 radius=500 goto=B\n"}};

  for (const auto& [name, text] : files) {
    const auto read = read_route_file(name, text);
    ASSERT_TRUE(read.has_value()) << name << " " << fault_of(name, text);
    if (name == "targets") {
      EXPECT_THAT(read->places, ElementsAre(second)) << "the first target leads to itself";
    } else {
      EXPECT_THAT(read->places, ElementsAre(first, second)) << name;
    }
  }
}

std::string list_of_three(const std::string& arguments) {
  return "behavior_name=goto_list\n<start:b_arg>\n" + arguments +
         "b_arg: num_waypoints(nodim) 3\n<end:b_arg>\n<start:waypoints>\n-0730 5200\n-0700 5230\n-0600 5200\n"
         "<end:waypoints>\n";
}

TEST(RouteFile, HoldsTheRowsOfAGotoListThatAreFlown) {
  const auto read = read_route_file(
      "goto_l11.ma", list_of_three("b_arg: num_legs_to_run(nodim) -2\nb_arg: initial_wpt(enum) 1\n"));

  ASSERT_TRUE(read.has_value());
  EXPECT_THAT(read->places, ElementsAre(geo::LonLat{-7.0, 52.5}, geo::LonLat{-6.0, 52.0}));
  EXPECT_THAT(read->warnings, testing::Contains(HasSubstr("goto_l11.ma: the vehicle flies rows 1 and 2")));
}

TEST(RouteFile, BeginsWithTheRowOfAGotoListThatIsClosestToTheStart) {
  const std::string text = list_of_three("b_arg: num_legs_to_run(nodim) -2\nb_arg: initial_wpt(enum) -2\n");

  EXPECT_EQ(read_route_file("goto_l11.ma", text)->places.size(), 3U);
  EXPECT_THAT(read_route_file("goto_l11.ma", text, {}, geo::LonLat{-5.9, 51.9})->places,
              ElementsAre(geo::LonLat{-6.0, 52.0}));
}

TEST(RouteFile, RefusesAGotoListOfWhichNobodyKnowsWhatIsFlown) {
  EXPECT_THAT(fault_of("goto_l11.ma", list_of_three("b_arg: num_legs_to_run(nodim) 0\n")),
              HasSubstr("num_legs_to_run: must be from 1 to 1000"));
  EXPECT_THAT(fault_of("goto_l11.ma", list_of_three("b_arg: initial_wpt(enum) 1000000\n")),
              HasSubstr("another program on board"));
}

TEST(RouteFile, FollowsTargetsInTheOrderInWhichTheyLead) {
  const auto read =
      read_route_file("targets",
                      "A lat=6915 lon=-5330 radius=500 goto=C\nB lat=6900 lon=-5245 radius=500 goto=B\n"
                      "C lat=6906 lon=-5300 radius=500 goto=B depth=3\n");

  ASSERT_TRUE(read.has_value());
  ASSERT_EQ(read->places.size(), 3U);
  EXPECT_DOUBLE_EQ(read->places[1].lat_deg, 69.1);
  EXPECT_EQ(read->places[2], second);
}

TEST(RouteFile, TellsWhatTargetsLeaveOutAndThatTheyGoRound) {
  const auto loop = read_route_file("targets",
                                    "ONE lat=5200.0 lon=-800.0 radius=500 goto=TWO\n"
                                    "TWO lat=5230.0 lon=-0700.0 radius=500 goto=ONE\n"
                                    "OFF lat=5100.0 lon=-900.0 radius=500 goto=OFF\n");
  ASSERT_TRUE(loop.has_value());
  EXPECT_EQ(loop->places.size(), 2U);
  EXPECT_THAT(loop->warnings, Contains(HasSubstr("after TWO the vehicle goes on to ONE again")));
  EXPECT_THAT(loop->warnings, Contains(HasSubstr("leads from the first target to OFF")));

  const auto line = read_route_file("targets",
                                    "ONE lat=5200.0 lon=-800.0 radius=500 goto=TWO\n"
                                    "TWO lat=5230.0 lon=-0700.0 radius=500 goto=TWO\n");
  ASSERT_TRUE(line.has_value());
  EXPECT_THAT(line->warnings, testing::IsEmpty());
}

TEST(RouteFile, SaysThatWaypointsOfAMissionAreInLocalMetres) {
  const auto read = read_route_file("m.mi",
                                    "behavior: goto_list\n"
                                    "    b_arg: args_from_file(enum) -1\n"
                                    "    b_arg: num_legs_to_run(nodim) -2\n"
                                    "    b_arg: num_waypoints(nodim) 2\n"
                                    "    b_arg: wpt_units_0(enum) 0\n"
                                    "    b_arg: wpt_x_0(X) -0730.00\n"
                                    "    b_arg: wpt_y_0(X) 5200.00\n"
                                    "    b_arg: wpt_units_1(enum) 0\n"
                                    "    b_arg: wpt_x_1(X) -0700.00\n"
                                    "    b_arg: wpt_y_1(X) 5230.00\n");
  ASSERT_FALSE(read.has_value());
  EXPECT_THAT(read.error().front().rule, HasSubstr("in local metres or UTM"));
  EXPECT_THAT(read.error().front().rule, testing::Not(HasSubstr("in separate files")));
}

TEST(RouteFile, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(fault_of("a.ma", "behavior_name=goto_list\n<start:b_arg>\nb_arg: num_waypoints(nodim) 0\n"),
              HasSubstr("line 3"));
  EXPECT_THAT(fault_of("a.ma",
                       "behavior_name=goto_list\n<start:b_arg>\nb_arg: num_waypoints(nodim) 1\n<end:b_arg>\n"
                       "<start:waypoints>\n-53.5 69.25\n<end:waypoints>\n"),
              HasSubstr("line 6: the coordinates look like decimal degrees"));
  EXPECT_THAT(fault_of("a.mi", "behavior: abend\n"), HasSubstr("no waypoints"));
  EXPECT_THAT(fault_of("a.gpx", "<gpx>\n<rtept lat=\"91\" lon=\"0\"/></gpx>"), HasSubstr("line 2"));
  EXPECT_THAT(fault_of("a.gpx", "<gpx></gpx>"), HasSubstr("no rtept"));
  EXPECT_THAT(fault_of("a.kml", "<kml><LineString><coordinates>1,x</coordinates></LineString></kml>"),
              HasSubstr("line 1"));
  EXPECT_THAT(fault_of("a.json", R"({"type":3,"coordinates":[[0,0]]})"), HasSubstr("no LineString"));
  EXPECT_THAT(fault_of("a.json", R"({"type":"LineString","coordinates":[[0,"x"]]})"),
              HasSubstr("/coordinates/0: must be [longitude, latitude]"));
  EXPECT_THAT(fault_of("a.csv", "a,b\n1,2\n"), HasSubstr("column lon"));
  EXPECT_THAT(fault_of("a.csv", "lon,lat\n1,2\n1\n"), HasSubstr("line 3"));
  EXPECT_THAT(fault_of("targets", "A lat=6915 lon=-5330 radius=500 goto=X\n"),
              HasSubstr("names a target that the file does not hold"));
  EXPECT_THAT(fault_of("a", " \n"), HasSubstr("empty"));
  EXPECT_THAT(fault_of("a", std::string(9'000'000, 'x')), HasSubstr("8 MiB"));
}

TEST(RouteFile, SurvivesBrokenXml) {
  const std::string sound = "<gpx><rte><rtept lat=\"69.25\" lon='-53.5'><name>x</name></rtept></rte></gpx>";
  support::for_each_seed(2000, [&](std::mt19937_64& rng) {
    std::string text = sound;
    for (int edits = support::uniform_int(rng, 1, 6); edits > 0 && !text.empty(); --edits) {
      const auto at =
          static_cast<std::size_t>(support::uniform_int(rng, 0, static_cast<int>(text.size()) - 1));
      if (support::uniform_int(rng, 0, 1) == 0) {
        text.erase(at, static_cast<std::size_t>(support::uniform_int(rng, 1, 9)));
      } else {
        text.insert(at, 1, "<>=\"'/!-? \n\0x"[support::uniform_int(rng, 0, 12)]);
      }
    }
    (void)read_route_file("a.gpx", text);
  });
}

json inputs_with(const char* key, const std::string& text) {
  return {{"depart", "2026-11-20T06:00:00Z"}, {key, {{"name", "a.csv"}, {"text", text}}}};
}

TEST(GoalsFile, GivesStartWaysAndGoal) {
  const std::string three = "lon,lat\n-53.5,69.25\n-53,69.1\n-52.75,69\n";

  const auto alone = parse_plan_inputs(inputs_with("goals_file", three));
  ASSERT_TRUE(alone.has_value());
  EXPECT_EQ(alone->request.from, first);
  EXPECT_EQ(alone->request.to, second);
  EXPECT_EQ(alone->request.via.size(), 1U);

  json with_start = inputs_with("goals_file", three);
  with_start["from"] = {-54.0, 69.0};
  const auto started = parse_plan_inputs(with_start);
  ASSERT_TRUE(started.has_value());
  EXPECT_EQ(started->request.from, (geo::LonLat{-54.0, 69.0}));
  EXPECT_EQ(started->request.via.size(), 2U);

  with_start["to"] = {-52.0, 69.0};
  EXPECT_FALSE(parse_plan_inputs(with_start).has_value());
}

TEST(GoalsFile, ThatBeginsWhereTheVehicleIsGivesThatPlaceOnce) {
  json inputs = inputs_with("goals_file", "lon,lat\n-53.5,69.2500001\n-53,69.1\n-53,69.1\n-52.75,69\n");
  inputs["from"] = {-53.5, 69.25};

  const auto parsed = parse_plan_inputs(inputs);

  ASSERT_TRUE(parsed.has_value()) << parsed.error().front().rule;
  EXPECT_EQ(parsed->request.from, first) << "as the request says it";
  EXPECT_THAT(parsed->request.via, ElementsAre(geo::LonLat{-53.0, 69.1}));
  ASSERT_EQ(parsed->warnings.size(), 1U);
  EXPECT_THAT(parsed->warnings[0], HasSubstr("place 2 of the route"));
}

TEST(RouteFileInput, IsEvaluatedFromTheGivenStart) {
  json inputs = inputs_with("route_file", "lon,lat\n-52.75,69\n");
  EXPECT_FALSE(parse_evaluate_inputs(inputs).has_value()) << "one place alone is no route";
  inputs["from"] = {-53.5, 69.25};
  const auto parsed = parse_evaluate_inputs(inputs);
  ASSERT_TRUE(parsed.has_value());
  EXPECT_THAT(parsed->route, ElementsAre(first, second));
  inputs["route_file"] = 3;
  EXPECT_FALSE(parse_evaluate_inputs(inputs).has_value());
}

/// An IMC plan of these maneuvers, in this order.
std::string imc_plan(const std::vector<std::string>& maneuvers) {
  json plan{{"abbrev", "PlanSpecification"},
            {"start_man_id", "0"},
            {"maneuvers", json::array()},
            {"transitions", json::array()}};
  for (std::size_t i = 0; i < maneuvers.size(); ++i) {
    plan["maneuvers"].push_back({{"maneuver_id", std::to_string(i)}, {"data", json::parse(maneuvers[i])}});
    if (i > 0)
      plan["transitions"].push_back({{"source_man", std::to_string(i - 1)}, {"dest_man", std::to_string(i)}});
  }
  return plan.dump();
}

TEST(NmeaRoute, IsFlownInTheOrderOfItsWaypointsWhereNoRouteIsGiven) {
  const auto read =
      read_route_file("a.txt", "$GPWPL,6915.0000,N,05330.0000,W,A\n$GPWPL,6900.0000,N,05245.0000,W,B\n");
  ASSERT_TRUE(read.has_value()) << read.error().front().rule;
  EXPECT_THAT(read->places, ElementsAre(first, second));
}

TEST(NmeaRoute, IsRefusedWithTheLineThatIsWrong) {
  const std::string good = "$GPWPL,6915.0000,N,05330.0000,W,A\n";
  EXPECT_THAT(fault_of("a.nmea", good + "$GPWPL,6915.0000,N,05330.0000,W,B*00\n"),
              HasSubstr("line 2: has a wrong checksum"));
  EXPECT_THAT(fault_of("a.nmea", good + "$GPWPL,6960.0000,N,05330.0000,W,B\n"),
              HasSubstr("line 2: must be a latitude"));
  EXPECT_THAT(fault_of("a.nmea", good + "$GPWPL,69.25,N,53.5,W,B\n"),
              HasSubstr("line 2: must be a latitude"));
  EXPECT_THAT(fault_of("a.nmea", good + "$GPWPL,6915.0000,E,05330.0000,W,B\n"), HasSubstr("line 2"));
  EXPECT_THAT(fault_of("a.nmea", good + "$GPWPL,6916.0000,N,05330.0000,W,A\n"),
              HasSubstr("a different position"));
  EXPECT_THAT(fault_of("a.nmea", good + "$GPRTE,1,1,c,r,A,B\n"), HasSubstr("waypoint B in its route"));
  EXPECT_THAT(fault_of("a.nmea", good + "$GPRTE,1,1,c,r,A\n$GPRTE,1,1,c,s,A\n"), HasSubstr("holds 2 routes"));
  EXPECT_THAT(fault_of("a.nmea", "$GPGGA,120000\n"), HasSubstr("no WPL"));
}

TEST(ImcRoute, FollowsTheTransitionsThroughGotosAndPaths) {
  const std::string go = R"({"abbrev":"Goto","lat":1.2,"lon":-0.9})";
  const std::string path =
      R"({"abbrev":"FollowPath","lat":1.2,"lon":-0.9,"points":[{"x":0,"y":0,"z":0},{"x":1000,"y":0},{"x":0,"y":-500}]})";
  const auto read = read_route_file("plan.json", imc_plan({go, path}));

  ASSERT_TRUE(read.has_value()) << read.error().front().rule;
  ASSERT_EQ(read->places.size(), 4U);
  EXPECT_NEAR(read->places[0].lat_deg, 68.75493541569878, 1e-12);
  EXPECT_NEAR(read->places[0].lon_deg, -51.56620156177409, 1e-12);
  EXPECT_NEAR(read->places[2].lat_deg - read->places[1].lat_deg, 1000.0 / 111'550.0, 2e-5);
  EXPECT_LT(read->places[3].lon_deg, read->places[1].lon_deg);
}

TEST(ImcRoute, IsRefusedWithTheManeuverThatIsWrong) {
  EXPECT_THAT(fault_of("plan.json", imc_plan({R"({"abbrev":"Goto","lat":69.2,"lon":-53.2})"})),
              HasSubstr("radians"));
  EXPECT_THAT(fault_of("plan.json", imc_plan({R"({"abbrev":"Rows","lat":1.2,"lon":-0.9})"})),
              HasSubstr("pattern"));
  EXPECT_THAT(fault_of("plan.json", imc_plan({})), HasSubstr("does not hold this maneuver"));
  EXPECT_THAT(fault_of("plan.json", R"({"abbrev":"Abort"})"), HasSubstr("PlanSpecification"));
}

TEST(RouteInput, TakesAPlaceThatIsGivenTwiceOnceAndSaysWhich) {
  const json positions{{-53.5, 69.25}, {-53.5, 69.25}, {-53.5, 69.2500001}, {-52.75, 69.0}, {-52.75, 69.0}};
  const auto parsed = parse_evaluate_inputs({{"depart", "2026-11-20T06:00:00Z"}, {"route", positions}});

  ASSERT_TRUE(parsed.has_value());
  EXPECT_THAT(parsed->route, ElementsAre(first, second));
  ASSERT_EQ(parsed->warnings.size(), 1U);
  EXPECT_THAT(parsed->warnings[0], HasSubstr("places 1, 2, 4 of the route"));

  const auto again = parse_evaluate_inputs(to_json(*parsed));
  ASSERT_TRUE(again.has_value()) << "a job keeps its inputs in this form";
  EXPECT_EQ(again->warnings, parsed->warnings);
}

TEST(RouteInput, OfOnePlaceOrOfLegsAcrossTheGlobeIsRefusedWithItsIndex) {
  const auto fault_of = [](const json& inputs) {
    const auto parsed = parse_evaluate_inputs(inputs);
    return parsed ? core::Violation{} : parsed.error().front();
  };
  const std::string twice = "lon,lat\n-52.75,69\n-52.75,69\n";
  const std::string far = "lon,lat\n-52.75,69\n-52.75,69\n120,-40\n";

  EXPECT_EQ(fault_of(inputs_with("route_file", twice)).field, "/route_file");
  EXPECT_THAT(fault_of(inputs_with("route_file", far)).rule, HasSubstr("place 2 is more than 5000 km"));
  EXPECT_EQ(
      fault_of({{"depart", "2026-11-20T06:00:00Z"}, {"route", {{-53, 69}, {-52, 69}, {100, -40}}}}).field,
      "/route/2");
}

TEST(RouteInput, RemarksReachTheWarningsOfTheAnswer) {
  json inputs{{"depart", "2026-11-20T06:00:00Z"},
              {"from", {-53, 69}},
              {"to", {-52, 69}},
              {"remarks", {"read by hand"}}};

  EXPECT_THAT(parse_plan_inputs(inputs)->warnings, ElementsAre("read by hand"));
  EXPECT_EQ(parse_plan_inputs(to_json(*parse_plan_inputs(inputs)))->warnings.size(), 1U);
  inputs["remarks"] = "one";
  EXPECT_FALSE(parse_plan_inputs(inputs).has_value());
}

}  // namespace
}  // namespace floeplan::codec::route_file_test
