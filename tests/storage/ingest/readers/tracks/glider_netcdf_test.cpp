#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "storage/ingest/readers/tracks/track_readers.hpp"
#include "storage/repository/features/glider_track_repository.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::glider_netcdf_test {
namespace {

using testing::HasSubstr;
using Type = NetcdfWriter::Type;

constexpr double fill = -9999.0;
constexpr double start_s = 1.78e9;

/// A profile as the IOOS National Glider Data Assembly Center has it, or a file of OG1, as test after test varies it.
struct GliderFile {
  bool og1{false};
  std::string trajectory{"amadeus-20260501T0000"};
  std::vector<double> times{start_s, start_s + 60.0, start_s + 120.0};
  std::vector<double> lats{69.0, 69.001, 69.002};
  std::vector<double> lons{-52.0, -52.001, -52.002};
  std::vector<double> depths{0.5, 80.0, 160.0};
  std::string depth_name{"depth"};
  std::map<std::string, std::string> depth_texts{{"units", "m"}, {"positive", "down"}};
  std::vector<double> lat_flags{};  // empty: none
  std::vector<double> east{0.2};    // one, or as many as there are rows
  std::vector<double> north{-0.1};
  std::map<std::string, std::string> current_texts{{"units", "m s-1"}};
  double current_time{start_s + 90.0};
  std::string first_says{};  // the standard names of both components; empty: none
  std::string second_says{};

  void write(const std::filesystem::path& file) const {
    NetcdfWriter writer{file};
    const std::string rows = og1 ? "N_MEASUREMENTS" : "time";
    writer.dimension(rows, times.size());
    const auto line = [&](const std::string& name, const std::vector<double>& values,
                          std::map<std::string, std::string> texts, std::vector<std::string> along) {
      writer.variable({.name = name,
                       .dimensions = std::move(along),
                       .values = values,
                       .texts = std::move(texts),
                       .numbers = {},
                       .fill = fill,
                       .type = Type::float64});
    };
    const std::map<std::string, std::string> seconds{{"units", "seconds since 1970-01-01T00:00:00Z"},
                                                     {"standard_name", "time"}};
    line(og1 ? "TIME" : "time", times, seconds, {rows});
    line(og1 ? "LATITUDE" : "lat", lats, {{"units", "degrees_north"}}, {rows});
    line(og1 ? "LONGITUDE" : "lon", lons, {{"units", "degrees_east"}}, {rows});
    if (!depths.empty()) line(depth_name, depths, depth_texts, {rows});
    if (!lat_flags.empty())
      writer.variable({.name = og1 ? "LATITUDE_QC" : "lat_qc",
                       .dimensions = {rows},
                       .values = lat_flags,
                       .texts = {{"flag_meanings", "no_qc good_data probably_good bad_correctable bad_data"}},
                       .numbers = {},
                       .fill = std::nullopt,
                       .type = Type::int16,
                       .lists = {{"flag_values", {0, 1, 2, 3, 4}}}});
    writer.text(og1 ? "TRAJECTORY" : "trajectory", trajectory);
    writer.attribute("id", trajectory);
    const auto along = east.size() > 1 ? std::vector{rows} : std::vector<std::string>{};
    const auto texts_of = [&](const std::string& says) {
      auto texts = current_texts;
      if (!says.empty()) texts["standard_name"] = says;
      return texts;
    };
    line(og1 ? "WATERCURRENTS_U" : "u", east, texts_of(first_says), along);
    line(og1 ? "WATERCURRENTS_V" : "v", north, texts_of(second_says), along);
    if (og1) return;
    line("profile_id", {1}, {}, {});
    line("time_uv", {current_time}, seconds, {});
    line("lat_uv", {69.0015}, {{"units", "degrees_north"}}, {});
    line("lon_uv", {-52.0015}, {{"units", "degrees_east"}}, {});
  }
};

class GliderNetcdf : public StoreFixture {
 protected:
  IngestReport ingest_one(const GliderFile& file) {
    file.write(path("glider.nc"));
    return ingest(path("glider.nc"));
  }

  /// The only track that is stored.
  ocean::GliderTrack stored() {
    const repository::GliderTrackRepository tracks{db_};
    const auto page = tracks.list({}, 0, 2);
    EXPECT_EQ(page.tracks.size(), 1U);
    return page.tracks.empty() ? ocean::GliderTrack{} : tracks.find(page.tracks[0].row)->track;
  }

  ocean::GliderTrack track_of(const GliderFile& file) {
    const auto report = ingest_one(file);
    EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
    warnings_ = words(report);
    return stored();
  }

  std::string warnings_;
};

/// The only message says that the currents are in the frame that the file states.
const auto only_of_frame =
    testing::MatchesRegex("\n?[^\n]*true east and north, as the file states them[^\n]*\n?");

void expect_current(const ocean::DepthAveragedCurrent& found, double east_m_s, double north_m_s) {
  EXPECT_NEAR(found.current.east.value, east_m_s, 1e-9);
  EXPECT_NEAR(found.current.north.value, north_m_s, 1e-9);
}

TEST_F(GliderNetcdf, OfTheIoosCenterGivesPointsAndTheCurrentOfItsProfile) {
  const auto track = track_of({});

  EXPECT_EQ(track.glider, "amadeus-20260501T0000");
  ASSERT_EQ(track.points.size(), 3U);
  EXPECT_EQ(track.points[1].place, (geo::LonLat{-52.001, 69.001}));
  EXPECT_EQ(track.points[1].depth, core::Metres{80.0});
  EXPECT_EQ(core::unix_seconds(track.points[2].time), start_s + 120.0);
  ASSERT_EQ(track.currents.size(), 1U);
  expect_current(track.currents[0], 0.2, -0.1);
  EXPECT_EQ(core::unix_seconds(track.currents[0].time), start_s + 90.0);
  EXPECT_EQ(track.currents[0].place, (geo::LonLat{-52.0015, 69.0015}));
  EXPECT_EQ(track.frame, ocean::CurrentFrame::stated);
  EXPECT_FALSE(track.turned_from);
  EXPECT_THAT(warnings_, only_of_frame);
}

TEST_F(GliderNetcdf, TakesComponentsForWhatTheySayThatTheyAre) {
  const std::string eastward = "barotropic_eastward_sea_water_velocity";
  const std::string northward = "barotropic_northward_sea_water_velocity";
  expect_current(track_of({.first_says = eastward, .second_says = northward}).currents.at(0), 0.2, -0.1);
  db_ = repository::open_store_in_memory();
  expect_current(track_of({.first_says = northward, .second_says = eastward}).currents.at(0), -0.1, 0.2);
  db_ = repository::open_store_in_memory();
  EXPECT_TRUE(track_of({.first_says = northward, .second_says = northward}).currents.empty());
  EXPECT_THAT(warnings_, HasSubstr("the same component"));
}

TEST_F(GliderNetcdf, IsListedWithItsPeriodItsAreaAndItsVariables) {
  const auto report = ingest_one({});

  ASSERT_TRUE(report.dataset) << words(report);
  EXPECT_THAT(report.dataset->id.value, testing::StartsWith("glider-tracks-"));
  EXPECT_EQ(report.dataset->variables, (std::vector<std::string>{"time", "lat", "lon", "depth", "u", "v"}));
  EXPECT_EQ(report.dataset->bounds, (geo::BoundingBox{-52.002, 69.0, -52.0, 69.002}));
  EXPECT_EQ(report.dataset->rows_accepted, 3);
  EXPECT_EQ(ingest(path("glider.nc")).status, IngestStatus::unchanged);
}

struct Unit {
  const char* name;
  bool og1;
  double factor;  // 0: the current is left out
};

class GliderNetcdfUnit : public GliderNetcdf, public testing::WithParamInterface<Unit> {};

TEST_P(GliderNetcdfUnit, IsReadAsItIsStatedOrTheCurrentIsLeftOut) {
  const Unit unit = GetParam();
  GliderFile file{.og1 = unit.og1, .east = {2.5}, .north = {-1.25}, .current_texts = {}};
  if (*unit.name != '\0') file.current_texts["units"] = unit.name;

  const auto track = track_of(file);

  EXPECT_EQ(track.points.size(), 3U);
  ASSERT_EQ(track.currents.size(), unit.factor > 0.0 ? 1U : 0U) << warnings_;
  if (unit.factor > 0.0) {
    expect_current(track.currents[0], 2.5 * unit.factor, -1.25 * unit.factor);
    EXPECT_THAT(warnings_, only_of_frame);
  } else {
    EXPECT_THAT(warnings_, HasSubstr("left out"));
  }
}

INSTANTIATE_TEST_SUITE_P(All, GliderNetcdfUnit,
                         testing::Values(Unit{"m s-1", false, 1.0}, Unit{"m.s-1", false, 1.0},
                                         Unit{"cm s-1", false, 0.01}, Unit{"", false, 0.0},
                                         Unit{"1", false, 0.0}, Unit{"m s-1", true, 1.0},
                                         Unit{"cm/s", true, 0.01}, Unit{"cm s-1", true, 0.01},
                                         Unit{"", true, 0.0}, Unit{"degrees", true, 0.0}));

TEST_F(GliderNetcdf, OfOg1RepeatsTheCurrentOfADiveFromRowToRow) {
  GliderFile file{.og1 = true, .depth_name = "DEPTH"};
  file.times.clear();
  file.lats.clear();
  file.lons.clear();
  file.depths.clear();
  file.east.clear();
  file.north.clear();
  for (int i = 0; i < 40; ++i) {
    file.times.push_back(start_s + 60.0 * i);
    file.lats.push_back(69.0 + 1e-4 * i);
    file.lons.push_back(-52.0);
    file.depths.push_back(10.0 * (i % 10));
    file.east.push_back(i == 5 ? fill : (i < 20 ? 10.0 : -20.0));
    file.north.push_back(i == 5 ? fill : 5.0);
  }
  file.current_texts["units"] = "cm/s";

  const auto track = track_of(file);

  ASSERT_EQ(track.currents.size(), 2U) << warnings_;
  expect_current(track.currents[0], 0.1, 0.05);
  expect_current(track.currents[1], -0.2, 0.05);
  EXPECT_NEAR(core::unix_seconds(track.currents[0].time), start_s + 60.0 * 9.5, 1e-3);
  EXPECT_NEAR(track.currents[0].place.lat_deg, 69.0 + 9.5e-4, 1e-9);
}

TEST_F(GliderNetcdf, LeavesOutAFixThatItsFlagsCallBad) {
  GliderFile file;
  file.lats[1] = 12.0;
  file.lat_flags = {1, 4, 2};

  const auto track = track_of(file);

  // The depth was measured all the same, between the two good fixes.
  ASSERT_EQ(track.points.size(), 3U);
  EXPECT_NEAR(track.points[1].place.lat_deg, 69.001, 1e-12);
  EXPECT_FALSE(track.points[1].fixed);
  EXPECT_TRUE(track.points[2].fixed);
}

TEST_F(GliderNetcdf, ThatNamesAVehiclesSensorAsTheSourceOfItsCurrentsIsDoubted) {
  const auto track = track_of({.current_texts = {{"units", "m s-1"}, {"source", "m_final_water_vx"}}});

  ASSERT_EQ(track.currents.size(), 1U);
  expect_current(track.currents[0], 0.2, -0.1);
  EXPECT_THAT(warnings_, HasSubstr("m_final_water_vx as its source"));
}

TEST_F(GliderNetcdf, HasNoCurrentWhereItIsTheFill) {
  EXPECT_TRUE(track_of({.east = {fill}, .north = {fill}}).currents.empty());
  EXPECT_EQ(warnings_, "");
}

TEST_F(GliderNetcdf, LeavesOutACurrentOfExactlyNothingAndSaysSo) {
  EXPECT_TRUE(track_of({.east = {0.0}, .north = {0.0}}).currents.empty());
  EXPECT_THAT(warnings_, HasSubstr("exactly 0"));
}

TEST_F(GliderNetcdf, LeavesOutACurrentThatNoSeaHas) {
  EXPECT_TRUE(track_of({.east = {12.0}, .north = {0.0}}).currents.empty());
  EXPECT_THAT(warnings_, HasSubstr("over 10 m/s"));
}

TEST_F(GliderNetcdf, PutsACurrentWithoutATimeInTheMiddleOfItsRows) {
  const auto track = track_of({.current_time = fill});

  ASSERT_EQ(track.currents.size(), 1U);
  EXPECT_EQ(core::unix_seconds(track.currents[0].time), start_s + 60.0);
}

TEST_F(GliderNetcdf, TakesDepthsThatCountUpwards) {
  const auto track =
      track_of({.depths = {-0.5, -80.0, -160.0}, .depth_texts = {{"units", "m"}, {"positive", "up"}}});

  EXPECT_EQ(track.points[2].depth, core::Metres{160.0});
}

TEST_F(GliderNetcdf, TurnsPressureIntoDepth) {
  const auto track = track_of({.lats = {30.0, 30.0, 30.0},
                               .depths = {0.0, 500.0, 1000.0},
                               .depth_name = "pressure",
                               .depth_texts = {{"units", "dbar"}}});

  // UNESCO 1983, Technical papers in marine science 44, table of depths at 30 degrees: 496.00 and 990.57 m, which the
  // polynomial follows within 0.2 m.
  EXPECT_NEAR(track.points[1].depth->value, 496.00, 0.3);
  EXPECT_NEAR(track.points[2].depth->value, 990.57, 0.3);
}

TEST_F(GliderNetcdf, LeavesOutADepthWithoutAUnitAndSaysSo) {
  const auto track = track_of({.depth_texts = {}});

  EXPECT_FALSE(track.points[2].depth);
  EXPECT_THAT(warnings_, HasSubstr("unit of length"));
}

TEST_F(GliderNetcdf, LeavesOutPlacesAndDepthsThatCannotBe) {
  GliderFile file;
  file.lats = {69.0, 95.0, 69.002};
  file.depths = {0.5, 80.0, 15'000.0};

  const auto track = track_of(file);

  ASSERT_EQ(track.points.size(), 3U);
  EXPECT_FALSE(track.points[1].fixed);
  EXPECT_FALSE(track.points[2].depth);
  EXPECT_THAT(warnings_, HasSubstr("not on the globe"));
  EXPECT_THAT(warnings_, HasSubstr("12000 m"));
}

TEST_F(GliderNetcdf, FlagsASpeedThatNoGliderHas) {
  GliderFile file;
  file.lats[1] = 69.5;

  static_cast<void>(track_of(file));

  EXPECT_THAT(warnings_, HasSubstr("speed over ground exceeds 10 m/s"));
}

TEST_F(GliderNetcdf, PutsTimesThatDoNotAscendIntoOrder) {
  const auto track = track_of({.times = {start_s + 120.0, start_s + 60.0, start_s}});

  EXPECT_EQ(core::unix_seconds(track.points[0].time), start_s);
  EXPECT_EQ(track.points[0].depth, core::Metres{160.0});
  EXPECT_THAT(warnings_, HasSubstr("did not always rise"));
}

TEST_F(GliderNetcdf, GivenTogetherIsOneTrackInAnyOrder) {
  GliderFile first;
  GliderFile second{.times = {start_s + 600.0, start_s + 660.0, start_s + 720.0}};
  second.current_time = start_s + 650.0;
  GliderFile other{.trajectory = "comet-20260501T0000"};
  first.write(path("profile_1.nc"));
  second.write(path("profile_2.nc"));
  other.write(path("other.nc"));

  const auto reports = ingest_all_together({path("profile_2.nc"), path("other.nc"), path("profile_1.nc")});

  ASSERT_EQ(reports.size(), 2U);
  EXPECT_EQ(reports[0].file, "profile_1.nc + profile_2.nc");
  const auto page = repository::GliderTrackRepository{db_}.list({.glider = first.trajectory}, 0, 5);
  ASSERT_EQ(page.tracks.size(), 1U);
  EXPECT_EQ(page.tracks[0].point_count, 6);
  EXPECT_EQ(page.tracks[0].current_count, 2);
  const auto again = ingest_all_together({path("profile_1.nc"), path("profile_2.nc")});
  EXPECT_EQ(again.at(0).status, IngestStatus::unchanged);
}

TEST_F(GliderNetcdf, WithoutAPositionIsRefused) {
  GliderFile file;
  file.lats = {fill, fill, fill};
  file.write(path("glider.nc"));

  expect_refused(path("glider.nc"), "no position");
}

TEST_F(GliderNetcdf, WithoutAReferenceOfItsTimesIsRefused) {
  NetcdfWriter writer{path("glider.nc")};
  writer.axis("time", {1, 2}, {{"units", "seconds"}});
  for (const char* name : {"lat", "lon"})
    writer.variable({.name = name,
                     .dimensions = {"time"},
                     .values = {60, 61},
                     .texts = {},
                     .numbers = {},
                     .fill = std::nullopt,
                     .type = Type::float64});
  writer.text("TRAJECTORY", "amadeus");

  expect_refused(path("glider.nc"), "seconds");
}

}  // namespace
}  // namespace floeplan::ingest::glider_netcdf_test
