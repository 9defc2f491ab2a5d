#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

namespace floeplan::planning::refinement {

/// A function to minimise: writes its gradient and returns its value; empty where it is undefined.
using SmoothFunction =
    std::function<std::optional<double>(std::span<const double> x, std::span<double> gradient)>;

/// Descends from x = 0 by the limited-memory BFGS method until a step lowers the value by less than
/// `relative_tolerance`. The function sees every point that is tried and stores the best itself.
/// Source  Nocedal 1980, Updating quasi-Newton matrices with limited storage, Math. Comp. 35,
///         doi:10.1090/S0025-5718-1980-0572855-7, as implemented in NLopt 2.7
void minimise(const SmoothFunction& function, std::size_t dimension, double relative_tolerance);

}  // namespace floeplan::planning::refinement
