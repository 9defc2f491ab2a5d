#include "storage/repository/features/iceberg_repository.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/empty_store.hpp"
#include "tests/support/property.hpp"

namespace floeplan::repository::iceberg_repository_test {
namespace {

constexpr geo::BoundingBox everywhere{-180.0, -90.0, 180.0, 90.0};

std::vector<std::string> ids(const std::vector<StoredSighting>& sightings) {
  std::vector<std::string> result;
  for (const StoredSighting& sighting : sightings) result.push_back(sighting.iceberg.id);
  return result;
}

class IcebergRepositoryTest : public testing::Test {
 protected:
  IcebergRepositoryTest() {
    for (const char* id : {"ice-1", "ice-2"})
      DatasetRepository{db_}.insert(sample_dataset(id, DatasetKind::icebergs));
  }

  const DatasetId dataset_{"ice-1"};
  sql::Connection db_ = support::empty_store();
  IcebergRepository icebergs_{db_};
};

TEST_F(IcebergRepositoryTest, GivesBackWhatWasInserted) {
  const ocean::Iceberg full{.id = "B-22A",
                            .place = {-0.1, -75.1},
                            .observed = sample_time + core::Seconds{0.1},
                            .size = ocean::IcebergSize::radar_target,
                            .length = core::Metres{0.1},
                            .draft = core::Metres{0.2},
                            .position_uncertainty = core::Metres{0.3},
                            .shape = "TAB",
                            .method = "SAT-HIGH"};
  icebergs_.insert(dataset_, {full, sample_berg("bare", {1.0, 2.0})});

  const auto stored = icebergs_.list({}, 0, 10);
  ASSERT_EQ(stored.size(), 2U);
  const auto found = icebergs_.find(stored[0].row);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->dataset, dataset_);
  EXPECT_EQ(found->iceberg.id, full.id);
  EXPECT_EQ(found->iceberg.place, full.place);
  EXPECT_EQ(found->iceberg.observed, full.observed);
  EXPECT_EQ(found->iceberg.size, full.size);
  EXPECT_EQ(found->iceberg.length, full.length);
  EXPECT_EQ(found->iceberg.draft, full.draft);
  EXPECT_EQ(found->iceberg.position_uncertainty, full.position_uncertainty);
  EXPECT_EQ(found->iceberg.shape, full.shape);
  EXPECT_EQ(found->iceberg.method, full.method);
  EXPECT_EQ(stored[1].iceberg.length, std::nullopt);
  EXPECT_FALSE(icebergs_.find(stored[1].row + 1));
}

TEST_F(IcebergRepositoryTest, FindsThroughTheIndexExactlyWhatLiesInTheArea) {
  support::for_each_seed(30, [&](std::mt19937_64& rng) {
    std::vector<ocean::Iceberg> all;
    for (int i = 0; i < 100; ++i) {
      // Some on round degrees, so that they lie on the rim of some area, and some reckoned from 0 to 360.
      const double lon = support::uniform(rng, -180.0, 360.0);
      const double lat = support::uniform(rng, -90.0, 90.0);
      all.push_back(sample_berg(std::to_string(i), i % 2 == 0 ? geo::LonLat{std::round(lon), std::round(lat)}
                                                              : geo::LonLat{lon, lat}));
    }
    DatasetRepository{db_}.remove(dataset_);
    DatasetRepository{db_}.insert(sample_dataset(dataset_.value, DatasetKind::icebergs));
    icebergs_.insert(dataset_, all);

    for (int i = 0; i < 20; ++i) {
      const double south = std::round(support::uniform(rng, -90.0, 80.0));
      const geo::BoundingBox area{std::round(support::uniform(rng, -180.0, 180.0)), south,
                                  std::round(support::uniform(rng, -180.0, 180.0)),
                                  support::uniform(rng, south, 90.0)};
      std::vector<std::string> expected;
      for (const ocean::Iceberg& iceberg : all) {
        if (geo::contains(area, iceberg.place)) expected.push_back(iceberg.id);
      }
      ASSERT_EQ(ids(icebergs_.list({.area = area}, 0, 1000)), expected);
      ASSERT_EQ(icebergs_.count({.area = area}), std::ssize(expected));
    }
  });
}

TEST_F(IcebergRepositoryTest, AnswersLongitudesWithin180DegreesHoweverTheyWereCounted) {
  support::for_each_seed(30, [&](std::mt19937_64& rng) {
    const double lon = support::uniform(rng, -180.0, 180.0);
    const int turns = support::uniform_int(rng, -1, 1);
    const double written = std::abs(lon + 360.0 * turns) <= 360.0 ? lon + 360.0 * turns : lon;
    const std::string id = "berg " + std::to_string(lon);
    icebergs_.insert(dataset_, {sample_berg(id, {lon, 69.0}, sample_time),
                                sample_berg(id, {written, 69.0}, sample_time + hour)});

    const auto found = icebergs_.list({.berg_id = id}, 0, 10);

    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[1].iceberg.place.lon_deg, lon, 1e-9);
    EXPECT_EQ(found[0].iceberg.place.lon_deg, lon);
    const auto before = icebergs_.earlier(found[1], 2.0 * hour);
    ASSERT_EQ(before.size(), 1U);
    EXPECT_NEAR(before[0].place.lon_deg, lon, 1e-9);
  });
}

TEST_F(IcebergRepositoryTest, FiltersByTimeDatasetAndBerg) {
  icebergs_.insert(dataset_, {sample_berg("a", {0.0, 0.0}, sample_time),
                              sample_berg("b", {0.0, 0.0}, sample_time + hour)});
  icebergs_.insert({"ice-2"}, {sample_berg("a", {0.0, 0.0}, sample_time + 2 * hour)});

  EXPECT_THAT(ids(icebergs_.list({.from = sample_time + hour}, 0, 10)), testing::ElementsAre("b", "a"));
  EXPECT_THAT(ids(icebergs_.list({.to = sample_time + hour}, 0, 10)), testing::ElementsAre("a", "b"));
  EXPECT_THAT(ids(icebergs_.list({.dataset = DatasetId{"ice-2"}}, 0, 10)), testing::ElementsAre("a"));
  EXPECT_EQ(icebergs_.count({.berg_id = "a"}), 2);
  EXPECT_EQ(icebergs_.count({.area = everywhere, .from = sample_time + hour, .berg_id = "a"}), 1);
}

TEST_F(IcebergRepositoryTest, ListsInPages) {
  icebergs_.insert(
      dataset_, {sample_berg("a", {0.0, 0.0}), sample_berg("b", {90.0, 0.0}), sample_berg("c", {0.0, 1.0})});
  const SightingFilter filter{.area = geo::BoundingBox{-1.0, -1.0, 1.0, 1.0}};

  const auto first = icebergs_.list(filter, 0, 1);
  EXPECT_THAT(ids(first), testing::ElementsAre("a"));
  EXPECT_THAT(ids(icebergs_.list(filter, first.front().row, 10)), testing::ElementsAre("c"));
}

TEST_F(IcebergRepositoryTest, GivesTheNewestSightingOfEachBergByThen) {
  icebergs_.insert(
      dataset_,
      {sample_berg("a", {2.0, 0.0}, sample_time - hour), sample_berg("a", {1.0, 0.0}, sample_time - 2 * hour),
       sample_berg("a", {3.0, 0.0}, sample_time + hour), sample_berg("b", {4.0, 0.0}, sample_time)});

  const auto latest = icebergs_.latest(dataset_, everywhere, sample_time, day);

  ASSERT_THAT(ids(latest), testing::ElementsAre("a", "b"));
  EXPECT_EQ(latest[0].iceberg.place.lon_deg, 2.0);
}

/// Longitudes number the sightings: equal moments are frequent, and the one stored last then counts.
TEST_F(IcebergRepositoryTest, GivesWhatALookAtEverySightingGives) {
  support::for_each_seed(50, [&](std::mt19937_64& rng) {
    std::vector<ocean::Iceberg> all;
    for (int i = 0; i < 60; ++i) {
      const int berg = support::uniform_int(rng, 0, 6);
      all.push_back(sample_berg(berg == 0 ? "" : std::to_string(berg), {static_cast<double>(i), 0.0},
                                sample_time + support::uniform_int(rng, 0, 20) * hour));
    }
    DatasetRepository{db_}.remove(dataset_);
    DatasetRepository{db_}.insert(sample_dataset(dataset_.value, DatasetKind::icebergs));
    icebergs_.insert(dataset_, all);
    icebergs_.insert({"ice-2"}, {sample_berg("1", {0.0, 0.0}, sample_time + 10 * hour)});

    const core::UtcTime as_of = sample_time + support::uniform_int(rng, 0, 20) * hour;
    const core::Seconds max_age = support::uniform_int(rng, 0, 20) * hour;
    std::vector<double> expected;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto replaces = [&](std::size_t j) {
        if (all[j].id != all[i].id || all[i].id.empty() || all[j].observed > as_of) return false;
        return all[j].observed > all[i].observed || (all[j].observed == all[i].observed && j > i);
      };
      bool is_newest = all[i].observed <= as_of && all[i].observed >= as_of - max_age;
      for (std::size_t j = 0; j < all.size(); ++j) is_newest = is_newest && !replaces(j);
      if (is_newest) expected.push_back(all[i].place.lon_deg);
    }
    std::vector<double> found;
    for (const StoredSighting& sighting : icebergs_.latest(dataset_, everywhere, as_of, max_age))
      found.push_back(sighting.iceberg.place.lon_deg);
    EXPECT_EQ(found, expected);
  });
}

TEST_F(IcebergRepositoryTest, DoesNotFindABergWhereItWasBeforeItLeftTheArea) {
  icebergs_.insert(dataset_, {sample_berg("a", {0.0, 0.0}, sample_time - 2 * hour),
                              sample_berg("a", {9.0, 0.0}, sample_time - hour)});

  EXPECT_TRUE(icebergs_.latest(dataset_, {-1.0, -1.0, 1.0, 1.0}, sample_time, day).empty());
}

TEST_F(IcebergRepositoryTest, LeavesOutBergsNotSeenForTooLong) {
  icebergs_.insert(dataset_, {sample_berg("old", {0.0, 0.0}, sample_time - day - core::Seconds{1.0}),
                              sample_berg("just", {0.0, 0.0}, sample_time - day)});

  EXPECT_THAT(ids(icebergs_.latest(dataset_, everywhere, sample_time, day)), testing::ElementsAre("just"));
}

TEST_F(IcebergRepositoryTest, TakesSightingsWithoutANameForDifferentBergs) {
  icebergs_.insert(dataset_, {sample_berg("", {0.0, 0.0}), sample_berg("", {1.0, 0.0})});
  EXPECT_EQ(icebergs_.latest(dataset_, everywhere, sample_time, day).size(), 2U);
}

}  // namespace
}  // namespace floeplan::repository::iceberg_repository_test
