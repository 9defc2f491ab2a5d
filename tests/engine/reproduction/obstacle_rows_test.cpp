#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "engine/motion/edge_time.hpp"
#include "engine/planning/currents/analytic_currents.hpp"
#include "engine/reproduction/case_search.hpp"
#include "engine/reproduction/paper_cases.hpp"

namespace floeplan::reproduction::obstacle_rows_test {
namespace {

constexpr double tolerance = 1e-4;

/// Earliest arrival at the goal by relaxing every edge until nothing changes: no queue, no stencil, no graph.
struct BruteForce {
  const GridCase& searched;
  int vertices{};
  int edges{};
  double arrival_s{};

  explicit BruteForce(const GridCase& the_case) : searched{the_case} {
    const CaseGrid& grid = searched.grid;
    std::vector<double> arrival(index({grid.nx - 1, grid.ny - 1}) + 1, INFINITY);
    arrival[index(grid.start)] = 0.0;
    for (bool changed = true; changed;) {
      vertices = 0;
      edges = 0;
      changed = false;
      for (int row = 0; row < grid.ny; ++row) {
        for (int column = 0; column < grid.nx; ++column) {
          if (!open({column, row}, {column, row})) continue;
          ++vertices;
          changed = relax_from({column, row}, arrival) || changed;
        }
      }
    }
    arrival_s = arrival[index(grid.goal)];
  }

 private:
  [[nodiscard]] std::size_t index(Node node) const {
    return static_cast<std::size_t>(node.row * searched.grid.nx + node.column);
  }
  [[nodiscard]] bool open(Node a, Node b) const {
    const CaseGrid& grid = searched.grid;
    const bool inside = b.column >= 0 && b.column < grid.nx && b.row >= 0 && b.row < grid.ny;
    return inside && searched.is_open(grid.point(a), grid.point(b));
  }

  bool relax_from(Node tail, std::vector<double>& arrival) {
    bool changed = false;
    for (int dy = -searched.sectors; dy <= searched.sectors; ++dy) {
      for (int dx = -searched.sectors; dx <= searched.sectors; ++dx) {
        const Node head{tail.column + dx, tail.row + dy};
        if (std::gcd(dx, dy) != 1 || !open(tail, head)) continue;
        ++edges;
        const double leave_s = arrival[index(tail)];
        if (!std::isfinite(leave_s)) continue;
        const core::Metres length{std::hypot(dx * searched.grid.dx, dy * searched.grid.dy)};
        const auto time = motion::edge_time(
            {searched.grid.point(tail), searched.grid.point(head), length}, core::Seconds{leave_s}, jet_speed,
            planning::currents::MeanderingJet{}, {.relative_tolerance = tolerance});
        if (!time || leave_s + time->count() >= arrival[index(head)]) continue;
        arrival[index(head)] = leave_s + time->count();
        changed = true;
      }
    }
    return changed;
  }
};

void expect_as_by_brute_force(const std::string& row, std::int64_t paper_edges) {
  const std::vector<PaperCase> cases = jet_cases();
  const GridCase& searched = find_case(cases, row).searched;

  const planning::currents::MeanderingJet jet;
  const auto found = CaseSearch{searched, jet, jet_speed, tolerance}.fastest();

  const BruteForce brute{searched};
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->duration().count(), brute.arrival_s, 1e-9);
  EXPECT_EQ(brute.vertices, 816) << "as many as in the paper";
  EXPECT_EQ(searched.count_open_edges(), brute.edges);
  EXPECT_NEAR(static_cast<double>(brute.edges), static_cast<double>(paper_edges),
              0.001 * static_cast<double>(paper_edges));
  for (std::size_t i = 1; i < found->points.size(); ++i) {
    EXPECT_TRUE(searched.is_open(found->points[i - 1], found->points[i]));
  }
}

TEST(ObstacleRows, AreFoundByBruteForceOnTheOneSectorGrid) {
  expect_as_by_brute_force("1-sector with obstacles", 5910);
}

TEST(ObstacleRows, AreFoundByBruteForceOnTheTwoSectorGrid) {
  expect_as_by_brute_force("2-sector with obstacles", 11195);
}

TEST(ObstacleRows, AreFoundByBruteForceOnTheThreeSectorGrid) {
  expect_as_by_brute_force("3-sector with obstacles", 20517);
}

}  // namespace
}  // namespace floeplan::reproduction::obstacle_rows_test
