#include "storage/ingest/grids/s_coordinate.hpp"

#include <gtest/gtest.h>

namespace floeplan::ingest::s_coordinate_test {
namespace {

/// A level of a model's own output file: s_rho and Cs_r as ROMS wrote them.
struct StretchedLevel {
  int form;
  double theta_s;
  double theta_b;
  double s;
  double stretching;
  double tolerance;  // of the file's packing
};

TEST(SCoordinate, StretchesAsTheModelsThemselvesDo) {
  // NorFjords 160 m (float64) and Nordic 4 km of MET Norway (packed to 1.4e-5).
  for (const StretchedLevel& level :
       {StretchedLevel{2, 8.0, 0.1, -0.9857142857142857, -0.9830769932540195, 1e-14},
        StretchedLevel{2, 8.0, 0.1, -0.7, -0.3891781446306453, 1e-14},
        StretchedLevel{2, 8.0, 0.1, -0.41428571428571426, -0.07831664462181134, 1e-14},
        StretchedLevel{1, 6.0, 0.1, -0.9857142857142857, -0.9260235141122424, 1e-5},
        StretchedLevel{1, 6.0, 0.1, -0.7, -0.24062725226484552, 1e-5},
        StretchedLevel{1, 6.0, 0.1, -0.41428571428571426, -0.052830427933085455, 1e-5}}) {
    const auto stretching = s_stretching(level.form, level.s, level.theta_s, level.theta_b);
    ASSERT_TRUE(stretching.has_value());
    EXPECT_NEAR(*stretching, level.stretching, level.tolerance);
  }
}

TEST(SCoordinate, RunsFromTheBedToTheSurfaceInEveryForm) {
  for (const int form : {1, 2, 4}) {
    EXPECT_NEAR(s_stretching(form, -1.0, 5.0, 0.4).value(), -1.0, 1e-12) << form;
    EXPECT_NEAR(s_stretching(form, 0.0, 5.0, 0.4).value(), 0.0, 1e-12) << form;
  }
  for (const SCoordinate form : {SCoordinate::g1, SCoordinate::g2}) {
    EXPECT_NEAR(s_level_height_m(form, -1.0, -1.0, 20.0, 300.0, 1.5), -300.0, 1e-9);
    EXPECT_NEAR(s_level_height_m(form, 0.0, 0.0, 20.0, 300.0, 1.5), 1.5, 1e-9);
  }
}

TEST(SCoordinate, DoesNotGuessAnUnknownStretching) { EXPECT_FALSE(s_stretching(7, -0.5, 5.0, 0.4)); }

}  // namespace
}  // namespace floeplan::ingest::s_coordinate_test
