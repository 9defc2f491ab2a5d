#include "engine/ocean/currents/current_rows.hpp"

#include <limits>

namespace floeplan::ocean {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// The samples of some rows, from the first one at the uppermost level to the last one at the lowest level.
std::span<const float> part(const std::vector<float>& samples, std::size_t begin, std::size_t slice,
                            std::size_t levels, std::size_t row_samples) {
  return std::span{samples}.subspan(begin, (levels - 1) * slice + row_samples);
}

/// Position of a tidal time step among the times of the samples. Steady samples have a single time.
AxisPosition sample_time(const CurrentGrid& currents, std::size_t time_index) {
  const Axis& times_s = currents.samples().times_s;
  if (times_s.size() == 1) return {};
  return times_s.locate(currents.times_s()[time_index]).value();
}

}  // namespace

CurrentRows::CurrentRows(const CurrentGrid& currents, std::size_t time_index, std::size_t first_row,
                         std::size_t rows)
    : levels_{currents.samples().depths_m ? currents.samples().depths_m->size() : 1},
      columns_{currents.samples().grid.x().size()},
      level_stride_{currents.tide() || currents.added() ? rows * columns_ : currents.samples().grid.size()} {
  if (currents.tide()) {
    add_tide(currents, time_index, first_row);
    return;
  }
  if (currents.added()) {
    add_to_samples(currents, time_index, first_row);
    return;
  }
  const CurrentGrid::Samples& samples = currents.samples();
  const std::size_t begin = time_index * levels_ * level_stride_ + first_row * columns_;
  u_ = part(samples.u, begin, level_stride_, levels_, rows * columns_);
  v_ = part(samples.v, begin, level_stride_, levels_, rows * columns_);
}

void CurrentRows::add_to_samples(const CurrentGrid& currents, std::size_t time_index, std::size_t first_row) {
  const CurrentGrid::Samples& samples = currents.samples();
  const std::size_t slice = samples.grid.size();
  const std::size_t first_node = first_row * columns_;
  const auto add = [&](const std::vector<float>& all, const std::vector<float>& added,
                       std::vector<float>& summed) {
    summed.resize(levels_ * level_stride_);
    const float* const beside = added.data() + time_index * slice + first_node;
    for (std::size_t level = 0; level < levels_; ++level) {
      const float* const water = all.data() + (time_index * levels_ + level) * slice + first_node;
      float* const out = summed.data() + level * level_stride_;
      for (std::size_t i = 0; i < level_stride_; ++i) out[i] = water[i] + beside[i];
    }
  };
  add(samples.u, currents.added()->u, summed_u_);
  add(samples.v, currents.added()->v, summed_v_);
  u_ = summed_u_;
  v_ = summed_v_;
}

void CurrentRows::add_tide(const CurrentGrid& currents, std::size_t time_index, std::size_t first_row) {
  const CurrentGrid::Samples& samples = currents.samples();
  const std::size_t slice = samples.grid.size();
  const AxisPosition when = sample_time(currents, time_index);
  summed_u_.resize(levels_ * level_stride_);
  summed_v_.resize(levels_ * level_stride_);
  const CurrentGrid::Added* const added = currents.added().get();
  const auto between = [&](const std::vector<float>& all, const std::vector<float>* beside, std::size_t level,
                           std::size_t node) {
    const auto at = [&](std::size_t time) {
      const float water = all[(time * levels_ + level) * slice + node];
      return static_cast<double>(beside == nullptr ? water : water + (*beside)[time * slice + node]);
    };
    const double before = at(when.lower);
    return when.fraction == 0.0 ? before : before + when.fraction * (at(when.upper) - before);
  };
  for (std::size_t i = 0; i < level_stride_; ++i) {
    const std::size_t node = first_row * columns_ + i;
    const auto tide = currents.tide()->at_node(node % columns_, node / columns_, time_index);
    const geo::VelocityEn moved = tide.value_or(geo::VelocityEn{{missing}, {missing}});
    for (std::size_t level = 0; level < levels_; ++level) {
      summed_u_[level * level_stride_ + i] = static_cast<float>(
          between(samples.u, added != nullptr ? &added->u : nullptr, level, node) + moved.east.value);
      summed_v_[level * level_stride_ + i] = static_cast<float>(
          between(samples.v, added != nullptr ? &added->v : nullptr, level, node) + moved.north.value);
    }
  }
  u_ = summed_u_;
  v_ = summed_v_;
}

}  // namespace floeplan::ocean
