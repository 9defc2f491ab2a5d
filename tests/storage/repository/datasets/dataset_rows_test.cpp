#include "storage/repository/datasets/dataset_rows.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/sql/driver/failure.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/property.hpp"

namespace floeplan::repository::dataset_rows_test {
namespace {

void store(sql::Connection& db, const std::string& id) {
  Dataset dataset = sample_dataset(id, DatasetKind::icebergs);
  dataset.warnings = {"seen from afar"};
  DatasetRepository{db}.insert(dataset);
  std::vector<ocean::Iceberg> sightings(3);
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    sightings[i].id = id + std::to_string(i);
    sightings[i].place = {-50.0 - static_cast<double>(i), 70.0};
  }
  IcebergRepository{db}.insert({id}, sightings);
}

std::vector<std::string> parcels_of(sql::Connection& db, const std::vector<DatasetId>& ids) {
  std::vector<std::string> parcels;
  send_datasets(db, ids, [&](std::string_view parcel) { parcels.emplace_back(parcel); });
  return parcels;
}

std::vector<DatasetId> receive(sql::Connection& db, const std::vector<std::string>& parcels) {
  DatasetReceiver receiver{db};
  for (const std::string& parcel : parcels) receiver.take(parcel);
  return receiver.finish();
}

std::int64_t count(sql::Connection& db, const std::string& rows) {
  sql::Statement query{db, "SELECT count(*) FROM " + rows};
  return query.step() ? query.integer(0) : -1;
}

/// A parcel with one row of the table "sighting_box".
std::string box_of_row(std::int64_t row) {
  std::string parcel = "\x0csighting_box";
  const auto add = [&](const auto value) {
    std::array<char, sizeof value> bytes{};
    std::memcpy(bytes.data(), &value, sizeof value);
    parcel += '\x01';
    parcel.append(bytes.data(), bytes.size());
  };
  add(row);
  for (const double degrees : {-50.0, -50.0, 70.0, 70.0}) add(degrees);
  return parcel;
}

TEST(DatasetRows, BringADatasetWithAllItsRowsAndNoOther) {
  auto there = open_store_in_memory();
  store(there, "icebergs-a");
  store(there, "icebergs-b");
  auto here = open_store_in_memory();

  const auto ids = receive(here, parcels_of(there, {{"icebergs-b"}}));

  EXPECT_EQ(ids, std::vector{DatasetId{"icebergs-b"}});
  EXPECT_EQ(count(here, "dataset"), 1);
  EXPECT_EQ(count(here, "sighting JOIN sighting_box USING (row) WHERE berg_id LIKE 'icebergs-b%'"), 3);
  EXPECT_EQ(DatasetRepository{here}.find({"icebergs-b"})->warnings,
            std::vector<std::string>{"seen from afar"});
}

TEST(DatasetRows, AreRefusedWhenTheyBelongToNoDataset) {
  auto there = open_store_in_memory();
  store(there, "icebergs-a");
  auto parcels = parcels_of(there, {{"icebergs-a"}});
  std::erase_if(parcels, [](const std::string& parcel) {
    return parcel.starts_with(
        "\x07"
        "dataset");
  });
  auto here = open_store_in_memory();
  EXPECT_THROW(static_cast<void>(receive(here, parcels)), BrokenParcel);
}

TEST(DatasetRows, AreRefusedOfTablesThatHoldNoData) {
  auto here = open_store_in_memory();
  DatasetReceiver receiver{here};
  for (const char* table : {"token", "plan", "sqlite_master", "sighting_box_node", ""})
    EXPECT_THROW(receiver.take(static_cast<char>(std::strlen(table)) + std::string{table}), BrokenParcel)
        << table;
  EXPECT_THROW(receiver.take(""), BrokenParcel);
}

TEST(DatasetRows, AreRefusedWithNumbersThatWouldOverflow) {
  for (const std::int64_t row : {INT64_MAX, INT64_MIN, std::int64_t{-1}, std::int64_t{0}}) {
    auto here = open_store_in_memory();
    DatasetReceiver receiver{here};
    EXPECT_THROW(receiver.take(box_of_row(row)), BrokenParcel) << row;
  }
}

TEST(DatasetRows, AreRefusedOfAKindThatNoListCouldShow) {
  auto there = open_store_in_memory();
  store(there, "icebergs-a");
  sql::execute(there, "UPDATE dataset SET kind = 'treasure'");
  auto here = open_store_in_memory();
  EXPECT_THROW(static_cast<void>(receive(here, parcels_of(there, {{"icebergs-a"}}))), BrokenParcel);
}

/// Whatever a broken process sends, the receiver takes it, or says that it is broken.
TEST(DatasetRows, ThatWereSpoiltAreTakenOrRefused) {
  auto there = open_store_in_memory();
  store(there, "icebergs-a");
  const auto good = parcels_of(there, {{"icebergs-a"}});
  support::for_each_seed(300, [&](std::mt19937_64& rng) {
    auto parcels = good;
    std::string& spoilt = parcels[std::uniform_int_distribution<std::size_t>{0, parcels.size() - 1}(rng)];
    for (int flips = support::uniform_int(rng, 1, 4); flips > 0; --flips)
      spoilt[std::uniform_int_distribution<std::size_t>{0, spoilt.size() - 1}(rng)] =
          static_cast<char>(support::uniform_int(rng, 0, 255));
    if (support::uniform_int(rng, 0, 3) == 0) spoilt.resize(spoilt.size() / 2);
    auto here = open_store_in_memory();
    try {
      for (const DatasetId& id : receive(here, parcels))
        EXPECT_TRUE(DatasetRepository{here}.find(id).has_value());
    } catch (const BrokenParcel&) {
      SUCCEED();
    }
  });
}

}  // namespace
}  // namespace floeplan::repository::dataset_rows_test
