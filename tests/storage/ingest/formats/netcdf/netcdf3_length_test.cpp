#include "storage/ingest/formats/netcdf/netcdf3_length.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"

namespace floeplan::ingest::netcdf3_length_test {
namespace {

std::string word(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes += static_cast<char>(value >> static_cast<unsigned>(shift) & 0xFFU);
  return bytes;
}

/// A classic file with dimensions x = 3 and t = unlimited, a fixed float x(x) and one short record variable
/// r(t).
std::string small_file(std::uint32_t records) {
  const std::string no_attributes = word(0) + word(0);
  const std::string dimensions = word(10) + word(2) + word(1) + "x" + std::string(3, '\0') + word(3) +
                                 word(1) + "t" + std::string(3, '\0') + word(0);
  const auto variable = [&](const char* name, std::uint32_t dimension, std::uint32_t type, std::uint32_t size,
                            std::uint32_t begin) {
    return word(1) + name + std::string(3, '\0') + word(1) + word(dimension) + no_attributes + word(type) +
           word(size) + word(begin);
  };
  constexpr std::uint32_t header_bytes = 4 + 4 + 32 + 8 + 8 + 2 * 36;
  return "CDF\x01" + word(records) + dimensions + no_attributes + word(11) + word(2) +
         variable("x", 0, 5, 12, header_bytes) + variable("r", 1, 3, 4, header_bytes + 12);
}

std::string wide(std::uint64_t value) {
  return word(static_cast<std::uint32_t>(value >> 32U)) + word(static_cast<std::uint32_t>(value));
}

std::string padded(std::string text) {
  text.resize((text.size() + 3) / 4 * 4);
  return text;
}

/// A file in the format with 64-bit numbers (CDF-5): depths(latitude, longitude) of two bytes each, 2 x 2.
std::string small_bathymetry_of_64_bits() {
  const auto name = [](const std::string& text) { return wide(text.size()) + padded(text); };
  const auto variable = [&](const std::string& called, const std::string& dimensions, const std::string& unit,
                            std::uint32_t type, std::uint64_t size, std::uint64_t begin) {
    return name(called) + wide(dimensions.size() / 8) + dimensions + word(12) + wide(1) + name("units") +
           word(2) + name(unit) + word(type) + wide(size) + wide(begin);
  };
  const auto header = [&](std::uint64_t end) {
    return "CDF\x05" + wide(0) + word(10) + wide(2) + name("lat") + wide(2) + name("lon") + wide(2) +
           word(0) + wide(0) + word(11) + wide(3) + variable("lat", wide(0), "degrees_north", 3, 4, end) +
           variable("lon", wide(1), "degrees_east", 3, 4, end + 4) +
           variable("elevation", wide(0) + wide(1), "m", 3, 8, end + 8);
  };
  const std::string latitudes = word(60U << 16U | 61U);
  const std::string longitudes = word(5U << 16U | 6U);
  const std::string elevations = word(0xFFF6FFECU) + word(0xFFE2FFD8U);  // -10 -20 -30 -40
  return header(header(0).size()) + latitudes + longitudes + elevations;
}

class Netcdf3Length : public StoreFixture {};

TEST_F(Netcdf3Length, OfAFileWith64BitNumbersEndsWithItsValues) {
  const std::string bytes = small_bathymetry_of_64_bits();
  const auto file = write_file("wide.nc", bytes);
  EXPECT_EQ(netcdf3_length(file), bytes.size());

  const auto report = ingest(file);

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  const auto sea =
      repository::FieldRepository{db_}.load_bathymetry(report.dataset->id, {-180.0, -90.0, 180.0, 90.0});
  ASSERT_TRUE(sea);
  EXPECT_EQ(sea->depth_m(), (std::vector{10.0F, 20.0F, 30.0F, 40.0F}));
}

TEST_F(Netcdf3Length, AddsUpFixedValuesAndUnpaddedRecords) {
  const std::string header = small_file(5);
  const auto file = write_file("small.nc", header);
  EXPECT_EQ(netcdf3_length(file), header.size() + 12 + 5 * 2);
}

TEST_F(Netcdf3Length, OfAFileWithoutRecordsEndsWithItsFixedValues) {
  const std::string header = small_file(0);
  EXPECT_EQ(netcdf3_length(write_file("small.nc", header)), header.size() + 12);
}

TEST_F(Netcdf3Length, RefusesAHeaderThatIsCutShort) {
  const std::string header = small_file(5);
  for (std::size_t size = 4; size < header.size(); size += 7)
    EXPECT_FALSE(netcdf3_length(write_file("small.nc", header.substr(0, size)))) << size;
}

TEST_F(Netcdf3Length, RefusesAbsurdCounts) {
  std::string header = small_file(5);
  header.replace(12, 4, word(0x7FFFFFFFU));
  EXPECT_FALSE(netcdf3_length(write_file("small.nc", header)));
}

TEST_F(Netcdf3Length, IsAtMostTheSizeOfRealFiles) {
  if (sample_folder().empty()) GTEST_SKIP() << "the sample data are not on this machine";
  for (const char* name :
       {"currents/cmems_global-analysis-forecast-phy-001-024.nc", "currents/gnome_gridded_current.nc",
        "currents/arctic20km_polarstereo_sub.nc", "bathymetry/etopo60.cdf", "bathymetry/topo_30min.nc"}) {
    const auto length = netcdf3_length(sample_folder() / name);
    ASSERT_TRUE(length) << name;
    EXPECT_LE(*length, std::filesystem::file_size(sample_folder() / name)) << name;
    EXPECT_GE(*length + 4, std::filesystem::file_size(sample_folder() / name)) << name;
  }
}

}  // namespace
}  // namespace floeplan::ingest::netcdf3_length_test
