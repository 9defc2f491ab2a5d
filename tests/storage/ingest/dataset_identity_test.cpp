#include "storage/ingest/dataset_identity.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::dataset_identity_test {
namespace {

using repository::DatasetKind;
using testing::HasSubstr;
using testing::Not;

const std::string digest(64, 'a');

TEST(DatasetIdentity, WithoutOptionsIsTheDigestOfTheFile) {
  for (const DatasetKind kind :
       {DatasetKind::bathymetry, DatasetKind::currents, DatasetKind::ice, DatasetKind::tides})
    EXPECT_EQ(identity_of(digest, kind, {.name = "mine", .kind = kind, .archive = "all.zip"}), digest);
  EXPECT_EQ(id_of(DatasetKind::ice, digest, Keeping::on_a_grid).value, "ice-aaaaaaaa");
}

TEST(DatasetIdentity, ChangesWithEveryOptionThatTheKindUses) {
  const auto time = core::from_unix_seconds(1.7e9);
  const std::vector<std::pair<DatasetKind, IngestOptions>> uses{
      {DatasetKind::ice, {.unit = "percent"}},
      {DatasetKind::ice, {.unit = "share"}},
      {DatasetKind::ice, {.time = time}},
      {DatasetKind::ice, {.variable = "siconc"}},
      {DatasetKind::currents, {.time = time}},
      {DatasetKind::currents, {.variable = "uo"}},
      {DatasetKind::currents, {.missing = 0.1}},
      {DatasetKind::wind, {.missing = 0.1}},
      {DatasetKind::bathymetry, {.positive = "up"}},
      {DatasetKind::bathymetry, {.crs = "EPSG:3413"}},
      {DatasetKind::tides, {.at = geo::LonLat{-53.0, 69.0}}},
      {DatasetKind::tides, {.unit = "ft"}},
      {DatasetKind::zones, {.zone_kind = "no_go"}}};
  for (const auto& [kind, options] : uses)
    EXPECT_NE(identity_of(digest, kind, options), digest) << repository::kind_name(kind);
  EXPECT_NE(identity_of(digest, DatasetKind::ice, {.unit = "share"}),
            identity_of(digest, DatasetKind::ice, {.unit = "percent"}));
  EXPECT_NE(identity_of(digest, DatasetKind::currents, {.time = time}),
            identity_of(digest, DatasetKind::currents, {.time = time + core::Seconds{0.5}}));
}

TEST(DatasetIdentity, DoesNotChangeWithAnOptionOfAnotherKind) {
  EXPECT_EQ(identity_of(digest, DatasetKind::currents, {.positive = "up", .unit = "ft"}), digest);
  EXPECT_EQ(identity_of(digest, DatasetKind::icebergs, {.crs = "EPSG:3413"}), digest);
}

class SameFile : public StoreFixture {
 protected:
  /// Values without a unit that may be shares or percent.
  std::filesystem::path ice_without_a_unit() {
    NetcdfWriter writer{path("ice.nc")};
    writer.axis("time", {0.0}, {{"units", "hours since 2026-11-20 00:00:00"}});
    writer.axis("lat", {69.0, 70.0}, {{"units", "degrees_north"}});
    writer.axis("lon", {-54.0, -53.0}, {{"units", "degrees_east"}});
    writer.variable({.name = "siconc",
                     .dimensions = {"time", "lat", "lon"},
                     .values = {0.12, 0.12, 0.12, 0.12},
                     .texts = {{"standard_name", "sea_ice_area_fraction"}},
                     .numbers = {},
                     .fill = {}});
    return path("ice.nc");
  }

  float concentration_of(const IngestReport& report) {
    const auto ice = repository::FieldRepository{db_}.load_ice(report.dataset.value().id, {-54, 69, -53, 70},
                                                               std::nullopt);
    return ice.value().samples().concentration.front();
  }
};

TEST_F(SameFile, ReadWithAnotherUnitIsAnotherDataset) {
  const auto file = ice_without_a_unit();

  const auto as_percent = ingest(file, {.unit = "percent"});
  const auto as_shares = ingest(file, {.unit = "share"});
  const auto again = ingest(file, {.unit = "percent"});

  ASSERT_EQ(as_shares.status, IngestStatus::stored) << words(as_shares);
  EXPECT_FLOAT_EQ(concentration_of(as_percent), 0.0012F);
  EXPECT_FLOAT_EQ(concentration_of(as_shares), 0.12F);
  EXPECT_THAT(words(as_percent), Not(HasSubstr("also stored")));
  EXPECT_THAT(words(as_shares), HasSubstr("also stored as " + as_percent.dataset->id.value));
  EXPECT_EQ(again.status, IngestStatus::unchanged);
  EXPECT_EQ(again.dataset->id, as_percent.dataset->id);
}

}  // namespace
}  // namespace floeplan::ingest::dataset_identity_test
