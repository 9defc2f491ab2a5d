#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <numbers>
#include <random>

#include "engine/core/utc_text.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/s100_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::s111_test {
namespace {

using testing::HasSubstr;

constexpr float fill = -9999.0F;
constexpr double knot_m_s = 1852.0 / 3600.0;

/// 0.5 to 3 knots, towards every quarter of the compass.
std::pair<float, float> turning(std::size_t column, std::size_t row, std::size_t time) {
  const auto node = static_cast<float>(column + 3 * row);
  return {0.5F * (1.0F + node), 60.0F * node + 15.0F * static_cast<float>(time)};
}

class S111 : public StoreFixture {
 protected:
  ocean::CurrentGrid stored(const std::filesystem::path& file) {
    report_ = ingest(file);
    return currents_of(report_);
  }

  IngestReport report_;
  int file_{};
};

TEST_F(S111, IsStoredAsComponentsInMetresPerSecondTowardsWhereTheDirectionPoints) {
  const ocean::CurrentGrid currents = stored(s111_sample(turning).write(path("111.h5")));
  const auto& samples = currents.samples();
  ASSERT_EQ(samples.u.size(), 12U);
  for (std::size_t time = 0; time < 2; ++time) {
    for (std::size_t node = 0; node < 6; ++node) {
      const auto [speed, direction] = turning(node % 3, node / 3, time);
      const double towards = static_cast<double>(direction) * std::numbers::pi / 180.0;
      EXPECT_NEAR(samples.u[6 * time + node], knot_m_s * static_cast<double>(speed) * std::sin(towards),
                  1e-6);
      EXPECT_NEAR(samples.v[6 * time + node], knot_m_s * static_cast<double>(speed) * std::cos(towards),
                  1e-6);
    }
  }
  EXPECT_EQ(core::iso8601(core::from_unix_seconds(samples.times_s.front())), "2026-01-11T00:00:00Z");
  EXPECT_EQ(core::iso8601(core::from_unix_seconds(samples.times_s.back())), "2026-01-11T00:20:00Z");
}

TEST_F(S111, LiesInTheMiddleOfTheCellsThatItsOriginIsACornerOf) {
  const ocean::HorizontalGrid in_cells = stored(s111_sample(turning).write(path("5.h5"))).samples().grid;
  EXPECT_NEAR(in_cells.place(0, 0).lon_deg, -50.0, 1e-9);
  EXPECT_NEAR(in_cells.place(2, 1).lon_deg, -49.8, 1e-9);
  EXPECT_NEAR(in_cells.place(2, 1).lat_deg, 47.1, 1e-9);

  S100Sample at_corners = s111_sample(turning);
  at_corners.feature_numbers.erase("dataOffsetCode");
  const ocean::HorizontalGrid on_nodes = stored(at_corners.write(path("1.h5"))).samples().grid;
  EXPECT_NEAR(on_nodes.place(0, 0).lon_deg, -50.05, 1e-9);
  EXPECT_NEAR(on_nodes.place(0, 0).lat_deg, 46.95, 1e-9);
}

TEST_F(S111, HasNoCurrentWhereEitherValueIsMissingButStillWaterWithoutADirection) {
  const auto current = [](std::size_t column, std::size_t row, std::size_t /*time*/) {
    if (row == 1) return std::pair{1.0F, 90.0F};
    if (column == 0) return std::pair{fill, 90.0F};
    return column == 1 ? std::pair{1.0F, fill} : std::pair{0.0F, fill};
  };
  const auto samples = stored(s111_sample(current).write(path("111.h5"))).samples();
  EXPECT_TRUE(std::isnan(samples.u[0]));
  EXPECT_TRUE(std::isnan(samples.u[1]));
  EXPECT_EQ(samples.u[2], 0.0F);
  EXPECT_EQ(samples.v[2], 0.0F);
  EXPECT_NEAR(samples.u[3], knot_m_s, 1e-6);
}

TEST_F(S111, IsAtTheDepthThatTheFileSays) {
  const auto depth_m = [&](const std::string& product, double type, double datum, double stated_m) {
    S100Sample sample = s111_sample(turning);
    sample.product = product;
    sample.file_numbers["depthTypeIndex"] = type;
    sample.file_numbers["verticalDatum"] = datum;
    sample.file_numbers["surfaceCurrentDepth"] = stated_m;
    return stored(sample.write(path(std::to_string(++file_) + ".h5"))).samples().depths_m->front();
  };
  constexpr const char* today = "INT.IHO.S-111.2.0";
  constexpr const char* before_1_2 = "INT.IHO.S-111.1.0";
  EXPECT_EQ(depth_m(today, 1.0, 48.0, -4.5), 4.5);
  EXPECT_TRUE(report_.warnings.empty()) << words(report_);
  EXPECT_EQ(depth_m(today, 2.0, 48.0, 4.0), 2.0);
  EXPECT_THAT(words(report_), HasSubstr("means over the uppermost 4 m"));
  EXPECT_EQ(depth_m(today, 1.0, 23.0, 5.0), 5.0);
  EXPECT_THAT(words(report_), HasSubstr("counts from the chart datum"));
  EXPECT_EQ(depth_m(before_1_2, 1.0, 23.0, 10.0), 5.0);
  EXPECT_EQ(depth_m(before_1_2, 2.0, 23.0, -4.6), 4.6);
  EXPECT_EQ(depth_m("INT.IHO.S-111", 1.0, 48.0, -4.5), 4.5) << "without an edition as today";
}

TEST_F(S111, AboveTheSeaBedIsRefused) {
  S100Sample sample = s111_sample(turning);
  sample.file_numbers["verticalDatum"] = 47.0;
  expect_refused(sample.write(path("bed.h5")), "counts neither from the surface");
  sample.product = "INT.IHO.S-111.1.0";
  sample.file_numbers["depthTypeIndex"] = 4.0;
  expect_refused(sample.write(path("older.h5")), "counts neither from the surface");
}

TEST_F(S111, InTransverseMercatorKeepsItsNodes) {
  S100Sample sample = s111_sample(turning);
  sample.file_numbers["horizontalCRS"] = 32622.0;  // central meridian 51 degrees west
  sample.west = 500'000.0;
  sample.south = 5'200'000.0;
  sample.step = 1000.0;
  const auto samples = stored(sample.write(path("utm.h5"))).samples();
  EXPECT_GT(samples.grid.place(0, 0).lon_deg, -51.0);
  EXPECT_NEAR(samples.grid.place(0, 0).lon_deg, -50.9934, 1e-4);  // 500 m east of it
  EXPECT_NEAR(samples.u[0], knot_m_s * 0.5 * std::sin(0.0), 1e-6);
  EXPECT_NEAR(samples.v[0], knot_m_s * 0.5, 1e-6) << "towards true north, not along the grid";
}

TEST_F(S111, OfAnotherLayoutIsRefusedWithTheReason) {
  for (const auto& [code, reason] : {std::pair{1.0, "do not tell the water between"},
                                     {8.0, "do not tell the water between"},
                                     {4.0, "along the track of a moving platform"},
                                     {5.0, "an irregular grid"},
                                     {6.0, "cells of several sizes"},
                                     {12.0, "a layout that is not known"}}) {
    S100Sample sample = s111_sample(turning);
    sample.feature_numbers["dataCodingFormat"] = code;
    expect_refused(sample.write(path("layout.h5")), reason);
  }
}

TEST_F(S111, ThatCannotBePlacedInSpaceOrTimeIsRefused) {
  const auto refused = [&](const std::string& reason, const auto& change) {
    S100Sample sample = s111_sample(turning);
    change(sample);
    expect_refused(sample.write(path("bad.h5")), reason);
  };
  refused("has the unreadable time \"\"", [](S100Sample& s) { s.records[1].time = ""; });
  refused("has the unreadable time \"20261311T000000Z\"",
          [](S100Sample& s) { s.records[1].time = "20261311T000000Z"; });
  refused("announces 3 records, but has only 2", [](S100Sample& s) { s.announced_records = 3.0; });
  refused("2 areas of SurfaceCurrent", [](S100Sample& s) { s.areas = 2; });
  refused("runs in an order", [](S100Sample& s) { s.scan_direction = "latitude,longitude"; });
  refused("runs in an order", [](S100Sample& s) { s.feature_numbers["dataOffsetCode"] = 6.0; });
  refused("horizontalCRS", [](S100Sample& s) { s.file_numbers.erase("horizontalCRS"); });
  refused("EPSG:999999", [](S100Sample& s) { s.file_numbers["horizontalCRS"] = 999999.0; });
  refused("EPSG:27700", [](S100Sample& s) { s.file_numbers["horizontalCRS"] = 27700.0; });
  refused("unit \"degree\"", [](S100Sample& s) { s.values[0].unit = "degree"; });
  refused("where its grid lies", [](S100Sample& s) { s.step = 0.0; });
}

TEST_F(S111, OfRecordsOutOfOrderIsStoredByTime) {
  S100Sample sample = s111_sample(turning);
  std::swap(sample.records[0], sample.records[1]);
  const auto samples = stored(sample.write(path("111.h5"))).samples();
  EXPECT_NEAR(samples.v[0], knot_m_s * 0.5, 1e-6) << "of the earlier time, towards north";
  sample.records[1].time = sample.records[0].time;
  expect_refused(sample.write(path("twice.h5")), "timePoint");
}

/// Knots.
double speed_at(double lat_deg) { return 1.0 + 0.3 * (lat_deg - 83.5); }

/// Nodes of an Arctic ice-ocean model: a square grid of a polar stereographic plane, each node with a longitude and
/// a latitude of its own (data coding format 3), in an order that says nothing.
S100Sample scattered(std::size_t side, const std::function<bool(std::size_t, std::size_t)>& is_sea) {
  S100Sample sample = s111_sample(turning);
  sample.feature_numbers["dataCodingFormat"] = 3.0;
  sample.places.clear();
  constexpr double spacing_m = 5'000.0;
  constexpr double earth_m = 6'371'000.0;
  for (std::size_t row = 0; row < side; ++row)
    for (std::size_t column = 0; column < side; ++column) {
      if (!is_sea(column, row)) continue;
      const double x = 400'000.0 + spacing_m * static_cast<double>(column);
      const double y = -600'000.0 + spacing_m * static_cast<double>(row);
      const double colatitude = 2.0 * std::atan(std::hypot(x, y) / (2.0 * earth_m));
      sample.places.emplace_back(std::atan2(x, -y) * 180.0 / std::numbers::pi,
                                 90.0 - colatitude * 180.0 / std::numbers::pi);
    }
  std::ranges::shuffle(sample.places, std::mt19937_64{7});
  sample.rows = 1;
  sample.columns = sample.places.size();
  std::vector<float> speeds;
  for (const auto& [lon, lat] : sample.places) speeds.push_back(static_cast<float>(speed_at(lat)));
  for (S100Sample::Record& record : sample.records)  // towards the north-east everywhere
    record.values = {speeds, std::vector<float>(sample.columns, 45.0F)};
  return sample;
}

TEST_F(S111, AtPlacesOfTheirOwnKeepTheirValueAndDirectionBetweenThem) {
  const S100Sample sample = scattered(12, [](std::size_t, std::size_t) { return true; });
  const ocean::CurrentGrid currents = stored(sample.write(path("3.h5")));
  EXPECT_THAT(words(report_), HasSubstr("144 points (places of their own)"));
  std::size_t known = 0;
  for (const auto& [lon, lat] : sample.places) {
    const auto current =
        currents.at({lon, lat}, core::Metres{4.0}, core::from_unix_seconds(currents.samples().times_s[0]));
    if (!current) continue;  // at the edge
    ++known;
    EXPECT_NEAR(current->east.value, knot_m_s * speed_at(lat) * std::sqrt(0.5), 5e-4);
    EXPECT_NEAR(current->north.value, knot_m_s * speed_at(lat) * std::sqrt(0.5), 5e-4);
  }
  EXPECT_GT(known, sample.places.size() / 2);
}

TEST_F(S111, AtPlacesOfTheirOwnHaveNoCurrentWhereThereAreNoPlaces) {
  const auto is_sea = [](std::size_t column, std::size_t row) {
    return !(column >= 4 && column < 8 && row >= 4 && row < 8);
  };
  const S100Sample all = scattered(12, [](std::size_t, std::size_t) { return true; });
  const S100Sample sea = scattered(12, is_sea);
  const ocean::CurrentGrid currents = stored(sea.write(path("island.h5")));
  double lon = 0.0;
  double lat = 0.0;
  for (const auto& [each_lon, each_lat] : all.places) {
    lon += each_lon / static_cast<double>(all.places.size());
    lat += each_lat / static_cast<double>(all.places.size());
  }
  EXPECT_FALSE(
      currents.at({lon, lat}, core::Metres{4.0}, core::from_unix_seconds(currents.samples().times_s[0])))
      << "the middle of an island 20 km wide";
}

/// Six nodes, of which four make a mesh of two triangles whose sides differ by a factor of ten; the file leaves the water
/// between the others out.
S100Sample triangulated() {
  S100Sample sample = s111_sample(turning);
  sample.feature_numbers["dataCodingFormat"] = 7.0;
  sample.places = {{-50.0, 47.0}, {-49.0, 47.0}, {-49.0, 48.0}, {-48.9, 47.9}, {-48.0, 48.0}, {-48.0, 47.0}};
  sample.triangles = {{0, 1, 2}, {1, 3, 2}};
  sample.rows = 1;
  sample.columns = sample.places.size();
  for (S100Sample::Record& record : sample.records)  // towards the east
    record.values = {{1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F}, std::vector<float>(6, 90.0F)};
  return sample;
}

TEST_F(S111, OnATriangulatedMeshIsInterpolatedInItsTrianglesAlone) {
  const auto report = ingest(triangulated().write(path("7.h5")));
  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_THAT(words(report), HasSubstr("4 points (a triangulated mesh)"));
  const auto east_at = [&](geo::LonLat place) -> std::optional<double> {
    const auto here = repository::FieldRepository{db_}.load_currents(
        report.dataset->id, {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg}, std::nullopt,
        std::nullopt);
    if (!here) return std::nullopt;
    const auto current =
        here->at(place, core::Metres{4.0}, core::from_unix_seconds(here->samples().times_s.front()));
    if (!current) return std::nullopt;
    return current->east.value;
  };
  EXPECT_NEAR(east_at({-50.0, 47.0}).value(), 1.0 * knot_m_s, 1e-6) << "at a node its own";
  EXPECT_NEAR(east_at({-48.9, 47.9}).value(), 4.0 * knot_m_s, 1e-6);
  EXPECT_NEAR(east_at({-49.0, 47.5}).value(), 2.5 * knot_m_s, 2e-3) << "in the middle of a side";
  EXPECT_FALSE(east_at({-48.3, 47.6})) << "between nodes that no triangle joins";
}

TEST_F(S111, WithTrianglesOfPlacesThatDoNotExistIsRefused) {
  for (const int place : {6, -1}) {
    S100Sample sample = triangulated();
    sample.triangles[1][1] = place;
    expect_refused(sample.write(path("7.h5")), "has a corner at place " + std::to_string(place));
  }
}

TEST_F(S111, OnAMeshThatLeavesOutItsTrianglesIsReadAsPlacesOfTheirOwn) {
  S100Sample sample = scattered(12, [](std::size_t, std::size_t) { return true; });
  sample.feature_numbers["dataCodingFormat"] = 7.0;
  EXPECT_EQ(ingest(sample.write(path("7.h5"))).status, IngestStatus::stored);
}

TEST_F(S111, AtPlacesThatAreNoneIsRefused) {
  S100Sample sample = scattered(4, [](std::size_t, std::size_t) { return true; });
  sample.places[3] = {-999.0, 45.0};
  expect_refused(sample.write(path("a.h5")), "not on the Earth");
  sample = scattered(2, [](std::size_t, std::size_t row) { return row == 0; });
  expect_refused(sample.write(path("b.h5")), "enclose no area");
  sample = scattered(4, [](std::size_t, std::size_t) { return true; });
  sample.file_numbers["horizontalCRS"] = 32633.0;
  expect_refused(sample.write(path("d.h5")), "not given in longitude and latitude");
}

TEST_F(S111, WhosePartsAreSaidToLieBeyondTheirElementsIsRefused) {
  const auto file = scattered(4, [](std::size_t, std::size_t) { return true; }).write(path("3.h5"));
  std::ifstream in{file, std::ios::binary};
  std::string bytes{std::istreambuf_iterator<char>{in}, {}};
  const std::string name{"latitude\0\0\0\0\0\0\0\0",
                         16};  // as a compound type has it, before the place of the part
  const std::size_t at = bytes.find(name);
  ASSERT_NE(at, std::string::npos);
  bytes[at + name.size() + 2] = '\x7F';
  write_file("damaged.h5", bytes);
  expect_refused(path("damaged.h5"), "geometryValues");
}

/// S-111 1.0 and S-102 2.0 and 2.1 are of S-100 edition 4, which names the reference system otherwise.
TEST_F(S111, OfAnEarlierEditionStatesItsReferenceSystemInItsWay) {
  S100Sample sample = s111_sample(turning);
  sample.product = "INT.IHO.S-111.1.0";
  sample.file_numbers.erase("horizontalCRS");
  sample.file_numbers["depthTypeIndex"] = 2.0;
  sample.file_numbers["horizontalDatumValue"] = 4326.0;
  expect_refused(sample.write(path("nobody.h5")), "horizontalCRS");
  sample.file_texts["horizontalDatumReference"] = "EPSG";
  EXPECT_NEAR(stored(sample.write(path("epsg.h5"))).samples().grid.place(0, 0).lon_deg, -50.0, 1e-9);
}

/// Values as h5py 3 reads them: speed (knots) and direction of node [row][column] of a record, turned to components.
TEST_F(S111, OfTheIhoReadsAsAnIndependentReaderDoes) {
  const auto file = sample_folder() / "s100/111US00_Florida_Ovp_20260111_20260120.h5";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the sample file is not here";
  const auto samples = stored(file).samples();
  ASSERT_EQ(samples.grid.x().size(), 86U);
  ASSERT_EQ(samples.grid.y().size(), 108U);
  ASSERT_EQ(samples.times_s.size(), 720U);
  EXPECT_EQ(samples.depths_m->front(), 5.0);
  struct Golden {
    std::size_t record, row, column;
    double lon_deg, lat_deg, u_m_s, v_m_s;
  };
  for (const Golden& golden :
       {Golden{1, 10, 20, -80.15172755510001, 25.5291666669, 0.2589325792406745, 0.1262898571370892},
        Golden{37, 54, 70, -80.0128386651, 25.6513888901, 0.1017235122888374, 0.049613871966645885},
        Golden{300, 90, 60, -80.0406164431, 25.7513888909, -0.03699036747866877, -0.018041407682373594},
        Golden{720, 107, 85, -79.9711719981, 25.7986111135, 0.34678470286376195, 0.16913820080278572}}) {
    const geo::LonLat at = samples.grid.place(golden.column, golden.row);
    EXPECT_NEAR(at.lon_deg, golden.lon_deg, 1e-9);
    EXPECT_NEAR(at.lat_deg, golden.lat_deg, 1e-9);
    const std::size_t node = ((golden.record - 1) * 108 + golden.row) * 86 + golden.column;
    EXPECT_NEAR(samples.u[node], golden.u_m_s, 1e-6);
    EXPECT_NEAR(samples.v[node], golden.v_m_s, 1e-6);
  }
}

}  // namespace
}  // namespace floeplan::ingest::s111_test
