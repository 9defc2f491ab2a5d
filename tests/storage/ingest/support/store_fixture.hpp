#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/messages/sentence.hpp"
#include "engine/ocean/currents/current_grid.hpp"
#include "storage/ingest/ingest_file.hpp"
#include "storage/repository/store/migrations.hpp"

namespace floeplan::ingest {

/// A store in memory and a temporary folder for the test's files.
class StoreFixture : public testing::Test {
 protected:
  StoreFixture();
  ~StoreFixture() override;

  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  /// Writes bytes to a file in the test's folder.
  std::filesystem::path write_file(const std::string& name, const std::string& content) const;
  [[nodiscard]] std::vector<IngestReport> ingest_all(const std::filesystem::path& file,
                                                     const IngestOptions& options = {});
  /// Ingests a file with one kind of data and returns its report.
  [[nodiscard]] IngestReport ingest(const std::filesystem::path& file, const IngestOptions& options = {});
  /// Ingests files that are given in one command and returns their reports.
  [[nodiscard]] std::vector<IngestReport> ingest_all_together(const std::vector<std::filesystem::path>& files,
                                                              const IngestOptions& options = {});
  /// Ingests files that make one dataset and returns its report.
  [[nodiscard]] IngestReport ingest_together(const std::vector<std::filesystem::path>& files,
                                             const IngestOptions& options = {});
  /// All currents of the dataset named in a report.
  /// Errors  std::runtime_error with the report's text if it names none
  [[nodiscard]] ocean::CurrentGrid currents_of(const IngestReport& report);
  [[nodiscard]] std::size_t stored_datasets();
  /// Expects a refusal whose reason contains `reason`, and an unchanged store.
  void expect_refused(const std::filesystem::path& file, const std::string& reason,
                      const IngestOptions& options = {});

  sql::Connection db_;

 private:
  std::filesystem::path folder_;
};

/// Registers the GDAL drivers that the program reads with, and the one with which tests write KML.
void register_writers();

/// The folder of real sample files; empty if this machine does not have it.
[[nodiscard]] std::filesystem::path sample_folder();

/// Number of damaged variants of a file in a test: `in_every_run`, or in a long run the number in
/// FLOEPLAN_DAMAGED_FILES.
[[nodiscard]] std::uint64_t damaged_variants(std::uint64_t in_every_run);

/// The whole text of a report, for the message of a failed test.
[[nodiscard]] std::string words(const IngestReport& report);

}  // namespace floeplan::ingest
