#include "storage/repository/features/ice_chart_repository.hpp"

#include <gmock/gmock.h>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/empty_store.hpp"

namespace floeplan::repository::ice_chart_repository_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

geo::Polygon triangle(double west_deg) {
  return {{{west_deg, 70.0}, {geo::wrap_longitude(west_deg + 1.0), 70.0}, {west_deg, 71.0}}, {}};
}

class IceChartRepositoryTest : public testing::Test {
 protected:
  IceChartRepositoryTest() { DatasetRepository{db_}.insert(sample_dataset("chart", DatasetKind::ice)); }

  sql::Connection db_ = support::empty_store();
  IceChartRepository charts_{db_};
};

TEST_F(IceChartRepositoryTest, GivesBackWhatMeetsTheAreaWithItsCodesInTheirOrder) {
  charts_.insert({"chart"}, {{{{"CT", "91"}, {"CA", "60"}}, triangle(-55.0)}, {{}, triangle(10.0)}});

  const auto near = charts_.load({"chart"}, {-56.0, 69.0, -54.0, 72.0});
  ASSERT_EQ(near.size(), 1U);
  EXPECT_THAT(near[0].codes, ElementsAre(IceCode{"CT", "91"}, IceCode{"CA", "60"}));
  EXPECT_EQ(near[0].area.outer, triangle(-55.0).outer);
  const auto other = charts_.load({"chart"}, {9.0, 69.0, 12.0, 72.0});
  ASSERT_EQ(other.size(), 1U);
  EXPECT_THAT(other[0].codes, IsEmpty());
}

TEST_F(IceChartRepositoryTest, FindsWhatLiesAcrossTheAntimeridian) {
  charts_.insert({"chart"}, {{{{"CT", "80"}}, triangle(179.5)}});

  EXPECT_EQ(charts_.load({"chart"}, {-180.0, 69.0, -179.0, 72.0}).size(), 1U);
  EXPECT_EQ(charts_.load({"chart"}, {179.0, 69.0, 180.0, 72.0}).size(), 1U);
  EXPECT_THAT(charts_.load({"chart"}, {-100.0, 69.0, 100.0, 72.0}), IsEmpty());
}

TEST_F(IceChartRepositoryTest, KeepsNothingOfARemovedChart) {
  charts_.insert({"chart"}, {{{{"CT", "80"}}, triangle(-55.0)}});
  ASSERT_TRUE(DatasetRepository{db_}.remove({"chart"}));
  DatasetRepository{db_}.insert(sample_dataset("chart", DatasetKind::ice));

  EXPECT_THAT(charts_.load({"chart"}, {-56.0, 69.0, -54.0, 72.0}), IsEmpty());
}

}  // namespace
}  // namespace floeplan::repository::ice_chart_repository_test
