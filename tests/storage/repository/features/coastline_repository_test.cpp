#include "storage/repository/features/coastline_repository.hpp"

#include <gmock/gmock.h>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/empty_store.hpp"
#include "tests/support/property.hpp"

namespace floeplan::repository::coastline_repository_test {
namespace {

geo::Polygon square(double west_deg, double south_deg, double side_deg) {
  const double east_deg = geo::wrap_longitude(west_deg + side_deg);
  return {{{west_deg, south_deg},
           {east_deg, south_deg},
           {east_deg, south_deg + side_deg},
           {west_deg, south_deg + side_deg}},
          {}};
}

class CoastlineRepositoryTest : public testing::Test {
 protected:
  CoastlineRepositoryTest() {
    DatasetRepository{db_}.insert(sample_dataset("coast", DatasetKind::coastline));
  }

  sql::Connection db_ = support::empty_store();
  CoastlineRepository coastline_{db_};
};

TEST_F(CoastlineRepositoryTest, GivesBackPolygonsWithTheirHoles) {
  geo::Polygon island = square(-54.1, 69.3, 1.0);
  island.holes = {{{-53.9, 69.4}, {-53.8, 69.4}, {-53.8, 69.5}},
                  {{-53.5, 69.6}, {-53.4, 69.6}, {-53.4, 69.7}}};
  coastline_.insert({"coast"}, {island, square(10.0, 0.0, 1.0)});

  const auto land = coastline_.load({"coast"}, {-54.0, 69.0, -53.0, 70.0});

  ASSERT_EQ(land.size(), 1U);
  EXPECT_EQ(land[0].outer, island.outer);
  EXPECT_EQ(land[0].holes, island.holes);
}

TEST_F(CoastlineRepositoryTest, FindsExactlyThePolygonsWhoseBoxMeetsTheArea) {
  std::mt19937_64 places{7};
  std::vector<geo::Polygon> all;
  for (int i = 0; i < 300; ++i) {
    all.push_back(square(support::uniform(places, -180.0, 180.0), support::uniform(places, -80.0, 70.0),
                         support::uniform(places, 0.1, 15.0)));
  }
  coastline_.insert({"coast"}, all);

  support::for_each_seed(100, [&](std::mt19937_64& rng) {
    const double south = support::uniform(rng, -90.0, 80.0);
    const geo::BoundingBox area{support::uniform(rng, -180.0, 180.0), south,
                                support::uniform(rng, -180.0, 180.0), support::uniform(rng, south, 90.0)};
    std::vector<geo::Ring> expected;
    for (const geo::Polygon& polygon : all) {
      if (geo::intersects(area, geo::bounding_box(polygon))) expected.push_back(polygon.outer);
    }
    std::vector<geo::Ring> found;
    for (const geo::Polygon& polygon : coastline_.load({"coast"}, area)) found.push_back(polygon.outer);
    ASSERT_EQ(found, expected);
  });
}

TEST_F(CoastlineRepositoryTest, HasNothingOfAnUnknownDataset) {
  EXPECT_TRUE(coastline_.load({"unknown"}, {-180.0, -90.0, 180.0, 90.0}).empty());
}

}  // namespace
}  // namespace floeplan::repository::coastline_repository_test
