#include "engine/planning/currents/depth_averages.hpp"

#include <algorithm>
#include <cmath>

#include "engine/ocean/grids/band_weights.hpp"

namespace floeplan::planning::currents {

namespace {

/// Columns of a window that are also adjacent in the data.
struct Stretch {
  std::size_t first;  // index in the window
  std::size_t end;
  std::size_t data_first;
};

/// The window's columns as one stretch, or two if the window crosses the seam of the data's longitudes.
std::vector<Stretch> stretches_of(const std::vector<std::size_t>& columns) {
  std::vector<Stretch> stretches;
  for (std::size_t ix = 0; ix < columns.size(); ++ix) {
    if (ix == 0 || columns[ix] != columns[ix - 1] + 1) stretches.push_back({ix, ix, columns[ix]});
    stretches.back().end = ix + 1;
  }
  return stretches;
}

/// Adds one to `counts` for each column with water at this level and at all above. Returns the number of such
/// columns.
std::uint32_t count_wet(std::uint32_t level, const float* u, const float* v, std::uint32_t* counts,
                        std::size_t columns) {
  std::uint32_t wet = 0;
  // Without branches, and with counts as wide as the samples, so that the compiler vectorises the loop.
  const auto count = [&](std::size_t i) {
    const float sum = u[i] + v[i];
    const auto is_known = static_cast<std::uint32_t>(sum == sum);
    const std::uint32_t here = static_cast<std::uint32_t>(counts[i] == level) & is_known;
    counts[i] += here;
    wet += here;
  };
  constexpr std::size_t together = 8;
  std::size_t i = 0;
  for (; i + together <= columns; i += together)
    for (std::size_t k = 0; k < together; ++k) count(i + k);
  for (; i < columns; ++i) count(i);
  return wet;
}

}  // namespace

WetLevels::WetLevels(const plane::NodeWindow& window, std::size_t first_row, std::size_t rows,
                     const ocean::CurrentRows& water)
    : first_row_{first_row}, columns_{window.x.size()}, counts_(rows * window.x.size(), 0) {
  const std::vector<Stretch> stretches = stretches_of(window.columns);
  for (std::size_t iy = 0; iy < rows; ++iy) {
    for (std::size_t level = 0; level < water.levels(); ++level) {
      const std::size_t row = level * water.level_stride() + iy * water.columns();
      std::uint32_t wet = 0;
      for (const auto& [first, end, data_first] : stretches) {
        wet += count_wet(static_cast<std::uint32_t>(level), water.u().data() + row + data_first,
                         water.v().data() + row + data_first, counts_.data() + iy * columns_ + first,
                         end - first);
      }
      if (wet == 0) break;
    }
  }
}

/// Records which columns enter each mean, and their weights.
class DepthAverages::Builder {
 public:
  Builder(DepthAverages& means, const std::optional<ocean::Axis>& levels_m, const plane::NodeWindow& window,
          const std::vector<NodeTurn>& turns, const WetLevels& wet, std::size_t data_columns)
      : means_{means},
        levels_m_{levels_m},
        window_{window},
        turns_{turns},
        wet_{wet},
        data_columns_{data_columns} {}

  void add(const Place& place) {
    const std::size_t first_column = means_.columns_.size();
    bool is_known = true;
    bool extended = false;
    for (const std::size_t up : {0U, 1U}) {
      for (const std::size_t right : {0U, 1U}) {
        const double share = (up == 1 ? place.y.share : 1.0 - place.y.share) *
                             (right == 1 ? place.x.share : 1.0 - place.x.share);
        if (share == 0.0 || !is_known) continue;
        const std::size_t ix = place.x.cell + right;
        const std::size_t iy = place.y.cell + up;
        if (wet_.at(ix, iy) > 0) {
          add_column(ix, iy, share, place.band);
        } else {
          is_known = add_neighbours(ix, iy, share, place.band);
          extended = true;
        }
      }
    }
    if (!is_known) means_.columns_.resize(first_column);
    means_.sums_.push_back({first_column, extended && is_known});
  }

 private:
  bool add_neighbours(std::size_t ix, std::size_t iy, double share, const vehicle::DiveBand& band) {
    const std::size_t end_x = std::min(ix + 2, window_.x.size());
    const std::size_t end_y = std::min(iy + 2, window_.y.size());
    const auto for_each_wet = [&](const auto& visit) {
      for (std::size_t jy = iy > 0 ? iy - 1 : 0; jy < end_y; ++jy)
        for (std::size_t jx = ix > 0 ? ix - 1 : 0; jx < end_x; ++jx)
          if (wet_.at(jx, jy) > 0) visit(jx, jy);
    };
    int count = 0;
    for_each_wet([&](std::size_t, std::size_t) { ++count; });
    for_each_wet([&](std::size_t jx, std::size_t jy) { add_column(jx, jy, share / count, band); });
    return count > 0;
  }

  void add_column(std::size_t ix, std::size_t iy, double share, const vehicle::DiveBand& band) {
    const std::size_t wet = wet_.at(ix, iy);
    // Adjacent places mostly have the same band and the same number of levels, so the weights are reused.
    if (wet != last_wet_ || band != last_band_) {
      const std::vector<double> weights = ocean::band_weights(levels_m_, wet, band.top, band.bottom);
      last_wet_ = wet;
      last_band_ = band;
      last_levels_ = weights.size();
      means_.weights_.insert(means_.weights_.end(), weights.begin(), weights.end());
    }
    const NodeTurn& turn = turns_[iy * window_.x.size() + ix];
    means_.columns_.push_back({.first_sample = (iy - wet_.first_row()) * data_columns_ + window_.columns[ix],
                               .first_weight = means_.weights_.size() - last_levels_,
                               .levels = last_levels_,
                               .turn = {share * turn.cosine, share * turn.sine}});
  }

  DepthAverages& means_;
  const std::optional<ocean::Axis>& levels_m_;
  const plane::NodeWindow& window_;
  const std::vector<NodeTurn>& turns_;
  const WetLevels& wet_;
  std::size_t data_columns_;
  std::size_t last_wet_{};
  vehicle::DiveBand last_band_;
  std::size_t last_levels_{};
};

DepthAverages::DepthAverages(const std::vector<Place>& places, const std::optional<ocean::Axis>& levels_m,
                             const plane::NodeWindow& window, const std::vector<NodeTurn>& turns,
                             const WetLevels& wet, const ocean::CurrentRows& water)
    : level_stride_{water.level_stride()} {
  Builder builder{*this, levels_m, window, turns, wet, water.columns()};
  sums_.reserve(places.size() + 1);
  for (const Place& place : places) builder.add(place);
  sums_.push_back({columns_.size(), false});
}

std::optional<DepthAverages::Mean> DepthAverages::at(std::size_t place,
                                                     const ocean::CurrentRows& water) const {
  const std::size_t end = sums_[place + 1].first_column;
  std::size_t i = sums_[place].first_column;
  if (i == end) return std::nullopt;
  Mean mean{.current = {0.0, 0.0}, .extended = sums_[place].extended};
  for (; i < end; ++i) {
    const Column& column = columns_[i];
    const float* const u = water.u().data() + column.first_sample;
    const float* const v = water.v().data() + column.first_sample;
    const double* const weights = weights_.data() + column.first_weight;
    double east = 0.0;
    double north = 0.0;
    for (std::size_t level = 0; level < column.levels; ++level) {
      east += weights[level] * static_cast<double>(u[level * level_stride_]);
      north += weights[level] * static_cast<double>(v[level * level_stride_]);
    }
    mean.current.x_m_s += east * column.turn.cosine - north * column.turn.sine;
    mean.current.y_m_s += east * column.turn.sine + north * column.turn.cosine;
  }
  return mean;
}

}  // namespace floeplan::planning::currents
