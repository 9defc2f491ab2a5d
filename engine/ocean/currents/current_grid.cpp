#include "engine/ocean/currents/current_grid.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

#include "engine/ocean/grids/bilinear.hpp"

namespace floeplan::ocean {
namespace {

geo::VelocityEn blend(geo::VelocityEn a, geo::VelocityEn b, double share_of_b) {
  return {a.east + share_of_b * (b.east - a.east), a.north + share_of_b * (b.north - a.north)};
}

std::size_t depth_count(const CurrentGrid::Samples& samples) {
  return samples.depths_m ? samples.depths_m->size() : 1;
}

/// The first level also counts for the water above it: it is the middle of a model's uppermost layer.
std::optional<AxisPosition> located(const Axis& levels_m, core::Metres depth) {
  if (depth.value >= 0.0 && depth.value < levels_m[0]) return levels_m.locate(levels_m[0]);
  return levels_m.locate(depth.value);
}

}  // namespace

CurrentGrid::CurrentGrid(Samples samples) : CurrentGrid{std::move(samples), nullptr} {}

CurrentGrid::CurrentGrid(Samples samples, std::shared_ptr<const TidalCurrents> tide)
    : samples_{std::make_shared<const Samples>(std::move(samples))},
      gaps_{std::make_shared<Gaps>()},
      tide_{std::move(tide)} {
  const std::size_t wanted = samples_->grid.size() * depth_count(*samples_) * samples_->times_s.size();
  if (samples_->u.size() != wanted || samples_->v.size() != wanted) {
    throw std::invalid_argument{"currents need one u and one v for each node, depth and time"};
  }
  if (!tide_) return;
  for (const double time_s : tide_->times_s().nodes()) {
    const auto when =
        samples_->times_s.size() == 1 ? std::optional{AxisPosition{}} : samples_->times_s.locate(time_s);
    if (!when)
      throw std::invalid_argument{"a tide must not begin before or end after the currents it is added to"};
    sample_times_.push_back(*when);
  }
}

CurrentGrid CurrentGrid::with_added(Added added) const {
  const std::size_t wanted = samples_->grid.size() * samples_->times_s.size();
  if (added.u.size() != wanted || added.v.size() != wanted)
    throw std::invalid_argument{"an added current needs one u and one v for each node and time"};
  CurrentGrid result{*this};
  result.added_ = std::make_shared<const Added>(std::move(added));
  return result;
}

std::optional<geo::VelocityEn> CurrentGrid::sampled(const GridPosition& at, std::size_t sample_time,
                                                    std::size_t depth_index) const {
  const std::size_t slice = samples_->grid.size();
  const std::size_t begin = (sample_time * depth_count(*samples_) + depth_index) * slice;
  const std::size_t nx = samples_->grid.x().size();
  const auto east = bilinear(std::span{samples_->u}.subspan(begin, slice), nx, at);
  const auto north = bilinear(std::span{samples_->v}.subspan(begin, slice), nx, at);
  if (!east || !north) return std::nullopt;
  const geo::VelocityEn water{{*east}, {*north}};
  if (!added_) return water;
  const auto added_in = [&](const std::vector<float>& all) {
    return core::MetresPerSecond{
        bilinear(std::span{all}.subspan(sample_time * slice, slice), nx, at).value()};
  };
  return sum(water, {added_in(added_->u), added_in(added_->v)});
}

std::optional<geo::VelocityEn> CurrentGrid::level(const GridPosition& at, std::size_t time_index,
                                                  std::size_t depth_index) const {
  if (!tide_) return sampled(at, time_index, depth_index);
  const AxisPosition& when = sample_times_[time_index];
  const auto before = sampled(at, when.lower, depth_index);
  if (!before || when.fraction == 0.0) return before;
  const auto after = sampled(at, when.upper, depth_index);
  if (!after) return std::nullopt;
  return blend(*before, *after, when.fraction);
}

std::optional<geo::VelocityEn> CurrentGrid::tide_at(const GridPosition& at, std::size_t time_index) const {
  if (!tide_) return geo::VelocityEn{};
  const auto across = [&](std::size_t iy) -> std::optional<geo::VelocityEn> {
    const auto west = tide_->at_node(at.x.lower, iy, time_index);
    if (!west || at.x.fraction == 0.0) return west;
    const auto east = tide_->at_node(at.x.upper, iy, time_index);
    if (!east) return std::nullopt;
    return blend(*west, *east, at.x.fraction);
  };
  const auto south = across(at.y.lower);
  if (!south || at.y.fraction == 0.0) return south;
  const auto north = across(at.y.upper);
  if (!north) return std::nullopt;
  return blend(*south, *north, at.y.fraction);
}

std::optional<geo::VelocityEn> CurrentGrid::at(geo::LonLat place, core::Metres depth,
                                               core::UtcTime time) const {
  if (!std::isfinite(place.lon_deg) || !std::isfinite(place.lat_deg) || !std::isfinite(depth.value) ||
      !std::isfinite(core::unix_seconds(time))) {
    throw std::invalid_argument{"currents were asked for at a place, depth or time that is not finite"};
  }
  const auto position = samples_->grid.locate(place);
  const auto when = times_s().locate(core::unix_seconds(time));
  const auto below = samples_->depths_m ? located(*samples_->depths_m, depth) : AxisPosition{};
  if (!position || !when || !below) return std::nullopt;

  const auto at_time = [&](std::size_t time_index) -> std::optional<geo::VelocityEn> {
    const auto tide = tide_at(*position, time_index);
    const auto upper = level(*position, time_index, below->lower);
    if (!upper || !tide) return std::nullopt;
    if (below->fraction == 0.0) return sum(*upper, *tide);
    const auto lower = level(*position, time_index, below->upper);
    if (!lower) return std::nullopt;
    return sum(blend(*upper, *lower, below->fraction), *tide);
  };
  const auto before = at_time(when->lower);
  if (!before || when->fraction == 0.0) return before;
  const auto after = at_time(when->upper);
  if (!after) return std::nullopt;
  return blend(*before, *after, when->fraction);
}

std::optional<CurrentColumn> CurrentGrid::column(const GridPosition& at, std::size_t time_index) const {
  const auto tide = tide_at(at, time_index);
  if (!tide) return std::nullopt;
  std::optional<CurrentColumn> column;
  const std::size_t levels = depth_count(*samples_);
  for (std::size_t i = 0; i < levels; ++i) {
    const auto water = level(at, time_index, i);
    if (!water) break;  // the sea bed
    const core::Metres depth{samples_->depths_m ? (*samples_->depths_m)[i] : 0.0};
    if (column) {
      column->add(depth, sum(*water, *tide));
    } else {
      column.emplace(depth, sum(*water, *tide), levels);
    }
  }
  return column;
}

std::optional<CurrentColumn> CurrentGrid::column_at_node(std::size_t ix, std::size_t iy,
                                                         std::size_t time_index) const {
  return column({{ix, ix, 0.0}, {iy, iy, 0.0}}, time_index);
}

std::optional<geo::VelocityEn> CurrentGrid::depth_average(geo::LonLat place, core::Metres dive_depth,
                                                          std::size_t time_index) const {
  const auto position = samples_->grid.locate(place);
  if (!position) return std::nullopt;
  const auto water = column(*position, time_index);
  if (!water) return std::nullopt;
  return water->mean({0.0}, dive_depth);
}

bool CurrentGrid::has_steady_gaps() const {
  std::call_once(gaps_->looked, [this] { gaps_->are_steady = look_for_steady_gaps(); });
  return gaps_->are_steady;
}

bool CurrentGrid::look_for_steady_gaps() const {
  if (tide_) return false;
  const std::size_t slice = samples_->u.size() / samples_->times_s.size();
  const auto changes = [&](std::size_t begin) {
    // Without branches, so that the compiler vectorises the loop.
    std::uint32_t differ = 0;
    for (std::size_t i = 0; i < slice; ++i) {
      const float first = samples_->u[i] + samples_->v[i];
      const float later = samples_->u[begin + i] + samples_->v[begin + i];
      differ |= static_cast<std::uint32_t>(first == first) ^ static_cast<std::uint32_t>(later == later);
    }
    return differ != 0;
  };
  for (std::size_t begin = slice; begin < samples_->u.size(); begin += slice)
    if (changes(begin)) return false;
  return true;
}

CurrentGrid CurrentGrid::time_mean() const {
  const std::size_t times = samples_->times_s.size();
  const std::size_t slice = samples_->u.size() / times;
  const auto mean = [&](const std::vector<float>& all) {
    std::vector<float> result(slice);
    for (std::size_t i = 0; i < slice; ++i) {
      double sum = 0.0;
      for (std::size_t t = 0; t < times; ++t) sum += static_cast<double>(all[t * slice + i]);
      result[i] = static_cast<float>(sum / static_cast<double>(times));
    }
    return result;
  };
  return CurrentGrid{{.grid = samples_->grid,
                      .depths_m = samples_->depths_m,
                      .times_s = Axis{{samples_->times_s.front()}},
                      .u = mean(samples_->u),
                      .v = mean(samples_->v)}};
}

}  // namespace floeplan::ocean
