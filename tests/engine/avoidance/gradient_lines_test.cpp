#include "engine/avoidance/gradient_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/avoidance/steering.hpp"

namespace floeplan::avoidance::gradient_lines_test {
namespace {

using Shape = std::vector<Obstacle>;

void add_line(Shape& shape, geo::PlanePoint from, geo::PlanePoint to) {
  const double length = distance_m(from, to);
  for (double along = 0.0; along <= length; along += 6.0) {
    shape.push_back({moved(from, direction_rad(from, to), along), {}, 4.5, 0.0, false});
  }
}

Shape arc(double radius_m, double from_deg, double to_deg) {
  Shape shape;
  for (double angle = from_deg; angle <= to_deg; angle += 5.0) {
    shape.push_back({moved({0.0, 0.0}, core::degrees_to_radians(angle), radius_m), {}, 4.5, 0.0, false});
  }
  return shape;
}

/// The length of the path from a place to the goal, in metres, of a vehicle that follows the commanded
/// courses and turns without delay. Infinite if it has not arrived after ten times the straight distance.
double way_m(const Shape& shape, geo::PlanePoint from, geo::PlanePoint goal, double clearance_m) {
  GradientLines lines{AvoidanceSettings{}};
  constexpr double speed = 0.35;
  constexpr double step_s = 4.0;
  geo::PlanePoint own = from;
  const double most_m = 10.0 * distance_m(from, goal) + 1000.0;
  for (double way = 0.0; way < most_m; way += speed * step_s) {
    const double left_m = distance_m(own, goal);
    if (left_m < 5.0) return way;
    const GradientCourse course = lines.steer(own, speed, direction_rad(own, goal), left_m / speed, shape);
    own = moved(own, course.heading_rad, speed * step_s);
    for (const Obstacle& patch : shape) {
      EXPECT_GT(distance_m(own, patch.centre), patch.radius_m + clearance_m) << own.x_m << " " << own.y_m;
      if (testing::Test::HasFailure()) return 0.0;
    }
  }
  return std::numeric_limits<double>::infinity();
}

TEST(GradientLines, SteersForTheGoalWhereThatIsFree) {
  GradientLines lines{AvoidanceSettings{}};
  const GradientCourse course = lines.steer({0.0, 0.0}, 0.35, 1.0, 1000.0, {});
  EXPECT_EQ(course.heading_rad, 1.0);
  EXPECT_FALSE(course.boxed_in);
  EXPECT_EQ(lines.side(), 0);
}

TEST(GradientLines, HoldsTheSideItTookUp) {
  GradientLines lines{AvoidanceSettings{}};
  Shape wall;
  add_line(wall, {100.0, -80.0}, {100.0, 100.0});
  const double east = std::numbers::pi / 2.0;
  (void)lines.steer({0.0, 0.0}, 0.35, east, 1000.0, wall);
  EXPECT_EQ(lines.side(), 1);  // the south end is nearer
  (void)lines.steer({0.0, 25.0}, 0.35, east, 1000.0, wall);
  EXPECT_EQ(lines.side(), 1);
}

/// The vehicle starts at places all around every stated shape; it never stays at one place.
TEST(GradientLines, HasNoLocalMinimumAroundTheStatedShapes) {
  Shape wall;
  add_line(wall, {0.0, -90.0}, {0.0, 90.0});
  Shape corner;
  add_line(corner, {0.0, -90.0}, {0.0, 90.0});
  add_line(corner, {0.0, 90.0}, {-110.0, 90.0});
  Shape hollow = corner;
  add_line(hollow, {0.0, -90.0}, {-110.0, -90.0});
  const std::vector<std::pair<std::string, Shape>> shapes{
      {"disc", arc(60.0, 0.0, 355.0)},  {"wall", wall}, {"corner", corner}, {"hollow", hollow},
      {"bay", arc(90.0, -20.0, 200.0)},
  };
  for (const auto& [name, shape] : shapes) {
    for (const double north : {-200.0, -60.0, 0.0, 7.0, 60.0, 200.0}) {
      for (const double west : {-300.0, -50.0}) {
        if (west > -100.0 && (name == "disc" || std::abs(north) == 60.0))
          continue;  // in it, or nearer than the clearance
        const double way = way_m(shape, {west, north}, {300.0, 0.0}, 15.0);
        EXPECT_TRUE(std::isfinite(way)) << name << " from " << west << " " << north;
      }
    }
  }
}

TEST(GradientLines, SaysWhenEveryHeadingEndsInContact) {
  GradientLines lines{AvoidanceSettings{}};
  Shape ring = arc(50.0, 0.0, 355.0);
  for (Obstacle& patch : ring) {  // that closes in
    patch.drift = {-0.005 * patch.centre.x_m, -0.005 * patch.centre.y_m};
  }
  const GradientCourse course = lines.steer({0.0, 0.0}, 0.35, 0.0, 1000.0, ring);
  EXPECT_TRUE(course.boxed_in);
}

}  // namespace
}  // namespace floeplan::avoidance::gradient_lines_test
