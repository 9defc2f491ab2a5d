#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "engine/core/utc_text.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::zarr_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A Zarr store of version 2 written by hand: sea ice of one day, 2 latitudes by 3 longitudes, packed.
class ZarrStoreFile : public StoreFixture {
 protected:
  void text(const std::string& name, const std::string& content) const {
    fs::create_directories(path("ice.zarr/" + name).parent_path());
    std::ofstream{path("ice.zarr/" + name), std::ios::binary} << content;
  }

  template <class T>
  void chunk(const std::string& name, const std::vector<T>& values) const {
    text(name, std::string{reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
  }

  void array(const std::string& name, const std::string& shape, const std::string& type,
             const std::string& fill, const std::string& attributes) const {
    text(name + "/.zarray", R"({"zarr_format":2,"shape":)" + shape + R"(,"chunks":)" + shape +
                                R"(,"dtype":")" + type + R"(","compressor":null,"fill_value":)" + fill +
                                R"(,"filters":null,"order":"C"})");
    text(name + "/.zattrs", attributes);
  }

  void write() const {
    text(".zgroup", R"({"zarr_format":2})");
    array("time", "[1]", "<f8", "null", R"({"_ARRAY_DIMENSIONS":["time"],"units":"hours since 1950-01-01"})");
    chunk<double>("time/0", {622584.0});
    array("latitude", "[2]", "<f8", "null", R"({"_ARRAY_DIMENSIONS":["latitude"],"units":"degrees_north"})");
    chunk<double>("latitude/0", {-70.0, -69.0});
    array("longitude", "[3]", "<f8", "null", R"({"_ARRAY_DIMENSIONS":["longitude"],"units":"degrees_east"})");
    chunk<double>("longitude/0", {-55.0, -54.0, -53.0});
    array("siconc", "[1,2,3]", "<i2", "-32767",
          R"({"_ARRAY_DIMENSIONS":["time","latitude","longitude"],"standard_name":"sea_ice_area_fraction",)"
          R"("units":"1","scale_factor":0.001,"add_offset":-0.001})");
    chunk<std::int16_t>("siconc/0.0.0", {1, 101, -32767, 501, 901, 1001});
  }
};

TEST_F(ZarrStoreFile, IsUnpackedAndItsFillIsMissing) {
  write();

  const IngestReport report = ingest(path("ice.zarr"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(report.dataset->kind, repository::DatasetKind::ice);
  EXPECT_EQ(core::iso8601(*report.dataset->time_start), "2021-01-09T00:00:00Z");
  EXPECT_GT(report.dataset->provenance.file_size_bytes, 0);
  const auto field =
      repository::FieldRepository{db_}.load_ice(report.dataset->id, {-56.0, -71.0, -52.0, -68.0}, {});
  ASSERT_TRUE(field);
  EXPECT_NEAR(field->at({-54.0, -70.0}, *report.dataset->time_start)->concentration, 0.1, 1e-6);
  EXPECT_FALSE(field->at({-53.0, -70.0}, *report.dataset->time_start));
  EXPECT_NEAR(field->at({-53.0, -69.0}, *report.dataset->time_start)->concentration, 1.0, 1e-6);
}

TEST_F(ZarrStoreFile, IsUnchangedWhenGivenAgainAndAnotherWhenAByteDiffers) {
  write();
  EXPECT_EQ(ingest(path("ice.zarr")).status, IngestStatus::stored);
  EXPECT_EQ(ingest(path("ice.zarr")).status, IngestStatus::unchanged);
  chunk<std::int16_t>("siconc/0.0.0", {2, 101, -32767, 501, 901, 1001});
  EXPECT_EQ(ingest(path("ice.zarr")).status, IngestStatus::stored);
}

TEST_F(ZarrStoreFile, WhoseChunkWasCutShortIsRefused) {
  write();
  chunk<std::int16_t>("siconc/0.0.0", {1, 101});
  expect_refused(path("ice.zarr"), "damaged");
}

TEST_F(ZarrStoreFile, ThatWouldUnpackToGigabytesIsRefused) {
  write();
  array("siconc", "[1,100000,100000]", "<i2", "-32767", "{}");
  expect_refused(path("ice.zarr"), "chunks over 256 MB");
}

TEST_F(ZarrStoreFile, WithoutMostOfItsChunksIsRefused) {
  write();
  text("siconc/.zarray",
       R"({"zarr_format":2,"shape":[1000,2,3],"chunks":[1,2,3],"dtype":"<i2","compressor":null,)"
       R"("fill_value":-32767,"filters":null,"order":"C"})");
  expect_refused(path("ice.zarr"), "needs 1000 chunks");
}

TEST_F(ZarrStoreFile, WithALinkIsRefused) {
  write();
  fs::create_symlink("/etc/hostname", path("ice.zarr/siconc/0.0.1"));
  expect_refused(path("ice.zarr"), "without links");
}

TEST_F(ZarrStoreFile, WithADamagedDescriptionIsRefused) {
  write();
  text("siconc/.zarray", R"({"zarr_format":2,"shape":[1,2)");
  expect_refused(path("ice.zarr"), "has no shape");
}

TEST_F(ZarrStoreFile, OfTheRealSampleHoldsWhatAnotherReaderFinds) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";

  const IngestReport report = ingest(sample_folder() / "seaice/sic_daily_sample.zarr");

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(core::iso8601(*report.dataset->time_start), "2021-01-09T00:00:00Z");
  // Packed values by gdallocationinfo: 23525 at node 1500, 100 and 10676 at 2000, 120; the fill at 1700, 30.
  const double step = 3.814813680946827e-05;
  const auto value = [&](std::size_t x, std::size_t y) {
    const geo::LonLat node{-180.0 + static_cast<double>(x) / 12.0, -80.0 + static_cast<double>(y) / 12.0};
    const auto field = repository::FieldRepository{db_}.load_ice(
        report.dataset->id,
        {node.lon_deg - 0.01, node.lat_deg - 0.01, node.lon_deg + 0.01, node.lat_deg + 0.01}, {});
    const auto state = field->at(node, *report.dataset->time_start);
    return state ? state->concentration : -1.0;
  };
  EXPECT_NEAR(value(1500, 100), 23524 * step, 1e-4);
  EXPECT_NEAR(value(2000, 120), 10675 * step, 1e-4);
  EXPECT_EQ(value(1700, 30), -1.0);
}

}  // namespace
}  // namespace floeplan::ingest::zarr_test
