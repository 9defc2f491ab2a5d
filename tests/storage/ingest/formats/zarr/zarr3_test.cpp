#include <cpl_compressor.h>
#include <cpl_string.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::zarr3_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const json little{{"name", "bytes"}, {"configuration", {{"endian", "little"}}}};
const json big{{"name", "bytes"}, {"configuration", {{"endian", "big"}}}};

/// How an array of a store is written.
struct Packing {
  json codecs{little};
  std::string compressor{};  // GDAL's name of it; empty: none
  std::string prefix{"c/"};
  char separator{'/'};
};

/// A Zarr store of version 3 written by hand, laid out as zarr-python 3.1 and xarray do: currents of two times on 2
/// latitudes by 3 longitudes, in a chunk for each time.
class Zarr3 : public StoreFixture {
 protected:
  void text(const std::string& name, const std::string& content) const {
    fs::create_directories(path("sea.zarr/" + name).parent_path());
    std::ofstream{path("sea.zarr/" + name), std::ios::binary} << content;
  }

  template <class T>
  static std::string bytes_of(const std::vector<T>& values, bool swapped) {
    std::string bytes{reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
    for (std::size_t at = 0; swapped && at < bytes.size(); at += sizeof(T))
      std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                   bytes.begin() + static_cast<std::ptrdiff_t>(at + sizeof(T)));
    return bytes;
  }

  static std::string compressed(const std::string& bytes, const std::string& compressor) {
    if (compressor.empty()) return bytes;
    register_drivers();
    const CPLCompressor* const by = CPLGetCompressor(compressor.c_str());
    std::string packed(bytes.size() + 1000, '\0');
    void* out = packed.data();
    std::size_t size = packed.size();
    CPLStringList options;
    if (compressor == "blosc") options.SetNameValue("TYPESIZE", "4");
    if (by == nullptr || !by->pfnFunc(bytes.data(), bytes.size(), &out, &size, options.List(), by->user_data))
      throw std::runtime_error{"GDAL does not compress by " + compressor};
    return packed.substr(0, size);
  }

  void array(const std::string& name, const json& shape, const json& chunk, const std::string& type,
             const json& dimensions, const json& attributes, const json& fill,
             const Packing& packing = {}) const {
    const json description{
        {"zarr_format", 3},
        {"node_type", "array"},
        {"shape", shape},
        {"data_type", type},
        {"chunk_grid", {{"name", "regular"}, {"configuration", {{"chunk_shape", chunk}}}}},
        {"chunk_key_encoding",
         {{"name", "default"}, {"configuration", {{"separator", std::string{packing.separator}}}}}},
        {"fill_value", fill},
        {"codecs", packing.codecs.is_array() ? packing.codecs : json::array({packing.codecs})},
        {"attributes", attributes},
        {"dimension_names", dimensions},
        {"storage_transformers", json::array()}};
    text(name + "/zarr.json", description.dump());
  }

  void axis(const std::string& name, const std::vector<double>& values, const json& attributes) const {
    array(name, json::array({values.size()}), json::array({values.size()}), "float64", json::array({name}),
          attributes, 0.0);
    text(name + "/c/0", bytes_of(values, false));
  }

  void axes() const {
    text("zarr.json", R"({"zarr_format":3,"node_type":"group","attributes":{"title":"a sea"}})");
    axis("time", {0.0, 6.0}, {{"units", "hours since 2026-11-20"}});
    axis("latitude", {60.0, 61.0}, {{"units", "degrees_north"}});
    axis("longitude", {10.0, 11.0, 12.0}, {{"units", "degrees_east"}});
  }

  template <class T>
  void component(const std::string& name, const std::string& type, const std::vector<std::vector<T>>& chunks,
                 json attributes, const json& fill, const Packing& packing = {}) const {
    attributes["units"] = "m s-1";
    attributes["standard_name"] =
        std::string{name == "uo" ? "eastward" : "northward"} + "_sea_water_velocity";
    array(name, json::array({2, 2, 3}), json::array({1, 2, 3}), type,
          json::array({"time", "latitude", "longitude"}), attributes, fill, packing);
    const std::string tail = std::string{packing.separator} + "0" + packing.separator + "0";
    const bool swapped = packing.codecs.dump().find("big") != std::string::npos;
    for (std::size_t time = 0; time < chunks.size(); ++time)
      if (!chunks[time].empty())
        text(name + "/" + packing.prefix + std::to_string(time) + tail,
             compressed(bytes_of(chunks[time], swapped), packing.compressor));
  }

  void write(const Packing& packing = {}) const {
    axes();
    component<float>("uo", "float32", {first, second}, json::object(), "NaN", packing);
    component<float>("vo", "float32", {second, first}, json::object(), "NaN", packing);
  }

  ocean::CurrentGrid::Samples stored(const IngestReport& report) { return currents_of(report).samples(); }

  static constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> first{0.1F, 0.2F, 0.3F, -0.4F, 0.5F, 0.6F};
  const std::vector<float> second{1.1F, 1.2F, -1.3F, 1.4F, 1.5F, 1.6F};
};

TEST_F(Zarr3, IsReadWhateverItsNumbersArePackedBy) {
  const json blosc{
      {"name", "blosc"},
      {"configuration",
       {{"typesize", 4}, {"cname", "lz4"}, {"clevel", 5}, {"shuffle", "shuffle"}, {"blocksize", 0}}}};
  for (const Packing& packing :
       {Packing{.compressor = ""}, Packing{.codecs = big, .compressor = ""},
        Packing{.compressor = "", .prefix = "c.", .separator = '.'},
        Packing{.codecs = {little, {{"name", "gzip"}, {"configuration", {{"level", 5}}}}},
                .compressor = "gzip"},
        Packing{.codecs = {big, {{"name", "zstd"}, {"configuration", {{"level", 0}, {"checksum", false}}}}},
                .compressor = "zstd"},
        Packing{.codecs = {little, blosc}, .compressor = "blosc"}}) {
    fs::remove_all(path("sea.zarr"));
    write(packing);

    const IngestReport report = ingest(path("sea.zarr"));

    ASSERT_EQ(report.status, IngestStatus::stored) << packing.codecs << words(report);
    const auto samples = stored(report);
    std::vector<float> expected = first;
    expected.insert(expected.end(), second.begin(), second.end());
    EXPECT_EQ(samples.u, expected) << packing.codecs;
    EXPECT_EQ(samples.grid.x().nodes(), (std::vector{10.0, 11.0, 12.0}));
    EXPECT_EQ(samples.grid.y().nodes(), (std::vector{60.0, 61.0}));
    repository::DatasetRepository{db_}.remove(report.dataset->id);
  }
}

TEST_F(Zarr3, HasStillWaterWhereAChunkOfZerosWasNotWritten) {
  axes();
  component<float>("uo", "float32", {first, {}}, json::object(), 0.0);
  component<float>("vo", "float32", {first, second}, json::object(), 0.0);

  const auto samples = stored(ingest(path("sea.zarr")));

  EXPECT_EQ(samples.u[5], 0.6F);
  EXPECT_EQ(samples.u[6], 0.0F);
  EXPECT_EQ(samples.v[6], 1.1F);
}

TEST_F(Zarr3, HasNothingWhereAChunkOfMissingValuesWasNotWritten) {
  axes();
  component<float>("uo", "float32", {first, {}}, json::object(), "NaN");
  component<float>("vo", "float32", {first, second}, json::object(), "NaN");

  const auto samples = stored(ingest(path("sea.zarr")));

  EXPECT_EQ(samples.u[5], 0.6F);
  EXPECT_TRUE(std::isnan(samples.u[6]));
  EXPECT_TRUE(std::isnan(samples.v[6]));
}

TEST_F(Zarr3, LeavesOutTheFillOfPackedNumbersBeforeTheyAreUnpacked) {
  axes();
  const json packed{{"scale_factor", 0.001}, {"add_offset", 0.5}, {"_FillValue", -32767}};
  component<std::int16_t>("uo", "int16", {{100, 200, -32767, 0, 500, 600}, {1, 2, 3, 4, 5, 6}}, packed, 0);
  component<std::int16_t>("vo", "int16", {{100, 200, 300, 0, 500, 600}, {1, 2, 3, 4, 5, 6}}, packed, 0);

  const auto samples = stored(ingest(path("sea.zarr")));

  EXPECT_NEAR(samples.u[0], 0.6, 1e-6);
  EXPECT_TRUE(std::isnan(samples.u[2]));
  EXPECT_NEAR(samples.u[3], 0.5, 1e-6);
}

/// 9.969209968386869e+36, the float64 bytes of which are 00 00 00 00 00 00 9e 47 turned round, as xarray writes it.
TEST_F(Zarr3, LeavesOutAFillThatIsWrittenInBase64) {
  axes();
  const json attributes{{"_FillValue", "AAAAAAAAnkc="}};
  const float fill = 9.969209968386869e+36F;
  component<float>("uo", "float32", {{0.1F, 0.2F, fill, 0.4F, 0.5F, 0.6F}, second}, attributes, 0.0);
  component<float>("vo", "float32", {first, second}, attributes, 0.0);

  const auto report = ingest(path("sea.zarr"));

  ASSERT_EQ(report.status, IngestStatus::stored) << words(report);
  EXPECT_EQ(words(report).find("does not declare"), std::string::npos) << words(report);
  EXPECT_TRUE(std::isnan(stored(report).u[2]));
}

TEST_F(Zarr3, IsReadBesideArraysOfTextsAndASingleNumber) {
  write();
  array("names", json::array({2}), json::array({2}), "string", json::array({"time"}), json::object(), "");
  array("crs", json::array(), json::array(), "int32", json::array(),
        {{"grid_mapping_name", "latitude_longitude"}}, 0);
  text("crs/c", std::string{"\1\0\0\0", 4});

  EXPECT_EQ(ingest(path("sea.zarr")).status, IngestStatus::stored);
}

TEST_F(Zarr3, InShardsIsRefused) {
  write();
  const json shards{{"name", "sharding_indexed"}, {"configuration", {{"chunk_shape", {1, 1, 3}}}}};
  component<float>("uo", "float32", {first, second}, json::object(), "NaN", {.codecs = shards});
  expect_refused(path("sea.zarr"), "shards");
}

TEST_F(Zarr3, PackedByACodecThatIsNotReadIsRefusedByItsName) {
  write();
  const json codecs = json::array({little, {{"name", "crc32c"}}});
  component<float>("uo", "float32", {first, second}, json::object(), "NaN", {.codecs = codecs});
  expect_refused(path("sea.zarr"), "\"crc32c\"");
}

TEST_F(Zarr3, WithTurnedDimensionsIsRefused) {
  write();
  const json codecs =
      json::array({{{"name", "transpose"}, {"configuration", {{"order", {2, 1, 0}}}}}, little});
  component<float>("uo", "float32", {first, second}, json::object(), "NaN", {.codecs = codecs});
  expect_refused(path("sea.zarr"), "\"transpose\"");
}

TEST_F(Zarr3, WhoseChunkWasCutShortIsRefused) {
  write();
  text("uo/c/1/0/0", "abc");
  expect_refused(path("sea.zarr"), "damaged");
}

TEST_F(Zarr3, ThatWouldUnpackToGigabytesIsRefused) {
  write();
  array("uo", json::array({2, 100'000, 100'000}), json::array({1, 100'000, 100'000}), "float32",
        json::array({"time", "latitude", "longitude"}), json::object(), 0.0);
  expect_refused(path("sea.zarr"), "chunks over 256 MB");
}

TEST_F(Zarr3, OfWhichOneArrayIsGivenIsRefused) {
  write();
  expect_refused(path("sea.zarr") / "uo", "the whole store");
}

TEST_F(Zarr3, WithADamagedDescriptionIsRefused) {
  write();
  text("uo/zarr.json", R"({"zarr_format":3,"node_type":"arr)");
  expect_refused(path("sea.zarr"), "damaged");
}

TEST_F(Zarr3, WithBytesChangedIsRefusedOrHoldsPossibleCurrents) {
  write({.codecs = {little, {{"name", "zstd"}}}, .compressor = "zstd"});
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto& entry : fs::recursive_directory_iterator{path("sea.zarr")}) {
    if (!entry.is_regular_file()) continue;
    std::ifstream in{entry.path(), std::ios::binary};
    files.emplace_back(entry.path().lexically_relative(path("sea.zarr")).string(),
                       std::string{std::istreambuf_iterator<char>{in}, {}});
  }
  support::for_each_seed(damaged_variants(100), [&](std::mt19937_64& rng) {
    const auto& [name, whole] =
        files[static_cast<std::size_t>(support::uniform_int(rng, 0, static_cast<int>(files.size()) - 1))];
    std::string bytes = whole;
    for (int flips = support::uniform_int(rng, 1, 4); flips > 0; --flips)
      bytes[static_cast<std::size_t>(support::uniform_int(rng, 0, static_cast<int>(bytes.size()) - 1))] =
          static_cast<char>(support::uniform_int(rng, 0, 255));
    text(name, bytes);

    for (const IngestReport& report : ingest_all(path("sea.zarr"))) {
      if (!report.dataset) continue;
      if (report.dataset->kind == repository::DatasetKind::currents) {
        const auto samples = stored(report);
        for (std::size_t i = 0; i < samples.u.size(); ++i)
          ASSERT_FALSE(std::hypot(samples.u[i], samples.v[i]) > 10.01F);
      }
      repository::DatasetRepository{db_}.remove(report.dataset->id);
    }

    text(name, whole);
    EXPECT_EQ(stored_datasets(), 0U);
  });
}

}  // namespace
}  // namespace floeplan::ingest::zarr3_test
