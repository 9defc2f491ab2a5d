#include "engine/planning/plane_currents.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/planning/current_slice.hpp"

namespace floeplan::planning {
namespace {

constexpr double most_beside_chord =
    2.5e-4;  // of a cell: so small a share of what the current changes over the cell goes unseen
constexpr int most_parts = 4;  // of a side of a cell: beyond it memory and time outgrow the gain
constexpr std::size_t most_nodes = 1 << 22;  // over all times: 32 MB

/// Each step of the axis cut into equal parts.
std::vector<double> cut(const std::vector<double>& nodes, int parts) {
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    for (int part = 0; part < parts; ++part) {
      result.push_back(nodes[i] + (nodes[i + 1] - nodes[i]) * part / parts);
    }
  }
  result.push_back(nodes.back());
  return result;
}

/// Where node `i` of a cut axis lies on the axis itself.
CellPosition on_uncut(std::size_t i, int parts, std::size_t nodes) {
  const std::size_t cell = i / static_cast<std::size_t>(parts);
  const double share = static_cast<double>(i % static_cast<std::size_t>(parts)) / parts;
  return cell + 1 < nodes ? CellPosition{cell, share} : CellPosition{nodes - 1, 0.0};
}

/// The depths flown at the nodes of a window whose cells are cut into parts.
std::vector<vehicle::DiveBand> bands_over(const FlownDepths& depths, const geo::GridFrame& frame,
                                          const NodeWindow& window, int parts) {
  std::vector<vehicle::DiveBand> bands;
  for (const double y : cut(window.y, parts)) {
    for (const double x : cut(window.x, parts)) bands.push_back(depths.at(geo::to_lon_lat(frame, {x, y})));
  }
  return bands;
}

/// Parts to cut the data's cells into so that a bank of the bathymetry inside one of them is felt.
int parts_for(const FlownDepths& depths, const ocean::HorizontalGrid& grid, const NodeWindow& window,
              std::size_t slices) {
  if (!depths.bathymetry()) return 1;
  const double wanted = std::ceil(grid.spacing() / depths.bathymetry()->grid().spacing());
  int parts = static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(most_parts)));
  const auto too_many = [&] {
    return window.size() * static_cast<std::size_t>(parts * parts) * slices > most_nodes;
  };
  while (parts > 1 && too_many()) --parts;
  const std::vector<vehicle::DiveBand> bands = bands_over(depths, grid.frame(), window, parts);
  const bool same = std::ranges::all_of(bands, [&](const auto& band) { return band == bands.front(); });
  return same ? 1 : parts;
}

std::vector<NodeTurn> turns_of(const ocean::HorizontalGrid& grid, const NodeWindow& window,
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

}  // namespace

PlaneCurrents::PlaneCurrents(const ocean::CurrentGrid& currents, bool steady, const FlownDepths& depths,
                             const geo::LocalProjection& projection, const PlaneBox& area,
                             core::UtcTime epoch, const std::stop_token& stop)
    : lookup_{currents.samples().grid.frame(), projection, area, stop}, x_{{0.0}}, y_{{0.0}} {
  const ocean::HorizontalGrid& grid = currents.samples().grid;
  const NodeWindow window = node_window(grid, lookup_, area);
  if (!steady) {
    std::vector<double> times;
    for (const double time_s : currents.times_s().nodes()) {
      times.push_back(time_s - core::unix_seconds(epoch));
    }
    times_s_ = FastAxis{std::move(times)};
  }
  const int parts = parts_for(depths, grid, window, times_s_ ? times_s_->size() : 1);
  x_ = FastAxis{cut(window.x, parts)};
  y_ = FastAxis{cut(window.y, parts)};
  spacing_ = (1.0 / parts) * grid.spacing();
  const geo::GridPoint bend = lookup_.bend();
  // A chord of length h misses a curve by h^2 / 8 of its bend.
  straight_parts_per_metre_ =
      std::sqrt(std::max(bend.x / x_.mean_step(), bend.y / y_.mean_step()) / (8.0 * most_beside_chord));
  fill(currents, window, parts, bands_over(depths, grid.frame(), window, parts),
       turns_of(grid, window, projection), stop);
}

void PlaneCurrents::fill(const ocean::CurrentGrid& currents, const NodeWindow& window, int parts,
                         const std::vector<vehicle::DiveBand>& bands, const std::vector<NodeTurn>& turns,
                         const std::stop_token& stop) {
  constexpr float missing = std::numeric_limits<float>::quiet_NaN();
  const std::size_t slice = x_.size() * y_.size();
  const std::size_t slices = times_s_ ? times_s_->size() : 1;
  nodes_.assign(slice * slices, Node{missing, missing});
  extended_.assign(slice, 0);
  double strongest2 = 0.0;
  for (std::size_t t = 0; t < slices; ++t) {
    CurrentSlice water{currents, window, turns, t};
    for (std::size_t iy = 0; iy < y_.size(); ++iy) {
      if (stop.stop_requested()) return;
      for (std::size_t ix = 0; ix < x_.size(); ++ix) {
        const std::size_t node = iy * x_.size() + ix;
        const auto mean = water.mean(on_uncut(ix, parts, window.x.size()),
                                     on_uncut(iy, parts, window.y.size()), bands[node]);
        if (!mean) continue;
        const motion::CurrentXy c = mean->current;
        strongest2 = std::max(strongest2, c.x_m_s * c.x_m_s + c.y_m_s * c.y_m_s);
        nodes_[t * slice + node] = {static_cast<float>(c.x_m_s), static_cast<float>(c.y_m_s)};
        if (mean->extended) extended_[node] = 1;
      }
    }
  }
  // Rounding to float may lengthen a vector by 1e-7 of itself; a bound must not be below it.
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

CurrentLine PlaneCurrents::line(const motion::PlaneEdge& edge) const { return {*this, edge}; }

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

std::optional<core::Seconds> PlaneCurrents::end() const {
  if (!times_s_) return std::nullopt;
  return core::Seconds{times_s_->nodes().back()};
}

}  // namespace floeplan::planning
