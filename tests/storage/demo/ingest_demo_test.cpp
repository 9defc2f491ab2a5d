#include <gtest/gtest.h>

#include "storage/ingest/ingest_file.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/sql/connection.hpp"
#include "tests/storage/demo/demo_files.hpp"

namespace floeplan::demo::ingest_demo_test {
namespace {

void expect_all_stored(const std::vector<std::filesystem::path>& files) {
  sql::Connection db = repository::open_store_in_memory();

  for (const std::filesystem::path& file : files) {
    const auto reports = ingest::ingest_file(db, file, {}, first_hour, {});
    ASSERT_EQ(reports.size(), 1U) << file;
    const ingest::IngestReport& report = reports.front();
    EXPECT_EQ(report.status, ingest::IngestStatus::stored)
        << file << ": " << ingest::reason_of(report.errors);
    ASSERT_TRUE(report.dataset.has_value());
    EXPECT_EQ(report.dataset->rows_refused, 0) << file;
  }
}

TEST(IngestDemo, StoresEveryFileOfDiskoBay) {
  if (!has_shoreline()) GTEST_SKIP() << "install the package gmt-gshhg-full to run this test";
  expect_all_stored(demo_files(Scenario::disko, 1, "disko"));
}

TEST(IngestDemo, StoresAFieldOfDriftIceWithOpenWaterInItsMiddleAndRoundIt) {
  if (!has_shoreline()) GTEST_SKIP() << "install the package gmt-gshhg-full to run this test";
  sql::Connection db = repository::open_store_in_memory();
  const auto reports =
      ingest::ingest_file(db, demo_files(Scenario::disko, 1, "disko")[2], {}, first_hour, {});
  ASSERT_TRUE(reports.front().dataset.has_value());
  ASSERT_EQ(reports.front().dataset->kind, repository::DatasetKind::ice);

  const auto ice = repository::FieldRepository{db}.load_ice(reports.front().dataset->id,
                                                            {-54.5, 68.4, -50.5, 69.6}, std::nullopt);

  ASSERT_TRUE(ice);
  const auto at = [&](double lon_deg, double lat_deg) {
    return ice->at({lon_deg, lat_deg}, first_hour).value();
  };
  EXPECT_LT(at(-52.45, 68.96).concentration, 0.05);
  EXPECT_GT(at(-52.60, 68.96).concentration, 0.7);
  EXPECT_GT(at(-52.30, 68.96).concentration, 0.7);
  EXPECT_LT(at(-53.20, 69.20).concentration, 0.05);
  EXPECT_NEAR(at(-52.60, 68.96).thickness->value, 0.6, 0.35);
}

TEST(IngestDemo, StoresEveryFileOfTheStrait) { expect_all_stored(demo_files(Scenario::strait, 1, "strait")); }

TEST(IngestDemo, StoresABeltOfPackIceWithLeadsThatDriftWithIt) {
  const auto files = demo_files(Scenario::pack_ice, 1, "pack-ice");
  expect_all_stored(files);
  sql::Connection db = repository::open_store_in_memory();
  const auto reports = ingest::ingest_file(db, files[2], {}, first_hour, {});
  const auto ice = repository::FieldRepository{db}.load_ice(reports.front().dataset->id,
                                                            {-66.0, 72.7, -62.0, 73.3}, std::nullopt);

  ASSERT_TRUE(ice);
  const auto concentration = [&](double lon_deg, double lat_deg, int days) {
    return ice->at({lon_deg, lat_deg}, first_hour + std::chrono::days{days}).value().concentration;
  };
  for (int days = 0; days <= 6; ++days) {
    const double south_deg = 2500.0 * days / 111'500.0;
    EXPECT_LT(concentration(-65.6, 73.0, days), 0.05) << days;  // west of the belt
    EXPECT_LT(concentration(-62.4, 73.0, days), 0.05) << days;
    EXPECT_GT(concentration(-64.0, 73.0 - south_deg, days), 0.8) << days;        // the middle of the belt
    EXPECT_LT(concentration(-64.736, 73.0538 - south_deg, days), 0.05) << days;  // the western lead
    EXPECT_LT(concentration(-64.0, 73.1794 - south_deg, days), 0.05) << days;
    EXPECT_LT(concentration(-63.264, 73.0717 - south_deg, days), 0.05) << days;
  }
}

TEST(IngestDemo, StoresEveryFileOfThePaperScenarios) {
  expect_all_stored(demo_files(Scenario::river, 1, "river"));
  expect_all_stored(demo_files(Scenario::jet, 1, "jet"));
}

}  // namespace
}  // namespace floeplan::demo::ingest_demo_test
