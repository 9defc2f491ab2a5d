#include "engine/ocean/currents/ensemble_mean.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace floeplan::ocean::ensemble_mean_test {
namespace {

/// Two nodes by two at two times.
std::shared_ptr<const CurrentGrid> grid_of(std::vector<float> u, double west = -53.0) {
  CurrentGrid::Samples samples{.grid = {geo::GeographicFrame{}, Axis{{west, west + 1.0}}, Axis{{69.0, 70.0}}},
                               .depths_m = std::nullopt,
                               .times_s = Axis{{0.0, 3600.0}},
                               .u = u,
                               .v = u};
  return std::make_shared<const CurrentGrid>(std::move(samples));
}

TEST(EnsembleMean, IsTheMeanOfEachSample) {
  const auto mean = ensemble_mean({grid_of({1, 2, 3, 4, 5, 6, 7, 8}), grid_of({3, 2, 1, 0, -1, -2, -3, -4}),
                                   grid_of({2, 2, 2, 2, 2, 2, 2, 2})});

  ASSERT_TRUE(mean.has_value());
  for (const float u : mean->samples().u) EXPECT_FLOAT_EQ(u, 2.0F);
  EXPECT_EQ(mean->samples().v, mean->samples().u);
}

TEST(EnsembleMean, MissesWhatAMemberMisses) {
  const float gap = std::numeric_limits<float>::quiet_NaN();
  const auto mean = ensemble_mean({grid_of({1, 1, 1, 1, 1, 1, 1, 1}), grid_of({1, gap, 1, 1, 1, gap, 1, 1})});

  ASSERT_TRUE(mean.has_value());
  EXPECT_TRUE(mean->column_at_node(0, 0, 0).has_value());
  EXPECT_FALSE(mean->column_at_node(1, 0, 0).has_value());
}

TEST(EnsembleMean, IsNoneOfMembersOnOtherNodes) {
  const auto here = grid_of({1, 1, 1, 1, 1, 1, 1, 1});

  EXPECT_FALSE(ensemble_mean({here, grid_of({1, 1, 1, 1, 1, 1, 1, 1}, -52.9)}).has_value());
  EXPECT_THROW((void)ensemble_mean({}), std::invalid_argument);
}

}  // namespace
}  // namespace floeplan::ocean::ensemble_mean_test
