#include "storage/repository/datasets/retention.hpp"

#include <gmock/gmock.h>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/empty_store.hpp"

namespace floeplan::repository::retention_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

StoredSize ending(const std::string& id, core::UtcTime end, std::int64_t bytes,
                  DatasetKind kind = DatasetKind::currents) {
  Dataset dataset = sample_dataset(id, kind);
  dataset.provenance.ingested = sample_time - 100.0 * day;
  dataset.time_start = end - day;
  dataset.time_end = end;
  return {dataset, bytes};
}

std::vector<std::string> ids(const std::vector<StoredSize>& datasets) {
  std::vector<std::string> result;
  for (const StoredSize& each : datasets) result.push_back(each.dataset.id.value);
  return result;
}

const std::vector<StoredSize> three{ending("newest", sample_time, 100),
                                    ending("oldest", sample_time - 20.0 * day, 100),
                                    ending("middle", sample_time - 10.0 * day, 100)};

TEST(Retention, RemovesNothingWithoutARule) {
  EXPECT_THAT(beyond_retention(three, {}, sample_time), IsEmpty());
}

TEST(Retention, RemovesWhatEndedTooLongAgo) {
  EXPECT_THAT(ids(beyond_retention(three, {.max_age = 15.0 * day}, sample_time)), ElementsAre("oldest"));
}

TEST(Retention, CountsTheAgeFromTheIngestionWhenThatIsLater) {
  auto stored = three;
  stored[1].dataset.provenance.ingested = sample_time - day;

  EXPECT_THAT(beyond_retention(stored, {.max_age = 15.0 * day}, sample_time), IsEmpty());
}

TEST(Retention, RemovesTheOldestFirstUntilTheRestFits) {
  EXPECT_THAT(ids(beyond_retention(three, {.max_bytes = 250}, sample_time)), ElementsAre("oldest"));
  EXPECT_THAT(ids(beyond_retention(three, {.max_bytes = 100}, sample_time)), ElementsAre("oldest", "middle"));
}

TEST(Retention, KeepsTheLastOfEachKindHoweverOldAndLarge) {
  EXPECT_THAT(ids(beyond_retention(three, {.max_age = day, .max_bytes = 0}, sample_time + 999.0 * day)),
              ElementsAre("oldest", "middle"));
}

TEST(Retention, NeverRemovesDataWithoutTime) {
  StoredSize chart{sample_dataset("chart", DatasetKind::bathymetry), 1'000'000};
  StoredSize other{sample_dataset("other", DatasetKind::bathymetry), 1'000'000};

  EXPECT_THAT(beyond_retention({chart, other}, {.max_age = day, .max_bytes = 0}, sample_time + 999.0 * day),
              IsEmpty());
}

TEST(Retention, HoldsForTheKindThatIsNamed) {
  const std::vector<StoredSize> mixed{ending("ice-old", sample_time - 30.0 * day, 10, DatasetKind::ice),
                                      ending("ice-new", sample_time, 10, DatasetKind::ice),
                                      ending("currents-old", sample_time - 30.0 * day, 10),
                                      ending("currents-new", sample_time, 10)};

  EXPECT_THAT(ids(beyond_retention(mixed, {.max_age = day, .kind = DatasetKind::ice}, sample_time)),
              ElementsAre("ice-old"));
  EXPECT_THAT(beyond_retention(mixed, {.max_bytes = 20, .kind = DatasetKind::ice}, sample_time), IsEmpty());
}

TEST(Retention, RemovesFromTheStoreWithItsSamples) {
  auto db = support::empty_store();
  for (const StoredSize& each : three) DatasetRepository{db}.insert(each.dataset);
  FieldRepository fields{db};
  fields.create({"oldest"},
                {{geo::GeographicFrame{}, ocean::Axis{{0.0, 1.0}}, ocean::Axis{{0.0, 1.0}}}, {}, {}});
  fields.write_slice({"oldest"}, "u_m_s", 0, 0, std::vector<float>(4, 1.0F));

  const auto removed = remove_beyond_retention(db, {.max_age = 15.0 * day}, sample_time);

  ASSERT_THAT(ids(removed), ElementsAre("oldest"));
  EXPECT_GT(removed.front().bytes, 0);
  EXPECT_EQ(DatasetRepository{db}.list().size(), 2U);
  EXPECT_FALSE(fields.shape({"oldest"}));
}

}  // namespace
}  // namespace floeplan::repository::retention_test
