#include "storage/repository/fields/joined_bathymetry.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/empty_store.hpp"

namespace floeplan::repository::joined_bathymetry_test {
namespace {

ocean::Axis axis(double first, double last, std::size_t count) {
  std::vector<double> nodes;
  for (std::size_t i = 0; i < count; ++i)
    nodes.push_back(std::lerp(first, last, static_cast<double>(i) / static_cast<double>(count - 1)));
  return ocean::Axis{nodes};
}

class JoinedBathymetryTest : public testing::Test {
 protected:
  /// An even bed from 60 to 61 degrees north.
  void store(const std::string& name, float depth_m, double west_deg, double east_deg, std::size_t count) {
    Dataset dataset = sample_dataset(name, DatasetKind::bathymetry);
    dataset.bounds = {west_deg, 60.0, east_deg, 61.0};
    DatasetRepository{db_}.insert(dataset);
    FieldRepository fields{db_};
    fields.create(
        {name}, {{geo::GeographicFrame{}, axis(west_deg, east_deg, count), axis(60.0, 61.0, count)}, {}, {}});
    fields.write_slice({name}, "depth_m", 0, 0, std::vector<float>(count * count, depth_m));
  }

  const geo::BoundingBox area_{0.0, 60.0, 4.0, 61.0};
  sql::Connection db_ = support::empty_store();
};

TEST_F(JoinedBathymetryTest, IsTheOnlyDatasetItselfWhereThatIsSmall) {
  store("coarse", 300.0F, 0.0, 4.0, 20);
  const auto joined = joined_bathymetry(db_, area_, 10'000);
  ASSERT_TRUE(joined);
  EXPECT_THAT(joined->datasets, testing::ElementsAre(DatasetId{"coarse"}));
  EXPECT_EQ(joined->depths.grid().size(), 400U);
}

TEST_F(JoinedBathymetryTest, PutsTheFinestInFront) {
  store("coarse", 300.0F, 0.0, 4.0, 20);
  store("fine", 50.0F, 1.0, 2.0, 100);
  const auto joined = joined_bathymetry(db_, area_, 40'000);
  ASSERT_TRUE(joined);
  EXPECT_THAT(joined->datasets, testing::ElementsAre(DatasetId{"fine"}, DatasetId{"coarse"}));
  EXPECT_NEAR(joined->depths.depth({1.5, 60.5})->value, 50.0, 1e-3);
  EXPECT_NEAR(joined->depths.depth({3.5, 60.5})->value, 300.0, 1e-3);
}

TEST_F(JoinedBathymetryTest, HasNoMoreNodesThanAreAskedFor) {
  store("fine", 50.0F, 0.0, 4.0, 300);
  const auto joined = joined_bathymetry(db_, area_, 2'000);
  ASSERT_TRUE(joined);
  EXPECT_LE(joined->depths.grid().size(), 2'500U);  // a row more on each side
  EXPECT_NEAR(joined->depths.depth({1.5, 60.5})->value, 50.0, 1e-3);
}

TEST_F(JoinedBathymetryTest, IsNothingWhereNoDepthIsKnown) {
  EXPECT_FALSE(joined_bathymetry(db_, area_, 1'000));
  store("fine", 50.0F, 0.0, 4.0, 10);
  EXPECT_FALSE(joined_bathymetry(db_, {20.0, 60.0, 21.0, 61.0}, 1'000));
}

}  // namespace
}  // namespace floeplan::repository::joined_bathymetry_test
