#include "api/codec/documents/flight_comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace floeplan::codec::flight_comparison_test {
namespace {

using nlohmann::json;

ComparedDive dive(double speed_m_s, double drag) {
  const ocean::VehicleAxes axes{.axes = {22, core::Radians{0.475}},
                                .source = ocean::VariationSource::log_variation};
  ComparedDive made{.file = "log.csv", .logged = {.turned_from = axes, .waypoints = {}}, .compared = {}};
  made.compared.under_water_s = {1000.0, 1050.0};
  made.compared.dives = {4.0, 4.0};
  made.compared.speed_m_s = {0.25, speed_m_s};
  made.compared.over_ground_m = {300.0, 310.0};
  made.compared.apart_share = 0.05;
  made.compared.parasite_drag = drag;
  return made;
}

TEST(CompareFlightInputs, NameEverythingThatIsWrongAtOnce) {
  const std::string log = "m_present_time,m_depth\ntimestamp,m\n1,deep\n";
  const json files = json::array({{{"name", "log.csv"}, {"text", log}}, {{"name", "other.csv"}}});

  const auto inputs = parse_compare_flight_inputs({{"files", files}, {"vehicle", "boat"}, {"drag", "sea"}});

  ASSERT_FALSE(inputs);
  for (const char* field : {"/files/0/line 3/m_depth", "/files/1/text", "/vehicle", "/drag"})
    EXPECT_EQ(std::ranges::count(inputs.error(), std::string{field}, &core::Violation::field), 1) << field;
  EXPECT_EQ(parse_compare_flight_inputs(json::object()).error().front().field, "/files");
}

TEST(FlightComparison, TellsTheMediansOfItsDives) {
  const std::vector<ComparedDive> dives{dive(0.25, 0.1), dive(0.26, 0.14), dive(0.5, 0.2)};

  const json document = comparison_document(dives);

  EXPECT_EQ(document.at("dives").size(), 3U);
  EXPECT_NEAR(document.at("median").at("under_water_pct").get<double>(), 5.0, 1e-9);
  EXPECT_NEAR(document.at("median").at("speed_pct").get<double>(), 4.0, 1e-9);
  EXPECT_NEAR(document.at("median").at("parasite_drag").get<double>(), 0.14, 1e-12);
  EXPECT_TRUE(document.at("median").at("within_a_tenth").get<bool>());
}

}  // namespace
}  // namespace floeplan::codec::flight_comparison_test
