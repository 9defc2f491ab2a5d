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

/// A store in memory and a folder of its own for files that the test writes.
class StoreFixture : public testing::Test {
 protected:
  StoreFixture();
  ~StoreFixture() override;

  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  /// Writes bytes to a file in the test's folder.
  std::filesystem::path write_file(const std::string& name, const std::string& content) const;
  [[nodiscard]] std::vector<IngestReport> ingest_all(const std::filesystem::path& file,
                                                     const IngestOptions& options = {});
  /// The report of a file that holds one kind of data.
  [[nodiscard]] IngestReport ingest(const std::filesystem::path& file, const IngestOptions& options = {});
  /// The reports of files that are given in one command.
  [[nodiscard]] std::vector<IngestReport> ingest_all_together(const std::vector<std::filesystem::path>& files,
                                                              const IngestOptions& options = {});
  /// The report of files that make one dataset.
  [[nodiscard]] IngestReport ingest_together(const std::vector<std::filesystem::path>& files,
                                             const IngestOptions& options = {});
  /// All currents of the dataset that a report names.
  /// Errors  std::runtime_error with the words of a report that names none
  [[nodiscard]] ocean::CurrentGrid currents_of(const IngestReport& report);
  [[nodiscard]] std::size_t stored_datasets();
  /// Expects a refusal whose reason contains `reason`, and a store as it was before.
  void expect_refused(const std::filesystem::path& file, const std::string& reason,
                      const IngestOptions& options = {});

  sql::Connection db_;

 private:
  std::filesystem::path folder_;
};

/// GDAL's drivers that the program reads with, and the one that tests write KML with.
void register_writers();

/// The folder of real sample files; empty when it is not on this machine.
[[nodiscard]] std::filesystem::path sample_folder();

/// How many damaged variants of a file a test tries: `in_every_run`, or as many as FLOEPLAN_DAMAGED_FILES says in a
/// long run.
[[nodiscard]] std::uint64_t damaged_variants(std::uint64_t in_every_run);

/// Everything a report says, for the message of a failed test.
[[nodiscard]] std::string words(const IngestReport& report);

}  // namespace floeplan::ingest
