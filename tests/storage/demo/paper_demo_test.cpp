#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/storage/demo/demo_files.hpp"

namespace floeplan::demo::paper_demo_test {
namespace {

TEST(RiverDemo, IsFastestInTheMiddleAndStillAtTheBanks) {
  const auto files = demo_files(Scenario::river, 1, "river");
  const Component north = read_component(files[1], "vo");
  const std::size_t last = north.lon_deg.size() - 1;

  EXPECT_NEAR(north.at(0, 0, 10, last / 2), 1.8 * 0.15, 0.0005);
  EXPECT_NEAR(north.at(0, 0, 10, 0), 0.0, 0.0005);
  EXPECT_NEAR(north.at(1, 0, 10, last), 0.0, 0.0005);
}

TEST(JetDemo, NeitherGathersNorLosesWater) {
  const auto files = demo_files(Scenario::jet, 1, "jet");
  const Component east = read_component(files[1], "uo");
  const Component north = read_component(files[1], "vo");
  constexpr double node_m = 1000.0;

  double largest_per_s = 0.0;
  for (std::size_t row = 1; row + 1 < east.lat_deg.size(); ++row) {
    for (std::size_t column = 1; column + 1 < east.lon_deg.size(); ++column) {
      const double gain = (east.at(9, 0, row, column + 1) - east.at(9, 0, row, column - 1) +
                           north.at(9, 0, row + 1, column) - north.at(9, 0, row - 1, column)) /
                          (2.0 * node_m);
      largest_per_s = std::max(largest_per_s, std::abs(gain));
    }
  }

  const double shear_per_s = 0.7 / 5000.0;
  EXPECT_LT(largest_per_s, 0.05 * shear_per_s);
}

TEST(PaperDemo, WritesTheSameBytesAgain) {
  for (const auto& [scenario, name] :
       {std::pair{Scenario::river, "river"}, std::pair{Scenario::jet, "jet"}}) {
    const auto first = demo_files(scenario, 1, name);
    const auto again = demo_files(scenario, 1, std::string{name} + " again");
    for (std::size_t i = 0; i < first.size(); ++i)
      EXPECT_EQ(bytes_of(first[i]), bytes_of(again[i])) << first[i];
  }
}

}  // namespace
}  // namespace floeplan::demo::paper_demo_test
