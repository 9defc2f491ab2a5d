#include "tests/storage/demo/demo_files.hpp"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <sstream>

#include "storage/ingest/common/gdal_guard.hpp"

namespace floeplan::demo {
namespace {

std::vector<double> doubles_of(const GDALMDArray& array) {
  std::vector<std::size_t> count;
  std::size_t total = 1;
  for (const auto& dimension : array.GetDimensions()) {
    count.push_back(dimension->GetSize());
    total *= count.back();
  }
  const std::vector<GUInt64> start(count.size());
  std::vector<double> values(total);
  EXPECT_TRUE(array.Read(start.data(), count.data(), nullptr, nullptr,
                         GDALExtendedDataType::Create(GDT_Float64), values.data()));
  return values;
}

/// Files that the tests of this process share; removed at its end.
struct Scratch {
  std::filesystem::path folder{std::filesystem::path{testing::TempDir()} /
                               ("floeplan_demo_" + std::to_string(getpid()))};
  std::map<std::string, std::vector<std::filesystem::path>> written;

  Scratch() = default;
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code ignored;  // a destructor has nobody to tell
    std::filesystem::remove_all(folder, ignored);
  }
};

}  // namespace

bool has_shoreline() { return std::filesystem::exists("/usr/share/gmt-gshhg/binned_GSHHS_f.nc"); }

std::vector<std::filesystem::path> demo_files(Scenario scenario, std::uint64_t seed,
                                              const std::string& directory) {
  static Scratch scratch;
  auto& files = scratch.written[directory];
  if (files.empty()) files = write_demo(scratch.folder / directory, scenario, seed, first_hour);
  return files;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in{file, std::ios::binary};
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

Component read_component(const std::filesystem::path& file, const std::string& name) {
  ingest::register_drivers();
  const std::array<const char*, 2> drivers{"netCDF", nullptr};
  const std::unique_ptr<GDALDataset> dataset{
      GDALDataset::Open(file.c_str(), GDAL_OF_MULTIDIM_RASTER, drivers.data())};
  const auto group = dataset->GetRootGroup();
  const auto array = group->OpenMDArray(name);
  Component component{doubles_of(*group->OpenMDArray("time")), doubles_of(*group->OpenMDArray("depth")),
                      doubles_of(*group->OpenMDArray("latitude")),
                      doubles_of(*group->OpenMDArray("longitude")), doubles_of(*array)};
  const double missing = array->GetNoDataValueAsDouble();
  const double scale = array->GetScale();
  for (double& value : component.m_s)
    value = value == missing ? std::numeric_limits<double>::quiet_NaN() : value * scale;
  return component;
}

}  // namespace floeplan::demo
