#include "engine/planning/currents/plane_currents.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/planning/currents/cell_cut.hpp"
#include "engine/planning/currents/depth_averages.hpp"
#include "engine/planning/currents/upper_turns.hpp"

namespace floeplan::planning::currents {
namespace {

constexpr double most_beside_chord =
    2.5e-4;  // share of a cell: the current hardly changes over this distance
/// Rows of the data that are read together: few enough that their values at one time fit into the processor's
/// cache.
constexpr std::size_t rows_together = 16;

std::vector<NodeTurn> turns_of(const ocean::HorizontalGrid& grid, const plane::NodeWindow& window,
                               const geo::LocalProjection& projection) {
  std::vector<NodeTurn> turns;
  for (std::size_t iy = 0; iy < window.y.size(); ++iy) {
    for (const std::size_t column : window.columns) {
      const double angle = projection.at(grid.place(column, window.first_row + iy)).convergence.value;
      turns.push_back({std::cos(angle), std::sin(angle)});
    }
  }
  return turns;
}

std::vector<geo::PlanePoint> points_of(const ocean::HorizontalGrid& grid, const plane::NodeWindow& window,
                                       const geo::LocalProjection& projection) {
  std::vector<geo::PlanePoint> points;
  for (std::size_t iy = 0; iy < window.y.size(); ++iy) {
    for (const std::size_t column : window.columns)
      points.push_back(projection.to_plane(grid.place(column, window.first_row + iy)));
  }
  return points;
}

/// Some rows of the data's nodes, and the rows of the finer lattice from the first of them on.
struct RowBlock {
  std::size_t first_cut{};
  std::size_t end_cut{};
  std::size_t
      first_needed{};  // row of the data; the last cells need the next row, and the coast rule one row more
  std::size_t needed{};
};

RowBlock block_from(std::size_t first, const plane::NodeWindow& window, std::size_t parts,
                    std::size_t cut_rows) {
  const std::size_t end = std::min(first + rows_together, window.y.size());
  const std::size_t first_needed = first > 0 ? first - 1 : 0;
  return {.first_cut = first * parts,
          .end_cut = std::min(end * parts, cut_rows),
          .first_needed = first_needed,
          .needed = std::min(end + 2, window.y.size()) - first_needed};
}

std::vector<DepthAverages::Place> places_in(const RowBlock& block, std::size_t cut_columns, int parts,
                                            const plane::NodeWindow& window,
                                            const std::vector<vehicle::DiveBand>& bands) {
  std::vector<DepthAverages::Place> places;
  places.reserve((block.end_cut - block.first_cut) * cut_columns);
  for (std::size_t iy = block.first_cut; iy < block.end_cut; ++iy) {
    for (std::size_t ix = 0; ix < cut_columns; ++ix) {
      places.push_back({on_uncut(ix, parts, window.x.size()), on_uncut(iy, parts, window.y.size()),
                        bands[iy * cut_columns + ix]});
    }
  }
  return places;
}

/// The dives at a set of places below ice, one time after another.
class PlacesBelowIce {
 public:
  /// All references are borrowed and must outlive this.
  PlacesBelowIce(const std::vector<DepthAverages::Place>& places, std::size_t columns,
                 const UpperTurns& turns)
      : places_{places}, turns_{turns}, deeper_{places} {
    const auto nearest = [](const plane::CellPosition& at) { return at.cell + (at.share > 0.5 ? 1 : 0); };
    for (const DepthAverages::Place& place : places) {
      nodes_.push_back(nearest(place.y) * columns + nearest(place.x));
      ever_ = ever_ || turns.ever_below(nodes_.back());
    }
  }

  /// Whether any place lies below ice at some time.
  [[nodiscard]] bool ever() const { return ever_; }
  /// Whether this place lies below ice at this time.
  [[nodiscard]] bool is_below(std::size_t time, std::size_t place) const {
    return turns_.at(time, nodes_[place]) > places_[place].band.top;
  }
  /// Sets the dives of the places below ice to this time. Returns whether any band changed.
  bool turn_at(std::size_t time) {
    bool changed = false;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (!is_below(time, i)) continue;
      const vehicle::DiveBand band = vehicle::band_below(turns_.at(time, nodes_[i]), places_[i].band);
      if (band == deeper_[i].band) continue;
      deeper_[i].band = band;
      changed = true;
    }
    return changed;
  }
  /// The places with the bands that they had when they were last below ice.
  [[nodiscard]] const std::vector<DepthAverages::Place>& deeper() const { return deeper_; }

 private:
  const std::vector<DepthAverages::Place>& places_;
  const UpperTurns& turns_;
  std::vector<DepthAverages::Place> deeper_;
  std::vector<std::size_t> nodes_;  // data node nearest to each place
  bool ever_{false};
};

}  // namespace

PlaneCurrents::PlaneCurrents(const ocean::CurrentGrid& currents, bool steady, const FlownDepths& depths,
                             const geo::LocalProjection& projection, const plane::PlaneBox& area,
                             core::UtcTime epoch, const std::stop_token& stop, const ice::UnderIce* ice)
    : lookup_{currents.samples().grid.frame(), projection, area, stop}, x_{{0.0}}, y_{{0.0}} {
  const ocean::HorizontalGrid& grid = currents.samples().grid;
  const plane::NodeWindow window = plane::node_window(grid, lookup_, area);
  if (!steady) {
    std::vector<double> times;
    for (const double time_s : currents.times_s().nodes()) {
      times.push_back(time_s - core::unix_seconds(epoch));
    }
    times_s_ = plane::FastAxis{std::move(times)};
  }
  const std::vector<NodeTurn> turns = turns_of(grid, window, projection);
  const auto [parts, bands] =
      cut_cells(currents, depths, window, turns, times_s_ ? times_s_->size() : 1, stop);
  x_ = plane::FastAxis{cut_axis(window.x, parts)};
  y_ = plane::FastAxis{cut_axis(window.y, parts)};
  spacing_ = (1.0 / parts) * grid.spacing();
  const geo::GridPoint bend = lookup_.bend();
  // A chord of length h deviates from a curve by h^2 / 8 times its second derivative.
  straight_parts_per_metre_ =
      std::sqrt(std::max(bend.x / x_.mean_step(), bend.y / y_.mean_step()) / (8.0 * most_beside_chord));
  UpperTurns upper_turns;
  if (ice != nullptr) {
    std::vector<core::Seconds> times{core::Seconds{0.0}};
    if (times_s_) {
      times.clear();
      for (const double time_s : times_s_->nodes()) times.emplace_back(time_s);
    }
    upper_turns = UpperTurns{*ice, points_of(grid, window, projection), times, stop};
  }
  fill(currents, window, parts, bands, upper_turns, turns, stop);
}

void PlaneCurrents::fill(const ocean::CurrentGrid& currents, const plane::NodeWindow& window, int parts,
                         const std::vector<vehicle::DiveBand>& bands, const UpperTurns& upper_turns,
                         const std::vector<NodeTurn>& turns, const std::stop_token& stop) {
  constexpr float missing = std::numeric_limits<float>::quiet_NaN();
  const std::size_t slice = x_.size() * y_.size();
  const std::size_t slices = times_s_ ? times_s_->size() : 1;
  nodes_.assign(slice * slices, Node{missing, missing});
  extended_.assign(slice, 0);
  double strongest2 = 0.0;
  for (std::size_t first = 0; first < window.y.size(); first += rows_together) {
    const RowBlock block = block_from(first, window, static_cast<std::size_t>(parts), y_.size());
    const std::vector<DepthAverages::Place> places = places_in(block, x_.size(), parts, window, bands);
    PlacesBelowIce below_ice{places, window.x.size(), upper_turns};
    std::optional<WetLevels> wet;
    std::optional<DepthAverages> means;
    std::optional<DepthAverages> means_below_ice;
    for (std::size_t t = 0; t < slices; ++t) {
      if (stop.stop_requested()) return;
      const ocean::CurrentRows water{currents, t, window.first_row + block.first_needed, block.needed};
      if (!means || !currents.has_steady_gaps()) {
        WetLevels wet_now{window, block.first_needed, block.needed, water};
        if (wet != wet_now) {
          means.emplace(places, currents.samples().depths_m, window, turns, wet_now, water);
          wet = std::move(wet_now);
          means_below_ice.reset();
        }
      }
      if (below_ice.ever() && (below_ice.turn_at(t) || !means_below_ice))
        means_below_ice.emplace(below_ice.deeper(), currents.samples().depths_m, window, turns, *wet, water);
      for (std::size_t i = 0; i < places.size(); ++i) {
        const bool is_below = below_ice.ever() && below_ice.is_below(t, i);
        const auto mean = (is_below ? *means_below_ice : *means).at(i, water);
        if (!mean) continue;
        const motion::CurrentXy c = mean->current;
        strongest2 = std::max(strongest2, c.x_m_s * c.x_m_s + c.y_m_s * c.y_m_s);
        const std::size_t node = block.first_cut * x_.size() + i;
        nodes_[t * slice + node] = {static_cast<float>(c.x_m_s), static_cast<float>(c.y_m_s)};
        if (mean->extended) extended_[node] = 1;
      }
    }
  }
  // Rounding to float may lengthen a vector by 1e-7 of itself, and a bound must not be too low.
  strongest_ = core::MetresPerSecond{std::sqrt(strongest2) * (1.0 + 1e-6)};
}

std::optional<PlaneCurrents::Corner> PlaneCurrents::corner(geo::PlanePoint point) const {
  const geo::GridPoint at = lookup_.coordinates(point);
  const auto x = x_.locate(at.x);
  const auto y = y_.locate(at.y);
  if (!x || !y) return std::nullopt;
  return Corner{y->cell * x_.size() + x->cell, x->share, y->share};
}

std::optional<motion::CurrentXy> PlaneCurrents::operator()(geo::PlanePoint point, core::Seconds time) const {
  const auto cell = corner(point);
  if (!cell) return std::nullopt;

  std::size_t before = 0;
  double share = 0.0;
  if (times_s_) {
    const auto when = times_s_->locate(time.count());
    if (!when) return std::nullopt;
    before = when->cell;
    share = when->share;
  }

  const std::size_t nx = x_.size();
  const std::size_t slice = nx * y_.size();
  const auto in_slice = [&](std::size_t slice_index) {
    const Node* sw = nodes_.data() + slice_index * slice + cell->first;
    const Node* nw = sw + nx;
    const auto mix = [&](float a, float b, float c, float d) {
      const double south =
          static_cast<double>(a) + cell->fx * (static_cast<double>(b) - static_cast<double>(a));
      const double north =
          static_cast<double>(c) + cell->fx * (static_cast<double>(d) - static_cast<double>(c));
      return south + cell->fy * (north - south);
    };
    return motion::CurrentXy{mix(sw[0].x_m_s, sw[1].x_m_s, nw[0].x_m_s, nw[1].x_m_s),
                             mix(sw[0].y_m_s, sw[1].y_m_s, nw[0].y_m_s, nw[1].y_m_s)};
  };
  motion::CurrentXy result = in_slice(before);
  if (share > 0.0) {
    const motion::CurrentXy later = in_slice(before + 1);
    result.x_m_s += share * (later.x_m_s - result.x_m_s);
    result.y_m_s += share * (later.y_m_s - result.y_m_s);
  }
  if (std::isnan(result.x_m_s)) return std::nullopt;
  return result;
}

bool PlaneCurrents::is_extended(geo::PlanePoint point) const {
  const auto cell = corner(point);
  if (!cell) return false;
  const std::size_t nx = x_.size();
  return (extended_[cell->first] | extended_[cell->first + 1] | extended_[cell->first + nx] |
          extended_[cell->first + nx + 1]) != 0;
}

std::optional<core::Seconds> PlaneCurrents::time_step() const {
  if (!times_s_ || times_s_->size() < 2) return std::nullopt;
  const std::vector<double>& times = times_s_->nodes();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < times.size(); ++i) least = std::min(least, times[i] - times[i - 1]);
  return core::Seconds{least};
}

core::Seconds PlaneCurrents::next_step(core::Seconds time) const {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (!times_s_) return core::Seconds{never};
  const std::vector<double>& times = times_s_->nodes();
  const auto next = std::ranges::upper_bound(times, time.count());
  return core::Seconds{next == times.end() ? never : *next};
}

std::optional<core::Seconds> PlaneCurrents::end() const {
  if (!times_s_) return std::nullopt;
  return core::Seconds{times_s_->nodes().back()};
}

}  // namespace floeplan::planning::currents
