#include "engine/ocean/currents/tide_overlay.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

namespace floeplan::ocean {
namespace {

constexpr double most_samples = 16e6;  // of two floats each in a planning area: 128 MB
constexpr core::Seconds longest_step{3600.0};

/// Time steps that divide `whole` (the data's own step, or the period) into equal parts.
TidalCurrents::Times times_of(const TidePeriod& period, core::Seconds whole, core::Seconds wanted,
                              std::size_t nodes) {
  const core::Seconds span = period.to - period.from;
  const double most_steps = std::max(2.0, std::floor(most_samples / static_cast<double>(nodes)));
  const core::Seconds affordable{std::min(longest_step, span / (most_steps - 1.0))};
  const core::Seconds step = whole / std::ceil(whole / std::max(wanted, affordable));
  const double steps = std::min(std::floor(span / step + 1e-6) + 1.0, most_steps);
  return {period.from, step, static_cast<std::size_t>(steps)};
}

}  // namespace

CurrentGrid with_tide(const CurrentGrid& currents, const std::vector<TideGrid>& models,
                      const TidePeriod& period) {
  const CurrentGrid::Samples& samples = currents.samples();
  const Axis& data_times = samples.times_s;
  const bool steady = data_times.size() == 1;
  const TidePeriod covered = steady ? period
                                    : TidePeriod{core::from_unix_seconds(data_times.front()),
                                                 core::from_unix_seconds(data_times.back())};
  const core::Seconds whole = steady ? covered.to - covered.from : core::Seconds{data_times.mean_step()};
  const auto times = times_of(covered, whole, straight_step(models), samples.grid.size());
  return CurrentGrid{samples, std::make_shared<const TidalCurrents>(samples.grid, models, times)};
}

CurrentGrid tide_alone(const std::vector<TideGrid>& models, const TidePeriod& period) {
  const auto first =
      std::ranges::find_if(models, [](const TideGrid& model) { return model.has(TideQuantity::east); });
  if (first == models.end()) throw std::invalid_argument{"no tide model here has currents"};
  const HorizontalGrid& grid = first->samples().grid;
  const CurrentGrid still{{.grid = grid,
                           .depths_m = std::nullopt,
                           .times_s = Axis{{core::unix_seconds(period.from)}},
                           .u = std::vector<float>(grid.size()),
                           .v = std::vector<float>(grid.size())}};
  return with_tide(still, models, period);
}

}  // namespace floeplan::ocean
