#include "storage/repository/fields/field_overviews.hpp"

#include <gtest/gtest.h>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/empty_store.hpp"

namespace floeplan::repository::field_overviews_test {
namespace {

ocean::Axis axis(double first, double step, std::size_t count) {
  std::vector<double> nodes;
  for (std::size_t i = 0; i < count; ++i) nodes.push_back(first + step * static_cast<double>(i));
  return ocean::Axis{nodes};
}

/// A bed that falls evenly, so that it can be told between any nodes.
double depth_m_at(double lon_deg, double lat_deg) { return 100.0 + 20.0 * lon_deg + 30.0 * (lat_deg - 60.0); }

class FieldOverviewsTest : public testing::Test {
 protected:
  void store(std::size_t nx, std::size_t ny) {
    DatasetRepository{db_}.insert(sample_dataset(id_.value, DatasetKind::bathymetry));
    const ocean::HorizontalGrid grid{geo::GeographicFrame{}, axis(0.0, 0.005, nx), axis(60.0, 0.005, ny)};
    FieldRepository fields{db_};
    fields.create(id_, {grid, {}, {}});
    std::vector<float> depths_m;
    for (std::size_t iy = 0; iy < ny; ++iy)
      for (std::size_t ix = 0; ix < nx; ++ix)
        depths_m.push_back(static_cast<float>(depth_m_at(grid.x()[ix], grid.y()[iy])));
    fields.write_slice(id_, "depth_m", 0, 0, depths_m);
    FieldOverviews{db_}.make(id_, "depth_m");
  }

  const DatasetId id_{"bed"};
  sql::Connection db_ = support::empty_store();
};

TEST_F(FieldOverviewsTest, ShowsTheWholeOfALargeFieldByNoMoreNodesThanAskedFor) {
  store(2101, 2003);  // neither a multiple of the nodes left out
  const geo::BoundingBox all{0.0, 60.0, 10.5, 70.01};

  const auto seen = FieldOverviews{db_}.bathymetry(id_, all, 300'000);

  ASSERT_TRUE(seen);
  EXPECT_LE(seen->grid().size(), 300'000U);
  for (const double lon : {0.0, 3.21, 7.777, 10.5}) {
    for (const double lat : {60.0, 64.002, 70.01}) {
      const auto depth = seen->depth({lon, lat});
      ASSERT_TRUE(depth) << lon << ' ' << lat;
      EXPECT_NEAR(depth->value, depth_m_at(lon, lat), 1e-3);
    }
  }
}

TEST_F(FieldOverviewsTest, ShowsASmallPartByTheFieldItself) {
  store(2101, 2003);
  const geo::BoundingBox part{5.0, 65.0, 5.1, 65.1};

  const auto seen = FieldOverviews{db_}.bathymetry(id_, part, 300'000);
  const auto exact = FieldRepository{db_}.load_bathymetry(id_, part);

  ASSERT_TRUE(seen && exact);
  EXPECT_EQ(seen->depth_m(), exact->depth_m());
  EXPECT_EQ(seen->grid().x().nodes(), exact->grid().x().nodes());
}

TEST_F(FieldOverviewsTest, AreNotMadeOfASmallField) {
  store(100, 100);
  EXPECT_EQ(FieldRepository{db_}.variables(id_), std::vector<std::string>{"depth_m"});
  EXPECT_EQ(FieldOverviews{db_}.bathymetry(id_, {0.0, 60.0, 1.0, 61.0}, 10)->grid().size(), 100U * 100U);
}

TEST_F(FieldOverviewsTest, ShowNothingWhereThereIsNothing) {
  store(100, 100);
  EXPECT_FALSE(FieldOverviews{db_}.bathymetry(id_, {100.0, 0.0, 101.0, 1.0}, 10));
  EXPECT_FALSE(FieldOverviews{db_}.bathymetry({"unknown"}, {0.0, 60.0, 1.0, 61.0}, 10));
}

}  // namespace
}  // namespace floeplan::repository::field_overviews_test
