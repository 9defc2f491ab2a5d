#include <gtest/gtest.h>

#include "storage/ingest/ingest_file.hpp"
#include "storage/repository/migrations.hpp"
#include "storage/sqlite/connection.hpp"
#include "tests/storage/demo/demo_files.hpp"

namespace floeplan::demo {
namespace {

void expect_all_stored(const std::vector<std::filesystem::path>& files) {
  sqlite::Connection db = repository::open_store_in_memory();

  for (const std::filesystem::path& file : files) {
    const auto reports = ingest::ingest_file(db, file, {}, first_hour, {});
    ASSERT_EQ(reports.size(), 1U) << file;
    const ingest::IngestReport& report = reports.front();
    EXPECT_EQ(report.status, ingest::IngestStatus::stored)
        << file << ": " << (report.errors.empty() ? "" : report.errors.front());
    ASSERT_TRUE(report.dataset.has_value());
    EXPECT_EQ(report.dataset->rows_refused, 0) << file;
  }
}

TEST(IngestDemo, StoresEveryFileOfDiskoBay) {
  if (!has_shoreline()) GTEST_SKIP() << "install the package gmt-gshhg-full to run this test";
  expect_all_stored(demo_files(Scenario::disko, 1, "disko"));
}

TEST(IngestDemo, StoresEveryFileOfThePaperScenarios) {
  expect_all_stored(demo_files(Scenario::river, 1, "river"));
  expect_all_stored(demo_files(Scenario::jet, 1, "jet"));
}

}  // namespace
}  // namespace floeplan::demo
