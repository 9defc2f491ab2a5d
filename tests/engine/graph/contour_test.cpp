#include "engine/graph/contour.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/support/property.hpp"

namespace floeplan::graph::contour_test {
namespace {

/// A field on a grid, contoured where it equals a level with linear interpolation.
struct Field {
  int nx{};
  int ny{};
  std::vector<double> values;

  [[nodiscard]] std::vector<GridPolygon> below(double level) const {
    std::vector<std::uint8_t> inside;
    for (const double value : values) inside.push_back(value <= level ? 1 : 0);
    return contour(nx, ny, inside,
                   [&](Vertex in, Vertex out) { return (level - values[in]) / (values[out] - values[in]); });
  }
};

Field field(int nx, int ny, const std::function<double(double column, double row)>& value) {
  Field result{nx, ny, {}};
  for (int y = 0; y < ny; ++y) {
    for (int x = 0; x < nx; ++x) result.values.push_back(value(x, y));
  }
  return result;
}

double area(const GridRing& ring) {
  double sum = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridPlace& a = ring[i];
    const GridPlace& b = ring[(i + 1) % ring.size()];
    sum += 0.5 * (a.column * b.row - b.column * a.row);
  }
  return sum;
}

double area(const std::vector<GridPolygon>& polygons) {
  double sum = 0.0;
  for (const GridPolygon& polygon : polygons) {
    sum += area(polygon.outer);
    for (const GridRing& hole : polygon.holes) sum += area(hole);
  }
  return sum;
}

bool contains(const GridRing& ring, double column, double row) {
  bool odd = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridPlace& a = ring[i];
    const GridPlace& b = ring[(i + 1) % ring.size()];
    if ((a.row > row) != (b.row > row) &&
        a.column + (row - a.row) / (b.row - a.row) * (b.column - a.column) > column) {
      odd = !odd;
    }
  }
  return odd;
}

bool contains(const std::vector<GridPolygon>& polygons, double column, double row) {
  bool odd = false;
  for (const GridPolygon& polygon : polygons) {
    odd ^= contains(polygon.outer, column, row);
    for (const GridRing& hole : polygon.holes) odd ^= contains(hole, column, row);
  }
  return odd;
}

TEST(Contour, OfADistanceIsACircle) {
  const auto polygons =
      field(41, 41, [](double x, double y) { return std::hypot(x - 20.0, y - 20.0); }).below(15.3);

  ASSERT_EQ(polygons.size(), 1U);
  EXPECT_TRUE(polygons.front().holes.empty());
  EXPECT_NEAR(area(polygons), std::numbers::pi * 15.3 * 15.3, 0.005 * std::numbers::pi * 15.3 * 15.3);
  for (const GridPlace& place : polygons.front().outer) {
    EXPECT_NEAR(std::hypot(place.column - 20.0, place.row - 20.0), 15.3, 0.02);
  }
}

TEST(Contour, OfARingRunsCounterClockwiseOutsideAndClockwiseRoundTheHole) {
  const auto polygons = field(41, 41, [](double x, double y) {
                          return std::abs(std::hypot(x - 20.0, y - 20.0) - 10.0);
                        }).below(4.0);

  ASSERT_EQ(polygons.size(), 1U);
  ASSERT_EQ(polygons.front().holes.size(), 1U);
  EXPECT_GT(area(polygons.front().outer), 0.0);
  EXPECT_LT(area(polygons.front().holes.front()), 0.0);
}

TEST(Contour, PutsAnIslandInsideAHoleIntoAPolygonOfItsOwn) {
  const auto polygons = field(41, 41, [](double x, double y) {
                          const double from_centre = std::hypot(x - 20.0, y - 20.0);
                          return from_centre < 7.0 ? from_centre - 5.0 : std::abs(from_centre - 12.5) - 2.5;
                        }).below(0.0);

  ASSERT_EQ(polygons.size(), 2U) << "a ring and the disc in its hole";
  EXPECT_EQ(polygons[0].holes.size(), 1U);
  EXPECT_TRUE(polygons[1].holes.empty());
}

TEST(Contour, PartsInsideVerticesThatFaceEachOtherAcrossACell) {
  const std::vector<std::uint8_t> inside{1, 0,  //
                                         0, 1};

  const auto polygons = contour(2, 2, inside, [](Vertex, Vertex) { return 0.5; });

  EXPECT_EQ(polygons.size(), 2U);
}

TEST(Contour, EndsOnTheRimOfTheGrid) {
  const auto polygons = contour(3, 2, std::vector<std::uint8_t>(6, 1), [](Vertex, Vertex) { return 0.5; });

  ASSERT_EQ(polygons.size(), 1U);
  EXPECT_NEAR(area(polygons), 2.0, 1e-4);
}

TEST(Contour, IsNothingWhereNothingIsInside) {
  EXPECT_TRUE(contour(3, 2, std::vector<std::uint8_t>(6, 0), [](Vertex, Vertex) { return 0.5; }).empty());
}

TEST(Contour, HoldsTheVerticesInsideAndNoOthersAndGrowsWithTheLevel) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    const Field rough = field(9, 7, [&](double, double) { return support::uniform(rng, 0.0, 1.0); });
    const double low = support::uniform(rng, 0.1, 0.9);
    const double high = support::uniform(rng, low, 0.95);
    const auto small = rough.below(low);
    const auto large = rough.below(high);

    for (int y = 0; y < rough.ny; ++y) {
      for (int x = 0; x < rough.nx; ++x) {
        const bool inside = rough.values[static_cast<std::size_t>(y * rough.nx + x)] <= low;
        // Slightly beside the vertex, because a ray through the vertices would meet the ends of borders.
        const double column = x < 8 ? x + 1e-9 : x - 1e-9;
        const double row = y < 6 ? y + 1e-9 : y - 1e-9;
        EXPECT_EQ(contains(small, column, row), inside) << x << ' ' << y;
      }
    }
    for (int i = 0; i < 200; ++i) {
      const double column = support::uniform(rng, 0.0, 8.0);
      const double row = support::uniform(rng, 0.0, 6.0);
      EXPECT_LE(contains(small, column, row), contains(large, column, row)) << column << ' ' << row;
    }
  });
}

/// If borders would lie on the vertices, their places stay farther apart than the rounding of documents: a
/// centimetre for cells of some tens of metres.
TEST(Contour, KeepsItsPlacesApartAlsoWhenTheyAreRounded) {
  std::vector<std::uint8_t> inside(9 * 9, 0);
  for (const int vertex : {30, 31, 39, 40, 50}) inside[static_cast<std::size_t>(vertex)] = 1;

  for (const GridPolygon& polygon : contour(9, 9, inside, [](Vertex, Vertex) { return 0.0; })) {
    for (std::size_t i = 0; i < polygon.outer.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_GT(std::hypot(polygon.outer[i].column - polygon.outer[j].column,
                             polygon.outer[i].row - polygon.outer[j].row),
                  5e-4);
  }
}

}  // namespace
}  // namespace floeplan::graph::contour_test
