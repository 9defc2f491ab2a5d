#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "api/codec/inputs/plan_inputs.hpp"
#include "api/codec/route_files/route_file.hpp"
#include "tests/support/property.hpp"

namespace floeplan::codec::route_choice_test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

using Line = std::vector<geo::LonLat>;

/// A route as a test file of any format writes it.
struct Given {
  std::string name;
  Line places;
};

std::string number(double value) { return std::to_string(value); }

std::string gpx(const std::vector<Given>& routes, const std::string& of_route, const std::string& of_point,
                const std::string& around = "") {
  std::string text = "<?xml version=\"1.0\"?><gpx>";
  for (const Given& route : routes) {
    text += "<" + of_route + "><name>" + route.name + "</name>" + (around.empty() ? "" : "<" + around + ">");
    for (const geo::LonLat place : route.places)
      text +=
          "<" + of_point + " lat=\"" + number(place.lat_deg) + "\" lon=\"" + number(place.lon_deg) + "\"/>";
    text += (around.empty() ? "" : "</" + around + ">") + "</" + of_route + ">";
  }
  return text + "</gpx>";
}

std::string kml(const std::vector<Given>& routes) {
  std::string text = "<kml><Document><name>all</name>";
  for (const Given& route : routes) {
    text += "<Placemark><name>" + route.name + "</name><LineString><coordinates>";
    for (const geo::LonLat place : route.places)
      text += number(place.lon_deg) + "," + number(place.lat_deg) + " ";
    text += "</coordinates></LineString></Placemark>";
  }
  return text + "</Document></kml>";
}

json positions(const Line& places) {
  json result = json::array();
  for (const geo::LonLat place : places) result.push_back({place.lon_deg, place.lat_deg});
  return result;
}

json geojson(const std::vector<Given>& routes) {
  json features = json::array();
  for (const Given& route : routes)
    features.push_back({{"type", "Feature"},
                        {"properties", {{"name", route.name}}},
                        {"geometry", {{"type", "LineString"}, {"coordinates", positions(route.places)}}}});
  return {{"type", "FeatureCollection"}, {"features", features}};
}

std::string csv(const std::vector<Given>& routes) {
  std::string text = "route,lon,lat\n";
  for (const Given& route : routes)
    for (const geo::LonLat place : route.places)
      text += route.name + "," + number(place.lon_deg) + "," + number(place.lat_deg) + "\n";
  return text;
}

std::string imc(const std::vector<Given>& routes) {
  json plans = json::array();
  for (const Given& route : routes) {
    json plan{{"abbrev", "PlanSpecification"}, {"plan_id", route.name}, {"start_man_id", "0"}};
    for (std::size_t i = 0; i < route.places.size(); ++i) {
      plan["maneuvers"].push_back({{"maneuver_id", std::to_string(i)},
                                   {"data",
                                    {{"abbrev", "Goto"},
                                     {"lon", core::degrees_to_radians(route.places[i].lon_deg)},
                                     {"lat", core::degrees_to_radians(route.places[i].lat_deg)}}}});
      if (i > 0)
        plan["transitions"].push_back(
            {{"source_man", std::to_string(i - 1)}, {"dest_man", std::to_string(i)}});
    }
    plans.push_back(plan);
  }
  return plans.dump();
}

/// The routes as NMEA sentences; the places must have whole degrees, north and west.
std::string nmea(const std::vector<Given>& routes) {
  std::string text;
  for (const Given& route : routes) {
    std::string list = "$GPRTE,1,1,c," + route.name;
    for (const geo::LonLat place : route.places) {
      char line[80];
      std::snprintf(line, sizeof line, "%02.0f00.0000,N,%03.0f00.0000,W", place.lat_deg, -place.lon_deg);
      const std::string name = "W" + number(place.lat_deg) + number(-place.lon_deg);
      text += "$GPWPL," + std::string{line} + "," + name + "\n";
      list += "," + name;
    }
    text += list + "\n";
  }
  return text;
}

std::vector<std::pair<std::string, std::string>> in_every_format(const std::vector<Given>& routes) {
  return {{"a.gpx", gpx(routes, "rte", "rtept")},
          {"t.gpx", gpx(routes, "trk", "trkpt", "trkseg")},
          {"a.kml", kml(routes)},
          {"a.geojson", geojson(routes).dump()},
          {"a.csv", csv(routes)},
          {"a.json", imc(routes)},
          {"a.nmea", nmea(routes)}};
}

std::string fault_of(const std::string& name, const std::string& text,
                     const std::optional<std::string>& wanted = {}) {
  const auto read = read_route_file(name, text, wanted);
  return read ? "" : read.error().front().rule;
}

std::vector<Given> random_routes(std::mt19937_64& rng) {
  std::vector<Given> routes;
  for (int i = support::uniform_int(rng, 1, 4); i > 0; --i) {
    Given route{"r" + std::to_string(i), {}};
    for (int j = support::uniform_int(rng, 2, 5); j > 0; --j)
      route.places.push_back(
          {-1.0 * support::uniform_int(rng, 1, 170), 1.0 * support::uniform_int(rng, 1, 80)});
    routes.push_back(route);
  }
  return routes;
}

TEST(RouteChoice, IsTheSameForEveryFormat) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    const std::vector<Given> routes = random_routes(rng);
    for (const auto& [name, text] : in_every_format(routes)) {
      const std::string fault = fault_of(name, text);
      EXPECT_EQ(fault.empty(), routes.size() == 1) << name << ": " << fault;
      for (std::size_t i = 0; i < routes.size(); ++i) {
        EXPECT_TRUE(routes.size() == 1 || fault.find(routes[i].name) != std::string::npos)
            << name << ": " << fault;
        for (const std::string& wanted : {routes[i].name, std::to_string(i + 1)}) {
          const auto read = read_route_file(name, text, wanted);
          ASSERT_TRUE(read.has_value()) << name << ": " << read.error().front().rule;
          ASSERT_EQ(read->places.size(), routes[i].places.size()) << name;
          for (std::size_t j = 0; j < read->places.size(); ++j) {
            EXPECT_NEAR(read->places[j].lon_deg, routes[i].places[j].lon_deg, 1e-9) << name;
            EXPECT_NEAR(read->places[j].lat_deg, routes[i].places[j].lat_deg, 1e-9) << name;
          }
        }
      }
      EXPECT_THAT(fault_of(name, text, "nothing"),
                  HasSubstr("holds no route \"nothing\"; its routes are 1 "));
    }
  });
}

const std::vector<Given> two{{"out", {{-8.0, 52.0}, {-7.0, 53.0}}},
                             {"other glider", {{-6.0, 51.0}, {-5.0, 52.0}}}};

TEST(RouteChoice, IsARefusalThatNamesTheRoutesAndTheWay) {
  const std::string fault = fault_of("a.gpx", gpx(two, "rte", "rtept"));
  EXPECT_THAT(fault, HasSubstr("holds 2 routes"));
  EXPECT_THAT(fault, HasSubstr("1 \"out\", 2 \"other glider\""));
  EXPECT_THAT(fault, HasSubstr("route_name"));
  EXPECT_THAT(fault, HasSubstr("--route"));
  const std::vector<Given> alike{two[0], {"out", two[1].places}};
  EXPECT_THAT(fault_of("a.gpx", gpx(alike, "rte", "rtept"), "out"), HasSubstr("2 routes named \"out\""));
  EXPECT_EQ(read_route_file("a.gpx", gpx(alike, "rte", "rtept"), "2")->places.front(), two[1].places.front());
  const std::vector<Given> counted{{"2", two[0].places}, {"back", two[1].places}};
  EXPECT_THAT(fault_of("a.gpx", gpx(counted, "rte", "rtept"), "2"),
              HasSubstr("is the name of route 1 \"2\" and also the number of route 2 \"back\""));
  EXPECT_EQ(read_route_file("a.gpx", gpx(counted, "rte", "rtept"), "1")->places.front(),
            two[0].places.front());
}

TEST(RouteChoice, IsMadeInEveryRequestAlike) {
  json inputs{{"depart", "2026-11-20T06:00:00Z"}};
  const json file{{"name", "a.gpx"}, {"text", gpx(two, "rte", "rtept")}};
  json goals = inputs;
  goals["goals_file"] = file;
  json route_file = inputs;
  route_file["route_file"] = file;
  json route = inputs;
  route["route"] = geojson(two);

  EXPECT_THAT(parse_plan_inputs(goals).error().front().rule, HasSubstr("holds 2 routes"));
  EXPECT_THAT(parse_evaluate_inputs(route_file).error().front().rule, HasSubstr("holds 2 routes"));
  EXPECT_THAT(parse_evaluate_inputs(route).error().front().rule, HasSubstr("holds 2 routes"));
  for (json* const request : {&goals, &route_file, &route}) (*request)["route_name"] = "other glider";
  EXPECT_EQ(parse_plan_inputs(goals)->request.from, two[1].places.front());
  EXPECT_EQ(parse_evaluate_inputs(route_file)->route, two[1].places);
  EXPECT_EQ(parse_evaluate_inputs(route)->route, two[1].places);

  inputs["route_name"] = "out";
  inputs["route"] = positions(two[0].places);
  EXPECT_EQ(parse_evaluate_inputs(inputs).error().front().field, "/route_name");
}

TEST(RouteChoice, LeavesOutWhatIsHiddenAndTracksBesideARouteUnlessNamed) {
  const std::string line = "<LineString><coordinates>-8,52 -7,53</coordinates></LineString>";
  const std::string other = "<LineString><coordinates>-6,51 -5,52</coordinates></LineString>";
  const std::string old = "<Placemark><name>old</name><visibility>0</visibility>" + other + "</Placemark>";
  const std::string folded =
      "<Folder><visibility>0</visibility><Placemark><name>old</name>" + other + "</Placemark></Folder>";
  const std::string fresh = "<Placemark><name>new</name><visibility>1</visibility>" + line + "</Placemark>";
  for (const std::string& hidden : {old, folded}) {
    const std::string text = "<kml><Document>" + hidden + fresh + "</Document></kml>";
    const auto read = read_route_file("a.kml", text);
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->places, two[0].places);
    EXPECT_THAT(read->warnings, ElementsAre(HasSubstr("\"old\" is left out (hidden)")));
    EXPECT_EQ(read_route_file("a.kml", text, "old")->places, two[1].places);
    EXPECT_THAT(fault_of("a.kml", "<kml>" + hidden + "</kml>"), HasSubstr("only routes that are not shown"));
  }
  const std::string both =
      "<gpx><trk><name>flown</name><trkseg><trkpt lat='1' lon='1'/><trkpt lat='1' lon='2'/>"
      "</trkseg></trk><rte><rtept lat='52' lon='-8'/><rtept lat='53' lon='-7'/></rte></gpx>";
  EXPECT_EQ(read_route_file("a.gpx", both)->places, two[0].places);
  EXPECT_THAT(read_route_file("a.gpx", both)->warnings, ElementsAre(HasSubstr("a track beside a route")));
  EXPECT_EQ(read_route_file("a.gpx", both, "flown")->places.front(), (geo::LonLat{1.0, 1.0}));
}

/// Law: of a GPX file only the shown routes count; a file without a shown route is refused.
TEST(RouteChoice, LeavesOutWhatOpenCpnHides) {
  support::for_each_seed(30, [](std::mt19937_64& rng) {
    const int count = support::uniform_int(rng, 1, 4);
    const int shown = support::uniform_int(rng, 0, count);  // `count`: none
    const bool are_tracks = support::uniform_int(rng, 0, 1) == 1;
    const std::string of_route = are_tracks ? "trk" : "rte";
    const std::string of_point = are_tracks ? "trkpt" : "rtept";
    std::string file = "<gpx xmlns:opencpn=\"http://www.opencpn.org\">";
    for (int i = 0; i < count; ++i) {
      file += "<" + of_route + "><name>" + std::to_string(10 + i) + "</name><extensions><opencpn:viz>" +
              (i == shown ? "1" : "0") + "</opencpn:viz></extensions>";
      for (const char* lon : {"1", "2"})
        file += "<" + of_point + " lat=\"" + std::to_string(50 + i) + "\" lon=\"" + lon + "\"/>";
      file += "</" + of_route + ">";
    }
    file += "</gpx>";

    if (shown == count) {
      EXPECT_THAT(fault_of("a.gpx", file), HasSubstr("only routes that are not shown"));
    } else {
      const auto read = read_route_file("a.gpx", file, {});
      ASSERT_TRUE(read) << fault_of("a.gpx", file);
      EXPECT_EQ(read->places.front().lat_deg, 50.0 + shown);
    }
  });
}

TEST(RouteGaps, OfATrackAreFlownWithAWarningThatTellsThem) {
  const auto read = read_route_file(
      "a.gpx",
      "<gpx><trk><trkseg><trkpt lat='52' lon='-8'/><trkpt lat='52.5' lon='-7'/></trkseg><trkseg>"
      "<trkpt lat='51' lon='-6'/><trkpt lat='51.5' lon='-5'/></trkseg></trk></gpx>");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->places.size(), 4U);
  EXPECT_THAT(read->warnings, ElementsAre(HasSubstr("a gap of 181 km")));
}

std::string lines(const json& parts) {
  return json{{"type", "MultiLineString"}, {"coordinates", parts}}.dump();
}

TEST(RouteGaps, BetweenLinesAreRefusedAndLinesThatTouchAreOne) {
  EXPECT_THAT(fault_of("a.geojson", lines({{{-8, 52}, {-7, 52.5}}, {{-5, 53}, {-4, 54}}})),
              HasSubstr("does not say how to go from one part to the other"));
  EXPECT_THAT(
      fault_of(
          "a.kml",
          "<kml><Placemark><MultiGeometry><LineString><coordinates>-8,52 -7,52</coordinates></LineString>"
          "<LineString><coordinates>-5,53 -4,53</coordinates></LineString></MultiGeometry></Placemark>"
          "</kml>"),
      HasSubstr("does not say how to go from one part to the other"));
  EXPECT_THAT(read_route_file("a.geojson", lines({{{-8, 52}, {-7, 53}}, {{-7, 53}, {-4, 54}}}))->places,
              ElementsAre(geo::LonLat{-8, 52}, geo::LonLat{-7, 53}, geo::LonLat{-4, 54}));
}

TEST(RouteGaps, AtTheAntimeridianAreNone) {
  EXPECT_THAT(read_route_file("a.geojson",
                              lines({{{179.8, 68.0}, {180.0, 68.025}}, {{-180.0, 68.025}, {-179.8, 68.05}}}))
                  ->places,
              ElementsAre(geo::LonLat{179.8, 68.0}, geo::LonLat{-179.8, 68.05}));
  EXPECT_THAT(
      read_route_file("a.geojson", lines({{{179.8, 68.0}, {180.0, 68.5}}, {{-180.0, 68.5}, {-179.8, 68.05}}}))
          ->places,
      ElementsAre(geo::LonLat{179.8, 68.0}, geo::LonLat{-180.0, 68.5}, geo::LonLat{-179.8, 68.05}))
      << "the route bends there";
  EXPECT_THAT(
      fault_of("a.geojson", lines({{{179.8, 68.0}, {180.0, 68.0}}, {{-180.0, 68.1}, {-179.8, 68.05}}})),
      HasSubstr("a gap of 11.2 km"));
}

TEST(RouteGaps, OfAMetreAtTheAntimeridianAreNone) {
  const auto read = read_route_file(
      "a.geojson", lines({{{179.0, -20.0}, {179.99999, -20.0}}, {{-179.99999, -20.0}, {-179.0, -20.0}}}));
  ASSERT_TRUE(read.has_value());
  EXPECT_THAT(read->warnings, testing::IsEmpty());
  EXPECT_EQ(read->places.size(), 2U);
  EXPECT_THAT(fault_of("a.geojson",
                       lines({{{179.0, -20.0}, {179.9999, -20.0}}, {{-179.9999, -20.0}, {-179.0, -20.0}}})),
              HasSubstr("does not say how to go from one part to the other"));
}

TEST(RoutePositions, MayHaveHeightsWhichAreLeftOut) {
  const auto zeros =
      read_route_file("a.geojson", R"({"type":"LineString","coordinates":[[-8,52,0],[-7,53,0]]})");
  ASSERT_TRUE(zeros.has_value());
  EXPECT_EQ(zeros->places, two[0].places);
  EXPECT_TRUE(zeros->warnings.empty());
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"a.geojson", R"({"type":"LineString","coordinates":[[-8,52,-30],[-7,53,0]]})"},
           {"a.kml", "<kml><LineString><coordinates>-8,52,-30 -7,53,0</coordinates></LineString></kml>"}}) {
    const auto read = read_route_file(name, text);
    ASSERT_TRUE(read.has_value()) << name;
    EXPECT_EQ(read->places, two[0].places);
    EXPECT_THAT(read->warnings, ElementsAre(HasSubstr("third number of a position")));
  }
  EXPECT_THAT(fault_of("a.geojson", R"({"type":"LineString","coordinates":[[-8,52,0,7],[-7,53]]})"),
              HasSubstr("not an array of 4"));
}

TEST(RoutePositions, MayCountTheirLongitudesOnInEitherSense) {
  for (const double turn : {-360.0, 0.0, 360.0}) {
    const Line places{{179.9 + (turn > 0.0 ? 0.0 : turn), 66.5}, {-179.9 + (turn < 0.0 ? 0.0 : turn), 66.6}};
    for (const auto& [name, text] : in_every_format({{"r", places}})) {
      if (name == "a.json" || name == "a.nmea") continue;  // whose longitudes end at 180 degrees
      const auto read = read_route_file(name, text);
      ASSERT_TRUE(read.has_value()) << name << " " << fault_of(name, text);
      EXPECT_NEAR(read->places[0].lon_deg, 179.9, 1e-9) << name;
      EXPECT_NEAR(read->places[1].lon_deg, -179.9, 1e-9) << name;
    }
  }
}

TEST(RouteText, MayHavePrefixesAndBeUtf16) {
  const std::string prefixed =
      "<?xml version=\"1.0\" encoding=\"UTF-16\"?><g:gpx xmlns:g=\"u\"><g:rte><g:rtept lat=\"52\" "
      "lon=\"-8\"/>"
      "<g:rtept lat=\"53\" lon=\"-7\"/></g:rte></g:gpx>";
  std::string little = "\xFF\xFE";
  std::string big = "\xFE\xFF";
  for (const char c : prefixed) {
    little += std::string{c, '\0'};
    big += std::string{'\0', c};
  }
  for (const std::string& text :
       {prefixed, "\xEF\xBB\xBF" + prefixed, little, big, little.substr(2), big.substr(2)}) {
    const auto read = read_route_file("a.gpx", text);
    ASSERT_TRUE(read.has_value()) << fault_of("a.gpx", text);
    EXPECT_EQ(read->places, two[0].places);
  }
  EXPECT_THAT(fault_of("a.gpx", "<gpx><rte><rtept lat='52' lon='-8'/>"), HasSubstr("cut short"));
  EXPECT_THAT(fault_of("a.xml", "<tcx></tcx>"), HasSubstr("\"tcx\""));
}

TEST(NmeaRoutes, ThatAreSentAgainCountOnceAndThoseThatLackASentenceAreRefused) {
  const std::string places = "$GPWPL,5200.0000,N,00800.0000,W,A\n$GPWPL,5300.0000,N,00700.0000,W,B\n";
  const std::string listing = "$GPRTE,2,1,c,r,A\n$GPRTE,2,2,c,r,B\n";
  const std::string none = "$GPRTE,1,1,c,*37\n";  // sent by a plotter without an active route
  EXPECT_EQ(read_route_file("a.nmea", places + none + listing + listing)->places, two[0].places);
  EXPECT_THAT(fault_of("a.nmea", places + "$GPRTE,2,1,c,r,A\n"), HasSubstr("lacks sentence 2 of 2"));
  EXPECT_THAT(fault_of("a.nmea", places + "$GPRTE,2,2,c,r,B\n"),
              HasSubstr("the sentence before it is missing"));
}

TEST(ImcRoutes, ThatBranchAreRefused) {
  json plan = json::parse(imc({two[0]}))[0];
  plan["transitions"].push_back({{"source_man", "0"}, {"dest_man", "0b"}});
  EXPECT_THAT(fault_of("a.json", plan.dump()), HasSubstr("no branches"));
}

}  // namespace
}  // namespace floeplan::codec::route_choice_test
