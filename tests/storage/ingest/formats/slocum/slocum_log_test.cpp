#include "storage/ingest/formats/slocum/slocum_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "storage/repository/features/glider_track_repository.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::slocum_log_test {
namespace {

using testing::HasSubstr;

const std::string header =
    "m_present_time,m_lat,m_lon,m_gps_lat,m_gps_lon,m_depth,x_dr_state,m_water_vx,m_water_vy,"
    "m_initial_water_vx,m_initial_water_vy,m_final_water_vx,m_final_water_vy\n"
    "timestamp,lat,lon,lat,lon,m,enum,m/s,m/s,m/s,m/s,m/s,m/s\n";

/// Dives with a current of an earlier one, comes up an hour later and estimates that of the dive.
const std::string dive =
    "1566395000,5418.9,724.6,5418.9,724.6,0.1,4,0.4,-0.1,0.4,-0.1,0.3,-0.2\n"
    "1566396000,5418.95,724.5,,,40,1,,,,,,\n"
    "1566399600,5419.0,724.4,69696969,69696969,0.2,2,,,,,,\n"
    "1566399700,5419.5,722,5419.5,722,0.1,3,-0.1,0.2,-0.1,0.2,,\n";

/// A log as the text that dbd2asc makes of a binary log.
std::string as_dba(const std::string& comma_separated, int segment) {
  std::string rows = comma_separated.substr(comma_separated.find("\n15") + 1);
  std::string names = header.substr(0, header.find('\n'));
  std::string text = "dbd_label: DBD_ASC(dinkum_binary_data_ascii)file\nencoding_ver: 2\nnum_ascii_tags: 4\n";
  text += "filename_extension: dbd\nfull_filename: comet-2019-222-2-" + std::to_string(segment) + "\n";
  const auto line = [&](std::string fields) {
    for (std::size_t at = 0; (at = fields.find(",,", at)) != std::string::npos;) fields.insert(at + 1, "NaN");
    if (fields.ends_with(',')) fields += "NaN";
    for (char& c : fields)
      if (c == ',') c = ' ';
    return fields + "\n";
  };
  text += line(names) + line(names) + "8 8 8 8 8 4 1 4 4 4 4 4 4\n";
  std::istringstream in{rows};
  for (std::string fields; std::getline(in, fields);) text += line(fields);
  return text;
}

/// In the German Bight the axes lie 1.025 degrees off true ones: turned by the convergence of proj 9, -1.309 degrees, and
/// the declination of pygeomag 1.1.0, 2.334 degrees east.
void expect_turned(geo::VelocityEn found, double x_m_s, double y_m_s) {
  const double off_rad = core::degrees_to_radians(1.0251);
  EXPECT_NEAR(found.east.value, x_m_s * std::cos(off_rad) + y_m_s * std::sin(off_rad), 1e-5);
  EXPECT_NEAR(found.north.value, y_m_s * std::cos(off_rad) - x_m_s * std::sin(off_rad), 1e-5);
}

class SlocumLogs : public StoreFixture {
 protected:
  ocean::GliderTrack stored() {
    const repository::GliderTrackRepository tracks{db_};
    const auto page = tracks.list({}, 0, 2);
    EXPECT_EQ(page.tracks.size(), 1U);
    return page.tracks.empty() ? ocean::GliderTrack{} : tracks.find(page.tracks[0].row)->track;
  }

  ocean::GliderTrack track_of(const std::string& text) {
    const auto report = ingest(write_file("log.csv", text));
    EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
    warnings_ = words(report);
    return stored();
  }

  std::string warnings_;
};

TEST_F(SlocumLogs, GiveFixesWhereThereAreAnyAndElseWhatTheVehicleReckons) {
  const auto track = track_of(header + dive);

  EXPECT_EQ(track.glider, "log");
  ASSERT_EQ(track.points.size(), 4U);
  EXPECT_TRUE(track.points[0].fixed);
  EXPECT_NEAR(track.points[0].place.lat_deg, 54.0 + 18.9 / 60.0, 1e-12);
  EXPECT_FALSE(track.points[1].fixed);
  EXPECT_NEAR(track.points[1].place.lon_deg, 7.0 + 24.5 / 60.0, 1e-12);
  EXPECT_EQ(track.points[1].depth, core::Metres{40.0});
  EXPECT_FALSE(track.points[2].fixed) << "69696969 is no fix";
  EXPECT_TRUE(track.points[3].fixed);
}

TEST_F(SlocumLogs, GiveADiveTheCurrentThatIsKnownAfterItNotTheOneItStartedWith) {
  const auto track = track_of(header + dive);

  ASSERT_EQ(track.currents.size(), 1U);
  expect_turned(track.currents[0].current, -0.1, 0.2);
  EXPECT_EQ(core::unix_seconds(track.currents[0].time), 0.5 * (1566396000.0 + 1566399600.0));
  EXPECT_NEAR(track.currents[0].place.lat_deg, 54.0 + 0.5 * (18.9 + 19.5) / 60.0, 1e-12);
}

TEST_F(SlocumLogs, GiveNoDiveWhatWasEstimatedBeforeIt) {
  const auto track = track_of(header +
                              "1566395000,5418.9,724.6,5418.9,724.6,0.1,3,0.4,-0.1,0.4,-0.1,0.3,-0.2\n"
                              "1566395100,5418.9,724.6,5418.9,724.6,0.1,4,0.5,-0.1,,,0.5,-0.1\n"
                              "1566396000,5418.95,724.5,,,40,1,,,,,,\n"
                              "1566399600,5419.0,724.4,5419.5,722,0.2,2,,,,,,\n");

  EXPECT_TRUE(track.currents.empty());
}

TEST_F(SlocumLogs, PreferTheFinalCurrentThatTheNextSegmentTells) {
  const auto first = write_file("a.dba", as_dba(header + dive, 9));
  const auto second =
      write_file("b.dba", as_dba(header + "1566400000,5419.5,722,5419.5,722,0.1,4,-0.12,0.21,-0.1,"
                                          "0.2,-0.12,0.21\n"
                                          "1566401000,5419.6,722,,,30,1,,,,,,\n",
                                 10));

  const auto report = ingest_together({second, first});

  EXPECT_EQ(report.file, "a.dba + b.dba") << words(report);
  const auto track = stored();
  EXPECT_EQ(track.glider, "comet");
  EXPECT_EQ(track.points.size(), 6U);
  ASSERT_EQ(track.currents.size(), 1U);
  expect_turned(track.currents[0].current, -0.12, 0.21);
}

TEST_F(SlocumLogs, AreToldApartByDepthWhereTheyHaveNoState) {
  const auto track = track_of(
      "m_present_time,m_gps_lat,m_gps_lon,m_depth,m_water_vx,m_water_vy\ntimestamp,lat,lon,m,m/s,m/s\n"
      "1566395000,5418.9,724.6,0.1,0.4,-0.1\n1566396000,,,40,,\n1566397000,,,2,,\n1566398000,,,45,,\n"
      "1566399600,,,0.2,,\n1566399700,5419.5,722,0.1,-0.1,0.2\n");

  ASSERT_EQ(track.currents.size(), 1U);
  expect_turned(track.currents[0].current, -0.1, 0.2);
  ASSERT_EQ(track.points.size(), 6U) << "depths between two fixes lie between them";
  EXPECT_FALSE(track.points[2].fixed);
}

TEST_F(SlocumLogs, LeaveOutALastLineThatHasNoEnd) {
  const std::string whole = header + dive;

  const auto track = track_of(whole.substr(0, whole.rfind("5419.5,722,0.1") + 4));

  EXPECT_EQ(track.points.size(), 3U);
  EXPECT_THAT(warnings_, HasSubstr("no line end"));
}

TEST_F(SlocumLogs, LeaveOutWhatTheVehicleReckonedFromWhereItWasSwitchedOff) {
  const auto track = track_of(header + "1566394900,5410.5,753.7,69696969,69696969,0.1,4,,,,,,\n" + dive);

  EXPECT_EQ(track.points.size(), 4U + 0U) << warnings_;
  EXPECT_THAT(warnings_, HasSubstr("before its first fix"));
}

/// One dive off Greenland in the notation and with the units of a converter.
std::string disko_dive(const std::string& unit_lat, const std::string& unit_lon, bool decimal) {
  const std::string lat = decimal ? "69.2" : "6912";
  const auto row = [&](const std::string& time, const std::string& lon, const std::string& rest) {
    return time + "," + lat + "," + lon + "," + lat + "," + lon + "," + rest + "\n";
  };
  const std::string from = decimal ? "-52.525" : "-5231.5";
  const std::string to = decimal ? "-52.5" : "-5230";
  return header.substr(0, header.find('\n')) + "\ntimestamp," + unit_lat + "," + unit_lon + "," + unit_lat +
         "," + unit_lon + ",m,enum,m/s,m/s,m/s,m/s,m/s,m/s\n" +
         row("1566395000", from, "0.1,4,0.4,-0.1,0.4,-0.1,0.3,-0.2") + row("1566396000", from, "40,1,,,,,,") +
         row("1566399600", to, "0.2,2,,,,,,") + row("1566399700", to, "0.1,3,-0.1,0.2,-0.1,0.2,,");
}

TEST_F(SlocumLogs, InDecimalDegreesLieWhereTheVehicleWas) {
  const auto own = track_of(disko_dive("lat", "lon", false));
  for (const auto& [unit_lat, unit_lon] :
       {std::pair{"lat", "lon"}, {"deg", "deg"}, {"degrees_north", "degrees_east"}}) {
    SCOPED_TRACE(unit_lat);
    db_ = repository::open_store_in_memory();
    std::filesystem::remove(path("log.csv"));
    const auto track = track_of(disko_dive(unit_lat, unit_lon, true));

    ASSERT_EQ(track.points.size(), own.points.size());
    EXPECT_NEAR(track.points[0].place.lat_deg, 69.2, 1e-9);
    EXPECT_NEAR(track.points[0].place.lon_deg, -52.525, 1e-9);
    ASSERT_EQ(track.currents.size(), 1U);
    EXPECT_NEAR(track.currents[0].current.east.value, own.currents[0].current.east.value, 1e-9);
    EXPECT_EQ(warnings_.find("were read as decimal degrees") != std::string::npos,
              std::string{"lat"} == unit_lat);
  }
}

TEST_F(SlocumLogs, WhoseNotationNothingTellsAreRefused) {
  expect_refused(
      write_file("log.csv", "m_present_time,m_gps_lat,m_gps_lon\ntimestamp,lat,lon\n1566394900,54.3,7.4\n"),
      "Write the unit ddmm or deg");
}

/// The NetCDF file is one that dbd2netcdf makes of binary logs.
TEST_F(SlocumLogs, AsNetcdfAreTheSameTrackAsTheirText) {
  const std::string text = disko_dive("lat", "lon", false);
  const auto own = track_of(text);
  db_ = repository::open_store_in_memory();
  std::istringstream lines{text};
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream fields{line + ","};
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(field);
  }
  {
    NetcdfWriter writer{path("log.nc")};
    writer.dimension("i", rows.size() - 2);
    for (std::size_t column = 0; column < rows[0].size(); ++column) {
      NetcdfWriter::Variable sensor{.name = rows[0][column],
                                    .dimensions = {"i"},
                                    .values = {},
                                    .texts = {{"units", rows[1][column]}},
                                    .numbers = {},
                                    .fill = {},
                                    .type = NetcdfWriter::Type::float64};
      for (std::size_t row = 2; row < rows.size(); ++row)
        sensor.values.push_back(rows[row][column].empty() ? std::nan("") : std::stod(rows[row][column]));
      writer.variable(sensor);
    }
  }

  const auto report = ingest(path("log.nc"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(report.dataset->kind, repository::DatasetKind::glider_tracks);
  const auto track = stored();
  ASSERT_EQ(track.points.size(), own.points.size());
  for (std::size_t i = 0; i < own.points.size(); ++i) EXPECT_EQ(track.points[i].place, own.points[i].place);
  ASSERT_EQ(track.currents.size(), own.currents.size());
  EXPECT_EQ(track.currents[0].current, own.currents[0].current);
}

TEST_F(SlocumLogs, WithoutPositionsAreRefused) {
  expect_refused(write_file("log.csv", "m_present_time,m_depth\ntimestamp,m\n1566394900,3\n"), "m_gps_lat");
}

TEST_F(SlocumLogs, WithARowThatIsNoneAreRefused) {
  expect_refused(write_file("log.csv", header + "1566394900,north\n"), "must be a number");
}

TEST_F(SlocumLogs, CutAnywhereAreRefusedOrLackOnlyTheirEnd) {
  const std::string whole = header + dive;
  for (std::size_t length = 0; length < whole.size(); length += 7) {
    const auto report = ingest(write_file("log.csv", whole.substr(0, length)));
    if (report.status == IngestStatus::refused) continue;
    const auto track = stored();
    for (const auto& point : track.points) {
      EXPECT_NEAR(point.place.lat_deg, 54.32, 0.02) << length;
      EXPECT_NEAR(point.place.lon_deg, 7.39, 0.03) << length;
    }
    sql::Connection empty = repository::open_store_in_memory();
    std::swap(db_, empty);
  }
}

}  // namespace
}  // namespace floeplan::ingest::slocum_log_test
