#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/model_grid_writer.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::damaged_currents_test {
namespace {

/// Files of currents in several layouts, small enough to be damaged many times.
class DamagedCurrents : public StoreFixture {
 protected:
  std::vector<std::filesystem::path> good_files() {
    const ModelGrid small{.columns = 8, .rows = 7};
    CurrentFile{}.write(path("regular.nc"));
    write_pop(small, path("pop.nc"));
    write_roms(small, path("roms.nc"), {});
    std::vector<std::filesystem::path> files{path("regular.nc"), path("pop.nc"), path("roms.nc")};
    if (!sample_folder().empty()) {
      files.push_back(sample_folder() / "currents/UGRIDv0.9_eleven_points_with_depth.nc");
      files.push_back(sample_folder() / "currents/ladim_forcing.nc");
    }
    return files;
  }
  static std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in{file, std::ios::binary};
    return {std::istreambuf_iterator<char>{in}, {}};
  }
  /// A damaged file is refused, or its stored values are plausible; the stored dataset is then removed.
  void expect_harmless(const std::string& bytes) {
    for (const IngestReport& report : ingest_all(write_file("damaged.nc", bytes))) {
      if (!report.dataset) {
        EXPECT_EQ(report.errors.size(), 1U);
        continue;
      }
      if (report.dataset->kind == repository::DatasetKind::currents) {
        const auto currents = repository::FieldRepository{db_}.load_currents(
            report.dataset->id, {-180.0, -90.0, 180.0, 90.0}, std::nullopt, std::nullopt);
        if (currents)
          for (std::size_t i = 0; i < currents->samples().u.size(); ++i) {
            const float u = currents->samples().u[i];
            ASSERT_TRUE(std::isnan(u) || std::hypot(u, currents->samples().v[i]) <= 10.01F);
          }
      }
      repository::DatasetRepository{db_}.remove(report.dataset->id);
    }
    EXPECT_EQ(stored_datasets(), 0U);
  }
};

TEST_F(DamagedCurrents, CutAtEveryTwentiethOfTheirLengthAreRefused) {
  for (const auto& file : good_files()) {
    const std::string whole = bytes_of(file);
    for (std::size_t part = 0; part < 20; ++part) {
      write_file("cut.nc", whole.substr(0, whole.size() * part / 20));
      for (const IngestReport& report : ingest_all(path("cut.nc")))
        EXPECT_EQ(report.status, IngestStatus::refused) << file << " " << part;
    }
  }
  EXPECT_EQ(stored_datasets(), 0U);
}

TEST_F(DamagedCurrents, InClassicFilesWithBytesChangedAreRefusedOrPossible) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  // Classic NetCDF alone: the HDF5 library itself ends the process on some damaged NetCDF-4 files.
  const std::vector<std::filesystem::path> files{
      sample_folder() / "currents/UGRIDv0.9_eleven_points_with_depth.nc",
      sample_folder() / "currents/arctic20km_polarstereo_sub.nc",
      sample_folder() / "currents/gnome_gridded_current.nc"};
  support::for_each_seed(40, [&](std::mt19937_64& rng) {
    for (const auto& file : files) {
      std::string bytes = bytes_of(file);
      // Half of the changes hit the header, which decides the most.
      const std::size_t reach = support::uniform_int(rng, 0, 1) == 0 ? 4096 : bytes.size();
      for (int flips = std::uniform_int_distribution{1, 8}(rng); flips > 0; --flips)
        bytes[std::uniform_int_distribution<std::size_t>{0, std::min(reach, bytes.size()) - 1}(rng)] =
            static_cast<char>(std::uniform_int_distribution{0, 255}(rng));
      expect_harmless(bytes);
    }
  });
}

TEST_F(DamagedCurrents, WithTablesOfABillionPointsAreRefusedBeforeTheyAreRead) {
  {
    NetcdfWriter writer{path("huge.nc")};
    writer.axis("time", {0.0}, {{"units", "hours since 2026-11-20"}});
    writer.dimension("y", 1'000'000'000);
    writer.dimension("x", 1'000'000'000);
    for (const char* name : {"nav_lon", "nav_lat"})
      writer.variable(
          {.name = name,
           .dimensions = {"y", "x"},
           .values = {},
           .texts = {{"units", std::string{name} == "nav_lon" ? "degrees_east" : "degrees_north"}},
           .numbers = {},
           .fill = {},
           .type = NetcdfWriter::Type::float32});
    for (const char* name : {"vozocrtx", "vomecrty"})
      writer.variable({.name = name,
                       .dimensions = {"time", "y", "x"},
                       .values = {},
                       .texts = {{"units", "m/s"}},
                       .numbers = {},
                       .fill = {},
                       .type = NetcdfWriter::Type::float32});
  }
  expect_refused(path("huge.nc"), "more than this program accepts");
}

}  // namespace
}  // namespace floeplan::ingest::damaged_currents_test
