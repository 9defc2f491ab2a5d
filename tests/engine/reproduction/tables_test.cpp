#include "engine/reproduction/tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/support/places.hpp"
#include "tests/support/river_crossing.hpp"

namespace floeplan::reproduction::tables_test {
namespace {

struct Golden {
  std::string row;
  double verified_s;
  std::string vertices;
  std::string edges;
};

std::vector<Golden> golden(const std::string& file) {
  std::ifstream stream{support::source_folder() + "/tests/golden/" + file};
  std::vector<Golden> rows;
  std::string line;
  std::getline(stream, line);  // names of the columns
  while (std::getline(stream, line)) {
    std::istringstream cells{line};
    Golden row;
    std::string seconds;
    std::getline(cells, row.row, ',');
    std::getline(cells, seconds, ',');
    std::getline(cells, row.vertices, ',');
    std::getline(cells, row.edges, ',');
    row.verified_s = std::stod(seconds);
    rows.push_back(row);
  }
  return rows;
}

auto find_row(const std::vector<ReproducedRow>& table, const std::string& name) {
  return std::ranges::find_if(table, [&](const ReproducedRow& row) { return row.printed.row == name; });
}

void expect_golden(const std::vector<ReproducedRow>& table, const std::string& file, std::size_t rows) {
  const auto expected = golden(file);
  ASSERT_EQ(expected.size(), rows);
  for (const Golden& wanted : expected) {
    SCOPED_TRACE(wanted.row);
    const auto found = find_row(table, wanted.row);
    ASSERT_NE(found, table.end());
    ASSERT_TRUE(found->ours_s.has_value());
    EXPECT_NEAR(*found->ours_s, wanted.verified_s, 0.0005) << "to the printed digits";
    if (!wanted.vertices.empty()) {
      EXPECT_EQ(std::to_string(found->vertices.value()), wanted.vertices);
      EXPECT_EQ(std::to_string(found->edges.value()), wanted.edges);
      EXPECT_NEAR(found->ours_at_default_tolerance_s.value(), wanted.verified_s, 1e-4 * wanted.verified_s);
    }
  }
}

TEST(Tables, GiveEveryVerifiedTimeAndCountOfTableTwo) {
  expect_golden(reproduce_table_2(), "eichhorn_2009_table_2.csv", 11);
}

TEST(Tables, GiveTheStandInOfTableThreeAndNoDirectWay) {
  const auto table = reproduce_table_3();

  expect_golden(table, "eichhorn_2009_table_3.csv", 9);
  EXPECT_EQ(table.front().printed.row, "direct drive");
  EXPECT_FALSE(table.front().ours_s.has_value());
  EXPECT_NEAR(find_row(table, "1-sector")->deviation_pct.value(), 14.26, 0.005);
  EXPECT_NEAR(find_row(table, "2-sector")->deviation_pct.value(), 4.94, 0.005);
  EXPECT_NEAR(find_row(table, "3-sector")->deviation_pct.value(), 3.33, 0.005);
}

TEST(Tables, GiveTheExtremalOfTheRiverAsTheClosedSolutionHasIt) {
  const auto table = reproduce_table_2();

  const double closed_s =
      support::river_crossing_by_optimal_control(planning::currents::RiverCurrent{}, river_speed).count();
  EXPECT_NEAR(find_row(table, "optimal control")->ours_s.value(), closed_s, 1e-6);
}

TEST(Tables, GiveThePapersPercentages) {
  const auto table = reproduce_table_2();
  const auto row = [&](const std::string& name) { return *find_row(table, name); };

  EXPECT_NEAR(row("optimal control").saving_pct.value(), 9.87, 0.005);
  EXPECT_NEAR(row("direct drive").deviation_pct.value(), 10.96, 0.005);
  EXPECT_NEAR(row("3-sector").saving_pct.value(), 9.56, 0.005);
  EXPECT_NEAR(row("3-sector").deviation_pct.value(), 0.35, 0.005);
}

TEST(Tables, GiveRefinedWaysAsNearTheOptimumAsTheirLegsAllow) {
  struct Expected {
    const char* row;
    double most_deviation_pct;
  };
  const auto check = [](const std::vector<ReproducedRow>& table, const std::vector<Expected>& rows) {
    for (const Expected& expected : rows) {
      SCOPED_TRACE(expected.row);
      const auto row = find_row(table, expected.row);
      ASSERT_NE(row, table.end());
      EXPECT_GT(row->deviation_pct.value(), 0.0);
      EXPECT_LE(row->deviation_pct.value(), expected.most_deviation_pct);
    }
  };

  check(reproduce_table_2(),
        {{"refined, 8 legs", 0.39}, {"refined, 10 legs", 0.32}, {"refined, 16 legs", 0.11}});
  check(reproduce_table_3(), {{"refined, 12 legs", 2.11},
                              {"refined, 21 legs", 0.81},
                              {"refined, 42 legs", 0.23},
                              {"refined, 84 legs", 0.07}});
}

}  // namespace
}  // namespace floeplan::reproduction::tables_test
