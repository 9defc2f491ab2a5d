#include "api/codec/inputs/zone_inputs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/core/utc_text.hpp"

namespace floeplan::codec::zone_inputs_test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

const json square = json::parse("[[[-54,69],[-53,69],[-53,69.5],[-54,69.5],[-54,69]]]");

json feature(json properties, json coordinates = square, const std::string& type = "Polygon") {
  return {{"type", "Feature"},
          {"properties", std::move(properties)},
          {"geometry", {{"type", type}, {"coordinates", std::move(coordinates)}}}};
}

json inputs(std::vector<json> features) {
  return {{"areas", {{"type", "FeatureCollection"}, {"features", std::move(features)}}}};
}

std::vector<std::string> faults(const json& document) {
  InputReader reader{document};
  EXPECT_NO_THROW((void)read_areas(reader));
  std::vector<std::string> fields;
  for (const core::Violation& violation : reader.violations()) fields.push_back(violation.field);
  return fields;
}

TEST(Areas, AreReadWithTheirDepthsAndTimes) {
  const json document = inputs({feature({{"kind", "stay_in"},
                                         {"name", "box"},
                                         {"from", "2026-11-20T06:00:00Z"},
                                         {"top_m", 0},
                                         {"bottom_m", 300},
                                         {"fill", "#ff0000"}})});
  InputReader reader{document};

  const auto zones = read_areas(reader);

  EXPECT_THAT(reader.violations(), SizeIs(0));
  ASSERT_THAT(zones, SizeIs(1));
  EXPECT_EQ(zones[0].kind, ocean::ZoneKind::stay_in);
  EXPECT_EQ(zones[0].name, "box");
  EXPECT_EQ(zones[0].from, core::parse_iso8601("2026-11-20T06:00:00Z"));
  EXPECT_FALSE(zones[0].until.has_value());
  EXPECT_EQ(zones[0].bottom, core::Metres{300.0});
  EXPECT_THAT(zones[0].area.outer, SizeIs(4));
}

TEST(Areas, HoldToTheEndOfADayThatIsGivenWithoutATime) {
  const json document = inputs({feature({{"kind", "no_go"}, {"from", "2026-11-20"}, {"until", "2026-11-21"}}),
                                feature({{"kind", "no_go"}, {"until", "2026-11-21T00:00:00Z"}})});
  InputReader reader{document};

  const auto zones = read_areas(reader);

  ASSERT_THAT(zones, SizeIs(2));
  EXPECT_EQ(zones[0].from, core::parse_iso8601("2026-11-20T00:00:00Z"));
  EXPECT_EQ(zones[0].until, core::parse_iso8601("2026-11-22T00:00:00Z"));
  EXPECT_EQ(zones[1].until, core::parse_iso8601("2026-11-21T00:00:00Z"));
}

TEST(Areas, MayHaveHeightsWhichAreLeftOutWithARemark) {
  const json document = inputs({feature(
      {{"kind", "no_go"}}, json::parse("[[[-54,69,0],[-53,69,5],[-53,69.5,0],[-54,69.5,0],[-54,69,0]]]"))});
  InputReader reader{document};

  EXPECT_THAT(read_areas(reader), SizeIs(1));
  EXPECT_THAT(reader.remarks(), ElementsAre(HasSubstr("third number of a position")));
}

TEST(Areas, BecomeOneZoneForEachPartOfAMultipolygon) {
  const json document = inputs({feature({{"kind", "no_go"}}, json::array({square, square}), "MultiPolygon")});
  InputReader reader{document};

  EXPECT_THAT(read_areas(reader), SizeIs(2));
  EXPECT_THAT(reader.violations(), SizeIs(0));
}

TEST(Areas, ComeBackTheSameFromTheirOwnText) {
  const json document =
      inputs({feature({{"kind", "no_go"}, {"until", "2026-11-20T06:00:00Z"}, {"top_m", 20}})});
  InputReader first{document};
  const json written = areas_json(read_areas(first));
  const json again_document{{"areas", written}};
  InputReader second{again_document};

  EXPECT_EQ(areas_json(read_areas(second)), written);
  EXPECT_THAT(second.violations(), SizeIs(0));
}

TEST(Areas, KeepThePlacesOfTheirFeaturesInTheRequest) {
  json second_square = square;
  for (json& corner : second_square[0]) corner[0] = corner[0].get<double>() + 2.0;
  const json document = inputs(
      {feature({{"kind", "no_go"}}, json::array({square, second_square}), "MultiPolygon"),
       feature({{"kind", "no_go"}, {"name", "bank"}}), feature({{"kind", "no_go"}, {"name", "reef"}})});
  InputReader reader{document};

  const auto zones = read_areas(reader);
  const json written = areas_json(zones);

  ASSERT_THAT(zones, SizeIs(4));
  EXPECT_EQ(zones[1].feature, 0U);
  EXPECT_EQ(zones[2].feature, 1U);
  ASSERT_THAT(written.at("features"), SizeIs(3));
  EXPECT_EQ(written.at("/features/0/geometry/type"_json_pointer), "MultiPolygon");
  EXPECT_EQ(written.at("/features/0/geometry/coordinates"_json_pointer),
            json::array({square, second_square}));
  EXPECT_EQ(written.at("/features/2/properties/name"_json_pointer), "reef");
}

TEST(Areas, AreRefusedWithThePlaceOfEveryFault) {
  const json open_ring = json::parse("[[[-54,69],[-53,69],[-53,69.5],[-54,69.5]]]");
  const json beyond_the_pole = json::parse("[[[-54,69],[-53,99],[-53,69.5],[-54,69]]]");
  const json document =
      inputs({feature({{"kind", "keep_out"}}), feature({{"name", "no kind"}}),
              feature({{"kind", "no_go"}}, open_ring), feature({{"kind", "no_go"}}, beyond_the_pole), json(7),
              feature({{"kind", "no_go"}}, json::array({1, 2}), "Point"),
              feature({{"kind", "no_go"}, {"top_m", 30}, {"bottom_m", 20}, {"from", "yesterday"}})});

  EXPECT_THAT(
      faults(document),
      ElementsAre("/areas/features/0/properties/kind", "/areas/features/1/properties/kind",
                  "/areas/features/2/geometry/coordinates/0", "/areas/features/3/geometry/coordinates/0/1",
                  "/areas/features/4", "/areas/features/5/geometry", "/areas/features/6/properties/from",
                  "/areas/features/6/properties/bottom_m"));
}

/// An outline shaped like an hourglass leaves half of the box open that its corners should enclose.
TEST(Areas, AreRefusedWhereTheirOutlineCrossesItself) {
  const json hourglass = json::parse("[[[-54,69],[-52,70],[-52,69],[-54,70],[-54,69]]]");
  const json document = inputs({feature({{"kind", "no_go"}}, hourglass)});
  InputReader reader{document};
  (void)read_areas(reader);

  ASSERT_THAT(reader.violations(), SizeIs(1));
  EXPECT_EQ(reader.violations().front().field, "/areas/features/0/geometry/coordinates/0");
  EXPECT_THAT(reader.violations().front().rule, HasSubstr("[-53.0,69.5]"));
}

/// Two areas written as one polygon: the second would count as a hole, not as an area.
TEST(Areas, AreRefusedWhereAHoleLiesOutside) {
  const auto with_hole = [](const char* hole) {
    return inputs({feature({{"kind", "no_go"}}, json::array({square[0], json::parse(hole)}))});
  };
  EXPECT_THAT(faults(with_hole("[[-52,69],[-51,69],[-51,69.5],[-52,69]]")),
              ElementsAre("/areas/features/0/geometry/coordinates/1"));
  EXPECT_THAT(faults(with_hole("[[-53.8,69.1],[-53.2,69.1],[-53.2,69.4],[-53.8,69.1]]")), SizeIs(0));
  EXPECT_THAT(faults(with_hole("[[-54,69.25],[-53.5,69],[-53,69.25],[-53.5,69.5],[-54,69.25]]")), SizeIs(0))
      << "touches the outline with every corner";
}

TEST(Areas, AreRefusedWhereTheNameOfARuleIsNearlyRight) {
  EXPECT_THAT(faults(inputs({feature({{"kind", "no_go"}, {"bottom", 30}, {"Valid-From", "2026-11-20"}})})),
              ElementsAre("/areas/features/0/properties/Valid-From", "/areas/features/0/properties/bottom"));
  EXPECT_THAT(faults(inputs({feature({{"kind", "no_go"}, {"begin", nullptr}, {"title", "box"}})})), SizeIs(0))
      << "a map program's own, and one without a value";
}

/// From -180 to 180 in one edge: both ends are the same place, and the edge leads all the way round.
TEST(Areas, MayLeadAllTheWayRoundTheEarth) {
  const json arctic = json::parse("[[[-180,60],[180,60],[180,90],[-180,90],[-180,60]]]");
  const json document = inputs({feature({{"kind", "no_go"}}, arctic)});
  InputReader reader{document};

  const std::vector<ocean::Zone> zones = read_areas(reader);

  ASSERT_THAT(reader.violations(), SizeIs(0));
  ASSERT_THAT(zones, SizeIs(1));
  for (const double lon_deg : {-179.0, -53.0, 0.0, 100.0, 179.0}) {
    EXPECT_TRUE(contains(zones.front().area, {lon_deg, 69.0})) << lon_deg;
    EXPECT_FALSE(contains(zones.front().area, {lon_deg, 59.0})) << lon_deg;
  }
}

/// If such an edge took the shorter way round the Earth, the area to be closed would stay open.
TEST(Areas, AreRefusedWhereAnEdgeCouldLeadRoundTheEarthEitherWay) {
  const json wide = json::parse("[[[-100,60],[100,60],[100,80],[-100,80],[-100,60]]]");
  const json round_a_pole = json::parse("[[[-180,60],[-90,60],[0,60],[90,60],[180,60]]]");

  EXPECT_THAT(
      faults(inputs({feature({{"kind", "no_go"}}, wide), feature({{"kind", "no_go"}}, round_a_pole)})),
      ElementsAre("/areas/features/0/geometry/coordinates/0", "/areas/features/1/geometry/coordinates/0"));
}

TEST(Areas, AreRefusedWhenTheyAreNoGeoJson) {
  EXPECT_THAT(faults({{"areas", "everywhere"}}), ElementsAre("/areas"));
  EXPECT_THAT(faults({{"areas", {{"type", "FeatureCollection"}}}}), ElementsAre("/areas"));
  EXPECT_THAT(faults({{"areas", {{"type", "Feature"}, {"properties", nullptr}}}}),
              ElementsAre("/areas/properties/kind", "/areas/geometry"));
}

TEST(Areas, AreBoundedInNumberAndInCorners) {
  EXPECT_THAT(faults(inputs(std::vector<json>(1001, feature({{"kind", "no_go"}})))), ElementsAre("/areas"));

  json ring = json::array();
  for (int i = 0; i < 60'000; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 60'000;
    ring.push_back({-53.0 + std::cos(angle), 69.0 + std::sin(angle)});
  }
  ring.push_back(ring.front());
  const json many = json::array({ring});
  EXPECT_THAT(faults(inputs({feature({{"kind", "no_go"}}, many), feature({{"kind", "no_go"}}, many)})),
              ElementsAre("/areas"));
}

}  // namespace
}  // namespace floeplan::codec::zone_inputs_test
