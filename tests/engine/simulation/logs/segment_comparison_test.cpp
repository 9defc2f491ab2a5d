#include "engine/simulation/logs/segment_comparison.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "engine/mission/document/packed_degrees.hpp"
#include "tests/engine/simulation/flown.hpp"
#include "tests/engine/simulation/logged.hpp"
#include "tests/support/places.hpp"
#include "tests/support/property.hpp"

namespace floeplan::simulation::segment_comparison_test {
namespace {

using support::flight_start;
using support::shallow_glider;
using support::uniform_water;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::SizeIs;

/// A flight of two hours in a uniform current towards a waypoint that is out of reach, as a log.
std::string simulated_log(double east_m_s, double north_m_s) {
  const World world = uniform_water(east_m_s, north_m_s);
  MissionOrders orders = support::orders_through(world, {{20'000.0, 5'000.0, 0.0}});
  orders.surfaces.front() = {.cause = SurfaceOrders::Cause::every,
                             .interval = core::Seconds{7200.0},
                             .ends_mission = true,
                             .climb = orders.yo.climb};
  FlightSettings settings = support::perfect_sensors();
  settings.record_every = core::Seconds{2.0};
  const FlightRecord record = support::flown(world, orders, settings);
  return support::log_of(record, world, orders.lists.front().waypoints.front(), 230.0, east_m_s, north_m_s);
}

/// The log of a converter that writes decimal degrees but keeps the units of the vehicle.
std::string in_decimal_degrees(const std::string& log) {
  std::istringstream lines{log};
  std::vector<std::string> names;
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields{line};
    std::string converted;
    std::size_t column = 0;
    const bool is_row = !line.empty() && line.front() >= '0' && line.front() <= '9';
    for (std::string field; std::getline(fields, field, ','); ++column) {
      if (line.starts_with("m_present_time")) names.push_back(field);
      const bool is_angle = is_row && !field.empty() &&
                            (names.at(column).ends_with("_lat") || names.at(column).ends_with("_lon"));
      char degrees[40];
      if (is_angle)
        std::snprintf(degrees, sizeof degrees, "%.9f", mission::unpack_degrees(std::stod(field)).degrees);
      converted += (column > 0 ? "," : "") + (is_angle ? std::string{degrees} : field);
    }
    text += converted + "\n";
  }
  return text;
}

std::vector<LoggedSegment> shared_segments() {
  std::vector<LoggedSegment> segments;
  const auto folder = std::filesystem::path{support::source_folder()} / "../shared/data/env/glider";
  for (const char* name :
       {"slocum_amadeus-2014-204-05-000_nav.csv", "slocum_comet-2019-222-02-154_nav.csv"}) {
    std::ifstream stream{folder / name, std::ios::binary};
    const std::string text{std::istreambuf_iterator<char>{stream}, {}};
    if (const auto read = read_glider_log(text)) segments.insert(segments.end(), read->begin(), read->end());
  }
  return segments;
}

TEST(GliderLog, TellsTheSettingsOfAFlightThatWasSimulated) {
  const auto segments = read_glider_log(simulated_log(0.05, -0.08));

  ASSERT_TRUE(segments.has_value());
  ASSERT_THAT(*segments, SizeIs(1));
  const LoggedSegment& segment = segments->front();
  EXPECT_NEAR(segment.start.lon_deg, support::flight_origin.lon_deg, 1e-6);
  EXPECT_NEAR(segment.depth_averaged.east.value, 0.05, 2e-4);
  EXPECT_NEAR(segment.depth_averaged.north.value, -0.08, 2e-4);
  EXPECT_EQ(segment.turned_from.source, ocean::VariationSource::log_variation);
  EXPECT_EQ(segment.turned_from.axes, (geo::LocalMissionAxes{22, {support::logged_variation_rad}}));
  EXPECT_NEAR(segment.turns_down_at.value, 100.0, 4.0);
  EXPECT_NEAR(segment.dive_pitch.value, -0.4538, 0.01);
  EXPECT_NEAR(segment.climb_buoyancy.value, 230e-6, 1e-9);
  EXPECT_NEAR(segment.trim().value, 0.0, 15e-6);
  EXPECT_THAT(segment.waypoints, SizeIs(1));
}

/// At 47.5 N 52 W the numbers fit both notations, so the unit or the speed of the vehicle must decide.
TEST(GliderLog, IsReadInDecimalDegreesAsInTheVehiclesOwn) {
  const std::string log = simulated_log(0.05, -0.08);
  const std::string decimal_log = in_decimal_degrees(log);
  std::string stated = decimal_log;
  for (const std::string unit : {",lat", ",lon"})
    for (std::size_t at = stated.find("timestamp"); (at = stated.find(unit + ",", at)) != std::string::npos;)
      stated.replace(at, unit.size(), ",deg");
  const auto own = read_glider_log(log);
  const auto decimal = read_glider_log(stated);
  const auto untold = read_glider_log(decimal_log);

  ASSERT_TRUE(own.has_value());
  ASSERT_TRUE(decimal.has_value()) << decimal.error().front().field << " " << decimal.error().front().rule;
  ASSERT_THAT(*decimal, SizeIs(1));
  EXPECT_NEAR(decimal->front().start.lat_deg, own->front().start.lat_deg, 1e-6);
  EXPECT_NEAR(decimal->front().end.lon_deg, own->front().end.lon_deg, 1e-6);
  EXPECT_NEAR(decimal->front().waypoints.front().place.lat_deg, own->front().waypoints.front().place.lat_deg,
              1e-6);
  EXPECT_EQ(decimal->front().turned_from.axes, own->front().turned_from.axes);
  EXPECT_EQ(decimal->front().positions_read, "");
  ASSERT_FALSE(untold.has_value());
  EXPECT_THAT(untold.error().front().rule, HasSubstr("Write the unit ddmm or deg"));
}

TEST(GliderLog, TellsWhyItReadDecimalDegreesThatNoUnitStates) {
  const auto file = std::filesystem::path{support::source_folder()} /
                    "../shared/data/env/glider/slocum_comet-2019-222-02-154_nav.csv";
  std::ifstream stream{file, std::ios::binary};
  const std::string log{std::istreambuf_iterator<char>{stream}, {}};
  if (log.empty()) GTEST_SKIP() << "the shared logs are not there";
  const auto decimal = read_glider_log(in_decimal_degrees(log));
  const auto own = read_glider_log(log);

  ASSERT_TRUE(own.has_value() && decimal.has_value());
  EXPECT_EQ(own->front().positions_read, "");
  EXPECT_THAT(decimal->front().positions_read, HasSubstr("m_x_lmc and m_y_lmc"));
  EXPECT_NEAR(decimal->front().end.lat_deg, own->front().end.lat_deg, 1e-6);
}

TEST(GliderLog, ReadsWhatTheVendorsConverterWrites) {
  const std::string commas = simulated_log(0.05, -0.08);
  std::string converted =
      "dbd_label:    DBD_ASC(dinkum_binary_data_ascii)file\nencoding_ver: 2\nnum_ascii_tags: 14\n"
      "fileopen_time: Wed_Aug_21_13:54:25_2019\nsensors_per_cycle: 15\nnum_label_lines: 3\n";
  for (std::size_t at = 0; at < commas.size();) {
    const std::size_t end = commas.find('\n', at);
    std::string line = commas.substr(at, end - at);
    at = end + 1;
    if (line.starts_with('#')) continue;
    std::ranges::replace(line, ',', ' ');
    converted += line + " \n";
    if (line.starts_with("timestamp"))
      converted +=
          "8 8 8 8 8 1 4 4 4 4 4 4 4 8 8 \n8 NaN NaN NaN NaN NaN NaN NaN NaN NaN NaN NaN NaN NaN NaN\n";
  }

  const auto by_commas = read_glider_log(commas);
  const auto by_blanks = read_glider_log(converted);

  ASSERT_TRUE(by_commas.has_value());
  ASSERT_TRUE(by_blanks.has_value());
  EXPECT_EQ(by_blanks->front().dived, by_commas->front().dived);
  EXPECT_EQ(by_blanks->front().end, by_commas->front().end);
  EXPECT_EQ(by_blanks->front().trim(), by_commas->front().trim());
}

TEST(SegmentComparison, FindsASimulatedFlightAgain) {
  const auto segments = read_glider_log(simulated_log(0.05, -0.08));
  ASSERT_TRUE(segments.has_value());

  const auto compared = compare_segment(segments->front(), shallow_glider(), HullMotion{}, DragOf::log);

  ASSERT_TRUE(compared.has_value());
  EXPECT_NEAR(compared->parasite_drag, shallow_glider().hydrodynamics.parasite_drag, 0.01);
  EXPECT_LT(std::abs(compared->speed_m_s.deviation_share()), 0.05);
  EXPECT_LT(compared->apart_share, 0.06);
  EXPECT_LT(std::abs(compared->under_water_s.deviation_share()), 0.06);
}

TEST(SegmentComparison, AgreesWithRealDivesWithinATenth) {
  const std::vector<LoggedSegment> segments = shared_segments();
  if (segments.empty()) GTEST_SKIP() << "the shared logs are not there";
  ASSERT_THAT(segments, SizeIs(2));

  std::vector<SegmentComparison> comparisons;
  for (const LoggedSegment& segment : segments) {
    const auto compared = compare_segment(segment, shallow_glider(), HullMotion{}, DragOf::log);
    ASSERT_TRUE(compared.has_value());
    comparisons.push_back(*compared);
  }

  const ComparisonSummary summary = summary_of(comparisons);
  EXPECT_LT(summary.under_water_share, 0.05);
  EXPECT_LT(summary.dives_share, 0.1);
  EXPECT_LT(summary.speed_share, 0.05);
  EXPECT_LT(summary.apart_share, 0.06);
  EXPECT_TRUE(summary.within_a_tenth());
}

TEST(GliderLog, ReadsFromARealLogWhatItsMissionFileSays) {
  const std::vector<LoggedSegment> segments = shared_segments();
  if (segments.empty()) GTEST_SKIP() << "the shared logs are not there";

  // comet's goto list: two waypoints, a radius of 500 m; its yo turns at 4 m above the bed of 42 m.
  const LoggedSegment& comet = segments.back();
  ASSERT_THAT(comet.waypoints, SizeIs(2));
  EXPECT_NEAR(comet.waypoints.front().reached_within->value, 500.0, 5.0);
  EXPECT_EQ(comet.dives, 17);
  EXPECT_NEAR(comet.turns_down_at.value, 38.0, 1.5);
}

/// The log with another name for its variation, so that it has none, and later times.
std::string without_variation(std::string log, double later_s) {
  log.replace(log.find("m_gps_mag_var"), 13, "m_gps_no_word");
  std::string moved;
  for (std::size_t at = 0; at < log.size();) {
    const std::size_t end = log.find('\n', at);
    const std::string line = log.substr(at, end - at + 1);
    const std::size_t comma = line.find(',');
    const bool is_row = line.front() >= '0' && line.front() <= '9';
    moved += is_row ? std::to_string(std::stod(line) + later_s) + line.substr(comma) : line;
    at = end + 1;
  }
  return moved;
}

TEST(GliderLog, IsTurnedByTheMagneticModelWhereItTellsNoVariation) {
  const auto told = read_glider_log(simulated_log(0.05, -0.08));
  const auto untold = read_glider_log(without_variation(simulated_log(0.05, -0.08), 0.0));

  ASSERT_TRUE(told && untold);
  const LoggedSegment& segment = untold->front();
  EXPECT_EQ(segment.turned_from.source, ocean::VariationSource::magnetic_model);
  // pygeomag 1.1.0: 16.756 degrees west at 47.5 N 52 W in November 2023.
  const double model_rad = core::degrees_to_radians(16.756);
  EXPECT_NEAR(segment.turned_from.axes.variation_west().value, model_rad, 2e-4);
  const double apart_rad =
      std::atan2(segment.depth_averaged.east.value, segment.depth_averaged.north.value) -
      std::atan2(told->front().depth_averaged.east.value, told->front().depth_averaged.north.value);
  EXPECT_NEAR(apart_rad, support::logged_variation_rad - model_rad, 1e-3);
}

TEST(GliderLog, WhoseAxesNothingTellsIsRefused) {
  const auto segments = read_glider_log(without_variation(simulated_log(0.05, -0.08), -8e8));

  ASSERT_FALSE(segments.has_value());
  EXPECT_THAT(segments.error(), Contains(Field(&core::Violation::field, "/m_gps_mag_var")));
}

TEST(GliderLog, RefusesWhatIsNoLogWithEveryFaultAtOnce) {
  const auto columns = read_glider_log("m_present_time,m_depth\ntimestamp,m\n1,2\n");
  ASSERT_FALSE(columns.has_value());
  EXPECT_GE(columns.error().size(), 10U);

  const auto words = read_glider_log("m_present_time,m_depth\ntimestamp,m\n1,deep\n2,x\n");
  ASSERT_FALSE(words.has_value());
  EXPECT_THAT(words.error(), SizeIs(2));
  EXPECT_THAT(words.error(), Contains(Field(&core::Violation::field, "/line 3/m_depth")));

  EXPECT_FALSE(read_glider_log("").has_value());
  EXPECT_FALSE(read_glider_log("# nothing\n\n").has_value());
  const auto binary = read_glider_log("dbd_label:    DBD(dinkum_binary_data)file\nencoding_ver: 5\n");
  ASSERT_FALSE(binary.has_value());
  EXPECT_THAT(binary.error(), SizeIs(1));
}

TEST(GliderLog, SurvivesDamagedLogs) {
  const std::string whole = simulated_log(0.02, 0.01);
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    std::string text = whole;
    for (int i = 0; i < 20; ++i) {
      const auto at = static_cast<std::size_t>(support::uniform(rng, 0.0, static_cast<double>(text.size())));
      text[at] = "0123456789-.,\n#e"[support::uniform_int(rng, 0, 15)];
    }

    const auto segments = read_glider_log(text);

    if (!segments) return;
    for (const LoggedSegment& segment : *segments)
      EXPECT_NO_THROW(
          static_cast<void>(compare_segment(segment, shallow_glider(), HullMotion{}, DragOf::log)));
  });
}

TEST(GliderLog, RefusesALogWhosePumpTellsNothing) {
  std::string text = simulated_log(0.0, 0.0);
  for (std::size_t at = 0; (at = text.find(",-230.0,", at)) != std::string::npos;)
    text.replace(at, 8, ",230.0,");

  const auto segments = read_glider_log(text);

  EXPECT_FALSE(segments.has_value());
}

TEST(GliderLog, RefusesALogWithoutAWholeDive) {
  std::string text = simulated_log(0.0, 0.0);
  text.resize(text.size() / 2);
  text.resize(text.rfind('\n') + 1);

  const auto segments = read_glider_log(text);

  ASSERT_FALSE(segments.has_value());
  EXPECT_THAT(segments.error().front().rule, HasSubstr("no dive"));
}

}  // namespace
}  // namespace floeplan::simulation::segment_comparison_test
