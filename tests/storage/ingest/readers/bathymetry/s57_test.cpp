#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::s57_test {
namespace {

using testing::HasSubstr;

/// US4MD81M, a chart of Chesapeake Bay at 1:80 000 with three updates. Expected values are those that ogrinfo 3.6.2
/// prints of its objects.
class ElectronicChart : public StoreFixture {
 protected:
  void SetUp() override {
    if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  }

  /// Copies parts of the chart into the test's folder; the path of the base cell.
  std::filesystem::path chart_with(const std::vector<std::string>& endings) const {
    for (const std::string& ending : endings)
      std::filesystem::copy_file(sample_folder() / "bathymetry/s57" / ("US4MD81M" + ending),
                                 path("US4MD81M" + ending));
    return path("US4MD81M.000");
  }

  ocean::Bathymetry around(const IngestReport& report, geo::LonLat place) {
    return repository::FieldRepository{db_}
        .load_bathymetry(report.dataset->id, {place.lon_deg, place.lat_deg, place.lon_deg, place.lat_deg})
        .value();
  }
};

TEST_F(ElectronicChart, GivesTheMiddleOfADepthAreaAndItsLeastDepthBesideIt) {
  const auto report = ingest(sample_folder() / "bathymetry/s57/US4MD81M.000");

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_THAT(words(report), HasSubstr("3 updates were applied"));
  EXPECT_THAT(words(report), HasSubstr("sounding datum"));
  struct Area {
    geo::LonLat place;
    double least_m;
    double most_m;
  };
  // DRVAL1 and DRVAL2 of the largest areas, at points within them
  for (const Area& area : {Area{{-76.45262, 38.70019}, 10.9, 18.2}, Area{{-76.48410, 38.70020}, 9.1, 10.9},
                           Area{{-76.43041, 38.70041}, 18.2, 36.5}, Area{{-76.30440, 38.53766}, 5.4, 9.1}}) {
    const auto chart = around(report, area.place);
    EXPECT_NEAR(chart.depth(area.place)->value, 0.5 * (area.least_m + area.most_m), 1e-4);
    EXPECT_LE(chart.shoalest(area.place)->value, area.least_m + 1e-4);
  }
}

TEST_F(ElectronicChart, IsNoDeeperThanItsSoundingsAndDangers) {
  const auto report = ingest(sample_folder() / "bathymetry/s57/US4MD81M.000");

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  struct Sounding {
    geo::LonLat place;
    double depth_m;
  };
  for (const Sounding& sounding :
       {Sounding{{-76.4662988, 38.5146442}, 10.9}, Sounding{{-76.39135, 38.8813853}, 23.7},
        Sounding{{-76.3041025, 38.8403773}, 4.5}, Sounding{{-76.258897, 38.8719297}, 3.9},
        Sounding{{-76.1540342, 38.8885625}, 2.4}, Sounding{{-76.3097835, 38.7522999}, 0.9}})
    EXPECT_LE(around(report, sounding.place).shoalest(sounding.place)->value, sounding.depth_m + 1e-4);
  EXPECT_THAT(words(report), HasSubstr("state no depth"));
}

TEST_F(ElectronicChart, KnowsLandAndNothingOutsideItsCoverage) {
  const auto report = ingest(sample_folder() / "bathymetry/s57/US4MD81M.000");

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const geo::LonLat on_land{-76.07875, 38.82180};  // within the largest LNDARE
  EXPECT_EQ(around(report, on_land).depth(on_land)->value, 0.0);
  EXPECT_FALSE(repository::FieldRepository{db_}
                   .load_bathymetry(report.dataset->id, {-76.62, 39.045, -76.61, 39.05})
                   .has_value());
}

TEST_F(ElectronicChart, IsReadWithoutUpdatesAndSaysSo) {
  const auto report = ingest(chart_with({".000"}));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_THAT(words(report), HasSubstr("no update files"));
}

TEST_F(ElectronicChart, IsAnotherDatasetOnceAnUpdateHasCome) {
  const auto before = ingest(chart_with({".000", ".001"}));
  const auto after = ingest(chart_with({".002"}));

  EXPECT_EQ(after.status, IngestStatus::stored) << words(after);
  EXPECT_NE(before.dataset->id, after.dataset->id);
}

TEST_F(ElectronicChart, IsGivenTogetherWithItsUpdates) {
  const auto base = chart_with({".000", ".001", ".002", ".003"});
  auto files = std::vector{path("US4MD81M.002"), base, path("US4MD81M.001"), path("US4MD81M.003")};

  const auto report = ingest_together(files);

  EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
}

TEST_F(ElectronicChart, IsRefusedWhereAnUpdateIsMissing) {
  expect_refused(chart_with({".000", ".001", ".003"}), "update 2 is missing");
}

TEST_F(ElectronicChart, IsRefusedWhereAnUpdatePosesAsTheChart) {
  std::filesystem::copy_file(sample_folder() / "bathymetry/s57/US4MD81M.001", path("POSES.000"));

  expect_refused(path("POSES.000"), "is an update of a chart");
}

TEST_F(ElectronicChart, IsRefusedWhenCutShort) {
  const auto base = chart_with({".000"});
  const auto size = std::filesystem::file_size(base);
  for (std::uintmax_t share = 19; share > 0; --share) {
    std::filesystem::resize_file(base, size * share / 20);
    expect_refused(base, "cut short");
  }
}

/// The last record of the cell is 174 octets long; without it every record that is left is whole.
TEST_F(ElectronicChart, IsRefusedWhenItsLastRecordIsMissing) {
  const auto base = chart_with({".000"});
  std::filesystem::resize_file(base, std::filesystem::file_size(base) - 174);

  expect_refused(base, "counts 21998 records but has only 21997");
}

TEST_F(ElectronicChart, IsRefusedWhenALeastDepthIsImpossible) {
  const auto base = chart_with({".000"});
  std::ifstream in{base, std::ios::binary};
  std::string bytes{std::istreambuf_iterator<char>{in}, {}};
  const std::string end_of_value = "\x1f";
  for (std::size_t at = 0; (at = bytes.find("10.9" + end_of_value, at)) != std::string::npos; ++at)
    bytes.replace(at, 4, "-9e9");

  expect_refused(write_file("US4MD81M.000", bytes), "m high");
}

TEST_F(ElectronicChart, IsRefusedWhenAnUpdateIsCutShort) {
  const auto base = chart_with({".000", ".001"});
  std::filesystem::resize_file(path("US4MD81M.001"), 9000);

  expect_refused(base, "US4MD81M.001");
}

}  // namespace
}  // namespace floeplan::ingest::s57_test
