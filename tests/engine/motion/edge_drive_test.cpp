#include "engine/motion/edge_drive.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/motion/runge_kutta.hpp"
#include "tests/engine/motion/patchwork.hpp"

namespace floeplan::motion::edge_drive_test {
namespace {

constexpr core::MetresPerSecond glider{0.35};
constexpr core::Metres length{4'000.0};
constexpr core::Seconds no_limit{INFINITY};

template <class Step>
tl::expected<core::Seconds, EdgeClosed> drive(const Patchwork& patchwork, double depart_s, double tolerance) {
  Patchwork::Line line{patchwork};
  return EdgeDrive<Step, Patchwork::Line>{line, length, glider, tolerance}.run(core::Seconds{depart_s},
                                                                               no_limit, VisitNoPiece{});
}

struct Reference {
  double time_s{};
  double longest_step_s{};
  double least_room_m_s{INFINITY};  // over all its points; the edge is closed where it is not positive
};

/// dt/ds = 1 / v(s, t) in ten thousand equal steps of the way (classical Runge-Kutta).
Reference reference(const Patchwork& patchwork, double depart_s) {
  constexpr int steps = 10'000;
  const double h = length.value / steps;
  const double v = glider.value;
  const double v_min = 0.01 * v;
  Reference result;
  double t = depart_s;
  const auto look = [&](double way_m) {
    const CurrentOnEdge c = patchwork.at(way_m, t);
    const double beyond = v - std::hypot(std::min(c.along_m_s - v_min, 0.0), c.across_m_s);
    result.least_room_m_s = std::min(result.least_room_m_s, beyond);
  };
  const auto slowness = [&](double way_m, double t_s) {
    const CurrentOnEdge c = patchwork.at(way_m, t_s);
    return 1.0 / (c.along_m_s + std::sqrt(std::max(0.0, v * v - c.across_m_s * c.across_m_s)));
  };
  look(0.0);
  for (int i = 0; i < steps && result.least_room_m_s > 0.0; ++i) {
    const double s = h * i;
    const double k1 = slowness(s, t);
    const double k2 = slowness(s + 0.5 * h, t + 0.5 * h * k1);
    const double k3 = slowness(s + 0.5 * h, t + 0.5 * h * k2);
    const double k4 = slowness(s + h, t + h * k3);
    const double step_s = h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    result.longest_step_s = std::max(result.longest_step_s, step_s);
    t += step_s;
    look(s + h);
  }
  result.time_s = t - depart_s;
  return result;
}

/// How near to its closing the edge is too uncertain to be compared: the current changes by up to 4e-4 m/s
/// each second between two points of the reference, and while a vehicle is a tolerance late.
double too_close_to_call_m_s(double tolerance, const Reference& expected) {
  return 4e-4 * (expected.longest_step_s + tolerance * expected.time_s);
}

template <class Step>
void expect_agreement(const Patchwork& patchwork, double depart_s, double tolerance,
                      const Reference& expected) {
  if (std::abs(expected.least_room_m_s) < too_close_to_call_m_s(tolerance, expected)) return;
  const auto time = drive<Step>(patchwork, depart_s, tolerance);
  ASSERT_EQ(time.has_value(), expected.least_room_m_s > 0.0) << "room " << expected.least_room_m_s;
  if (time) {
    // A vehicle that hardly moves waits for the next hour: the reference's own steps are too long for that.
    if (expected.least_room_m_s < 0.01) return;
    EXPECT_NEAR(time->count(), expected.time_s, tolerance * expected.time_s) << "tolerance " << tolerance;
  } else {
    EXPECT_EQ(time.error(), EdgeClosed::current_too_strong);
  }
}

TEST(EdgeDrive, AgreesWithAFineReferenceBothWaysWhetherTheEdgeIsOpenOrNot) {
  int open = 0;
  int closed = 0;
  support::for_each_seed(300, [&](std::mt19937_64& rng) {
    const Patchwork there{rng, length.value, support::uniform(rng, 0.05, 0.45)};
    const double depart_s = support::uniform(rng, 0.0, 7'200.0);
    for (const Patchwork& patchwork : {there, there.reversed()}) {
      const Reference expected = reference(patchwork, depart_s);
      if (expected.time_s > 3600.0 * (Patchwork::hours - 3)) continue;  // the data end
      (expected.least_room_m_s > 0.0 ? open : closed) += 1;
      for (const double tolerance : {1e-4, 1e-5}) {
        expect_agreement<BogackiShampine>(patchwork, depart_s, tolerance, expected);
      }
      for (const double tolerance : {1e-6}) {
        expect_agreement<DormandPrince>(patchwork, depart_s, tolerance, expected);
      }
    }
  });
  EXPECT_GT(open, 100);
  EXPECT_GT(closed, 50);
}

/// One stretch in space and time for the whole edge.
struct SingleStretch {
  QuadraticStretch current;

  static bool begin(core::Seconds) { return true; }
  [[nodiscard]] const QuadraticStretch& stretch() const { return current; }
  static bool pass_way() { return false; }
  static bool pass_time() { return false; }
};

TEST(EdgeDrive, SeesACurrentThatIsTooStrongBetweenThePointsOfItsSteps) {
  // A cross current slightly stronger than the glider, on two hundredths of the edge about its peak.
  constexpr double peak_m_s = 0.3501;
  constexpr double bend = -0.69 / (4'000.0 * 4'000.0);
  for (int place = 2; place <= 98; ++place) {
    const double peak_m = 0.01 * place * length.value;
    SingleStretch line;
    line.current.at_start = {
        {0.0, peak_m_s + bend * peak_m * peak_m}, {0.0, -2.0 * bend * peak_m}, {0.0, bend}};

    const auto time = EdgeDrive<BogackiShampine, SingleStretch>{line, length, glider, 1e-1}.run(
        core::Seconds{0.0}, no_limit, VisitNoPiece{});

    ASSERT_FALSE(time.has_value()) << "peak at " << peak_m;
    EXPECT_EQ(time.error(), EdgeClosed::current_too_strong);
  }
}

TEST(EdgeDrive, NeverArrivesEarlierForLeavingLater) {
  constexpr double tolerance = 1e-6;
  support::for_each_seed(500, [](std::mt19937_64& rng) {
    const Patchwork patchwork{rng, length.value, 0.2};
    const double early_s = support::uniform(rng, 0.0, 20'000.0);
    const double late_s = early_s + std::exp(support::uniform(rng, -1.0, 9.0));

    const auto early = drive<DormandPrince>(patchwork, early_s, tolerance);
    const auto late = drive<DormandPrince>(patchwork, late_s, tolerance);

    if (!early || !late) return;
    EXPECT_LE(early_s + early->count(), late_s + late->count() + tolerance * (*early + *late).count());
  });
}

}  // namespace
}  // namespace floeplan::motion::edge_drive_test
