#include "engine/planning/refinement/minimiser.hpp"

#include <nlopt.hpp>
#include <vector>

namespace floeplan::planning::refinement {
namespace {

constexpr int most_calls = 200;  // 30 to 150 were needed in trials, whatever the dimension
/// Value for the line search where the function is undefined: larger than all known values, but finite, because it
/// interpolates.
constexpr double no_value = 1e30;

double call(const std::vector<double>& x, std::vector<double>& gradient, void* data) {
  const auto& function = *static_cast<const SmoothFunction*>(data);
  std::vector<double> unused;
  if (gradient.empty()) unused.resize(x.size());
  std::vector<double>& into = gradient.empty() ? unused : gradient;
  if (const auto value = function(x, into)) return *value;
  into.assign(into.size(), 0.0);
  return no_value;
}

}  // namespace

void minimise(const SmoothFunction& function, std::size_t dimension, double relative_tolerance) {
  nlopt::opt method{nlopt::LD_LBFGS, static_cast<unsigned>(dimension)};
  SmoothFunction copy = function;
  method.set_min_objective(call, &copy);
  method.set_ftol_rel(relative_tolerance);
  method.set_maxeval(most_calls);
  std::vector<double> x(dimension, 0.0);
  double value{};
  try {
    method.optimize(x, value);
    // NOLINTNEXTLINE(bugprone-empty-catch): the line search found no better point, and the best one is stored
    // already
  } catch (const std::runtime_error&) {
  }
}

}  // namespace floeplan::planning::refinement
