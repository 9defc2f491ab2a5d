#include "engine/planning/refinement/hat_basis.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/property.hpp"

namespace floeplan::planning::refinement::hat_basis_test {
namespace {

cost::Itinerary random_itinerary(std::mt19937_64& rng) {
  cost::Itinerary timed{{{{0.0, 0.0}}, {true}}, {core::Seconds{0.0}}, {0.0}};
  const int legs = support::uniform_int(rng, 1, 40);
  for (int i = 1; i <= legs; ++i) {
    const geo::PlanePoint last = timed.route.points.back();
    timed.route.points.push_back(
        {last.x_m + support::uniform(rng, 0.0, 900.0), last.y_m + support::uniform(rng, -500.0, 500.0)});
    timed.route.fixed.push_back(i == legs || support::uniform_int(rng, 0, 9) == 0);
    timed.append(cost::cost_of_leg(core::Seconds{support::uniform(rng, 100.0, 3000.0)}));
  }
  return timed;
}

std::vector<double> random_numbers(std::mt19937_64& rng, std::size_t count) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(support::uniform(rng, -1.0, 1.0));
  return numbers;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

TEST(HatBasis, HasOneHatForEachFreePointAndNeverShiftsAFixedOne) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    const cost::Itinerary timed = random_itinerary(rng);
    const HatBasis basis{timed};
    ASSERT_EQ(basis.hats().size(), static_cast<std::size_t>(std::ranges::count(timed.route.fixed, false)));

    const std::vector<double> shifts = basis.shifts(random_numbers(rng, basis.hats().size()));

    for (std::size_t i = 0; i < shifts.size(); ++i) EXPECT_EQ(shifts[i] == 0.0, timed.route.fixed[i]);
  });
}

TEST(HatBasis, DerivesByTheTransposeOfItsShifts) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    const cost::Itinerary timed = random_itinerary(rng);
    const HatBasis basis{timed};
    const std::vector<double> coefficients = random_numbers(rng, basis.hats().size());
    const std::vector<double> by_shift = random_numbers(rng, timed.route.points.size());

    std::vector<double> by_coefficient(coefficients.size());
    basis.derive(by_shift, by_coefficient);

    EXPECT_NEAR(dot(by_coefficient, coefficients), dot(by_shift, basis.shifts(coefficients)), 1e-9);
  });
}

TEST(HatBasis, MakesTheDelayOfShiftsAcrossALineTheSumOfTheirSquares) {
  // Legs of different speed on one line: a shift of y[i] across delays by sum t/L^2 (y[i+1] - y[i])^2 / 2.
  support::for_each_seed(50, [](std::mt19937_64& rng) {
    cost::Itinerary timed = random_itinerary(rng);
    for (geo::PlanePoint& point : timed.route.points) point.y_m = 0.0;
    const HatBasis basis{timed};
    const std::vector<double> coefficients = random_numbers(rng, basis.hats().size());

    const std::vector<double> shifts = basis.shifts(coefficients);

    double delay = 0.0;
    for (std::size_t i = 1; i < shifts.size(); ++i) {
      const double length = timed.route.points[i].x_m - timed.route.points[i - 1].x_m;
      const double slope = (shifts[i] - shifts[i - 1]) / length;
      delay += 0.5 * (timed.times[i] - timed.times[i - 1]).count() * slope * slope;
    }
    EXPECT_NEAR(delay, 0.5 * dot(coefficients, coefficients), 1e-6 * (1.0 + delay));
  });
}

}  // namespace
}  // namespace floeplan::planning::refinement::hat_basis_test
