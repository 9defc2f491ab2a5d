#include "tests/storage/ingest/support/store_fixture.hpp"

#include <cpl_port.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/support/places.hpp"

CPL_C_START
void CPL_DLL RegisterOGRLIBKML();
CPL_C_END

namespace floeplan::ingest {

void register_writers() {
  register_drivers();
  static const bool is_done = (RegisterOGRLIBKML(), true);
  static_cast<void>(is_done);
}

StoreFixture::StoreFixture() : db_{repository::open_store_in_memory()} {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string name =
      std::string{test->test_suite_name()} + "." + test->name() + "." + std::to_string(::getpid());
  for (char& c : name)
    if (c == '/') c = '_';
  folder_ = std::filesystem::temp_directory_path() / ("floeplan_ingest_" + name);
  std::filesystem::create_directories(folder_);
}

StoreFixture::~StoreFixture() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::filesystem::path StoreFixture::write_file(const std::string& name, const std::string& content) const {
  std::ofstream out{path(name), std::ios::binary};
  out << content;
  return path(name);
}

std::vector<IngestReport> StoreFixture::ingest_all(const std::filesystem::path& file,
                                                   const IngestOptions& options) {
  return ingest_file(db_, file, options, core::from_unix_seconds(1.8e9), {});
}

IngestReport StoreFixture::ingest(const std::filesystem::path& file, const IngestOptions& options) {
  auto reports = ingest_all(file, options);
  EXPECT_EQ(reports.size(), 1U) << file;
  return reports.empty() ? IngestReport{} : reports.front();
}

std::vector<IngestReport> StoreFixture::ingest_all_together(const std::vector<std::filesystem::path>& files,
                                                            const IngestOptions& options) {
  return ingest_files(db_, files, options, core::from_unix_seconds(1.8e9), {}, {});
}

IngestReport StoreFixture::ingest_together(const std::vector<std::filesystem::path>& files,
                                           const IngestOptions& options) {
  auto reports = ingest_all_together(files, options);
  EXPECT_EQ(reports.size(), 1U) << files.front();
  return reports.empty() ? IngestReport{} : reports.front();
}

ocean::CurrentGrid StoreFixture::currents_of(const IngestReport& report) {
  if (!report.dataset) throw std::runtime_error{"nothing is stored" + words(report)};
  return repository::FieldRepository{db_}
      .load_currents(report.dataset->id, {-180.0, -90.0, 180.0, 90.0}, std::nullopt, std::nullopt)
      .value();
}

std::size_t StoreFixture::stored_datasets() { return repository::DatasetRepository{db_}.list().size(); }

void StoreFixture::expect_refused(const std::filesystem::path& file, const std::string& reason,
                                  const IngestOptions& options) {
  const std::size_t before = stored_datasets();
  const auto reports = ingest_all(file, options);
  ASSERT_FALSE(reports.empty()) << file;
  for (const IngestReport& report : reports) {
    EXPECT_EQ(report.status, IngestStatus::refused) << file << words(report);
    EXPECT_FALSE(report.dataset.has_value()) << file;
    EXPECT_EQ(report.errors.size(), 1U) << file;
  }
  EXPECT_THAT(words(reports.front()), testing::HasSubstr(reason)) << file;
  EXPECT_EQ(stored_datasets(), before) << file;
}

std::filesystem::path sample_folder() {
  const auto folder = std::filesystem::path{support::source_folder()} / "../shared/data/env";
  return std::filesystem::is_directory(folder) ? folder : std::filesystem::path{};
}

std::uint64_t damaged_variants(std::uint64_t in_every_run) {
  const char* wanted = std::getenv("FLOEPLAN_DAMAGED_FILES");
  return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : in_every_run;
}

std::string words(const IngestReport& report) {
  std::string text;
  for (const std::string& error : messages::sentences(report.errors)) text += "\nerror: " + error;
  for (const std::string& warning : messages::sentences(report.warnings)) text += "\nwarning: " + warning;
  return text;
}

}  // namespace floeplan::ingest
