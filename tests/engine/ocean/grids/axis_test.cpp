#include "engine/ocean/grids/axis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/support/property.hpp"

namespace floeplan::ocean::axis_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Expects `value` to be found on the node `index`, with no share of a neighbour.
void expect_on_node(const Axis& axis, double value, std::size_t index) {
  const auto position = axis.locate(value);
  ASSERT_TRUE(position.has_value()) << value;
  EXPECT_EQ(position->lower, index) << value;
  EXPECT_EQ(position->upper, index) << value;
  EXPECT_EQ(position->fraction, 0.0) << value;
}

TEST(Axis, FindsItsNodesAlsoWithTheRoundingOfFloat32) {
  const Axis even{{0.0, 0.5, 1.0, 1.5}};
  const Axis uneven{{0.0, 5.0, 20.0, 100.0}};

  for (std::size_t i = 0; i < 4; ++i) {
    for (const double rounding : {0.0, 4e-7, -4e-7}) {
      expect_on_node(even, even[i] + rounding, i);
      expect_on_node(uneven, uneven[i] + rounding, i);
    }
  }
}

TEST(Axis, FindsNothingBeyondItsEnds) {
  const Axis axis{{0.0, 0.5, 1.0, 1.5}};

  EXPECT_FALSE(axis.locate(-1e-5).has_value());
  EXPECT_FALSE(axis.locate(1.50001).has_value());
  EXPECT_FALSE(axis.locate(infinity).has_value());
  EXPECT_FALSE(axis.locate(-infinity).has_value());
}

TEST(Axis, FindsNothingAtNotANumber) {
  EXPECT_FALSE((Axis{{0.0, 1.0, 2.0}}.locate(nan).has_value()));
  EXPECT_FALSE((Axis{{0.0, 1.0, 5.0}}.locate(nan).has_value()));
}

TEST(Axis, OfASingleNodeFindsThatNodeOnly) {
  const Axis axis{{10.0}};

  expect_on_node(axis, 10.0, 0);
  EXPECT_FALSE(axis.locate(10.1).has_value());
  EXPECT_EQ(axis.mean_step(), 0.0);
}

TEST(Axis, SharesOutAPlaceBetweenUnevenNodes) {
  const auto position = Axis{{0.0, 5.0, 20.0, 100.0}}.locate(8.0);

  ASSERT_TRUE(position.has_value());
  EXPECT_EQ(position->lower, 1U);
  EXPECT_EQ(position->upper, 2U);
  EXPECT_NEAR(position->fraction, 0.2, 1e-12);
}

TEST(Axis, GivesBackEveryValueBetweenItsEnds) {
  support::for_each_seed(300, [](std::mt19937_64& rng) {
    std::vector<double> nodes{support::uniform(rng, -1000.0, 1000.0)};
    const double unevenness = support::uniform_int(rng, 0, 1) * 0.9 + 0.004;
    const int more = support::uniform_int(rng, 1, 40);
    for (int i = 0; i < more; ++i) {
      nodes.push_back(nodes.back() + 3.0 * support::uniform(rng, 1.0 - unevenness, 1.0 + unevenness));
    }
    const Axis axis{nodes};
    const double value = support::uniform(rng, axis.front(), axis.back());

    const auto position = axis.locate(value);

    ASSERT_TRUE(position.has_value());
    EXPECT_GE(position->fraction, 0.0);
    EXPECT_LT(position->fraction, 1.0);
    const double low = axis[position->lower];
    const double high = axis[position->upper];
    EXPECT_NEAR(low + position->fraction * (high - low), value, 1e-5);
  });
}

TEST(Axis, RefusesNodesThatAreMissingNotFiniteOrNotAscending) {
  EXPECT_THROW((Axis{std::vector<double>{}}), std::invalid_argument);
  EXPECT_THROW((Axis{{0.0, nan}}), std::invalid_argument);
  EXPECT_THROW((Axis{{0.0, infinity}}), std::invalid_argument);
  EXPECT_THROW((Axis{{0.0, 1.0, 1.0}}), std::invalid_argument);
  EXPECT_THROW((Axis{{2.0, 1.0}}), std::invalid_argument);
}

}  // namespace
}  // namespace floeplan::ocean::axis_test
