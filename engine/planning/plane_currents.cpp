#include "engine/planning/plane_currents.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace floeplan::planning {
namespace {

constexpr double most_beside_chord =
    2.5e-4;  // of a cell: so small a share of what the current changes over the cell goes unseen

struct Window {
  std::vector<double> nodes;
  std::vector<std::size_t> indices;
};

/// The nodes of an axis from the last one below `low` to the first one above `high`.
Window window(const ocean::Axis& axis, double low, double high) {
  const auto& nodes = axis.nodes();
  auto first = static_cast<std::size_t>(std::ranges::lower_bound(nodes, low) - nodes.begin());
  auto last = static_cast<std::size_t>(std::ranges::upper_bound(nodes, high) - nodes.begin());
  first = std::min(first > 0 ? first - 1 : 0, nodes.size() - 1);
  last = std::max(std::min(last, nodes.size() - 1), first);
  Window result;
  for (std::size_t i = first; i <= last; ++i) {
    result.nodes.push_back(nodes[i]);
    result.indices.push_back(i);
  }
  return result;
}

/// The same for longitudes: whole turns are added so that the window runs from west to east without a jump.
Window longitude_window(const ocean::HorizontalGrid& grid, double west, double east) {
  const ocean::Axis& axis = grid.x();
  Window result;
  for (int turn = -2; turn <= 2; ++turn) {
    for (std::size_t i = 0; i < axis.size(); ++i) {
      const double lon = axis[i] + 360.0 * turn;
      const double step = std::max(axis.mean_step(), 1e-6);
      if (lon < west - 1.5 * step || lon > east + 1.5 * step) continue;
      // A grid that repeats its first column a turn later would stand twice at one place.
      if (!result.nodes.empty() && lon <= result.nodes.back() + 1e-6 * step) continue;
      // Columns a turn apart are neighbours only where the grid closes the circle.
      if (!result.nodes.empty() && !grid.wraps() && lon - result.nodes.back() > 1.5 * step &&
          result.indices.back() + 1 != i) {
        return result;
      }
      result.nodes.push_back(lon);
      result.indices.push_back(i);
    }
  }
  return result;
}

struct CoordinateBox {
  double low_x{std::numeric_limits<double>::infinity()};
  double high_x{-std::numeric_limits<double>::infinity()};
  double low_y{std::numeric_limits<double>::infinity()};
  double high_y{-std::numeric_limits<double>::infinity()};
};

CoordinateBox coordinate_box(const GridLookup& lookup, const PlaneBox& area) {
  constexpr int samples = 64;
  CoordinateBox box;
  for (int j = 0; j <= samples; ++j) {
    for (int i = 0; i <= samples; ++i) {
      const geo::GridPoint at = lookup.coordinates(
          {area.low.x_m + area.width_m() * i / samples, area.low.y_m + area.height_m() * j / samples});
      box.low_x = std::min(box.low_x, at.x);
      box.high_x = std::max(box.high_x, at.x);
      box.low_y = std::min(box.low_y, at.y);
      box.high_y = std::max(box.high_y, at.y);
    }
  }
  return box;
}

Window column_window(const ocean::HorizontalGrid& grid, const CoordinateBox& box) {
  Window result = std::holds_alternative<geo::GeographicFrame>(grid.frame())
                      ? longitude_window(grid, box.low_x, box.high_x)
                      : window(grid.x(), box.low_x, box.high_x);
  if (result.nodes.empty()) result = {{grid.x().front()}, {0}};  // nothing in common: every point is outside
  return result;
}

}  // namespace

PlaneCurrents::PlaneCurrents(const ocean::CurrentGrid& currents, bool steady, core::Metres dive_depth,
                             const geo::LocalProjection& projection, const PlaneBox& area,
                             core::UtcTime epoch, const std::stop_token& stop)
    : lookup_{currents.samples().grid.frame(), projection, area, stop}, x_{{0.0}}, y_{{0.0}} {
  const ocean::HorizontalGrid& grid = currents.samples().grid;
  const CoordinateBox box = coordinate_box(lookup_, area);
  Window columns = column_window(grid, box);
  Window rows = window(grid.y(), box.low_y, box.high_y);
  x_ = FastAxis{std::move(columns.nodes)};
  y_ = FastAxis{std::move(rows.nodes)};
  columns_ = std::move(columns.indices);
  first_row_ = rows.indices.front();
  if (!steady) {
    std::vector<double> times;
    for (const double time_s : currents.samples().times_s.nodes()) {
      times.push_back(time_s - core::unix_seconds(epoch));
    }
    times_s_ = FastAxis{std::move(times)};
  }
  spacing_ = grid.spacing();
  const geo::GridPoint bend = lookup_.bend();
  // A chord of length h misses a curve by h^2 / 8 of its bend.
  straight_parts_per_metre_ =
      std::sqrt(std::max(bend.x / x_.mean_step(), bend.y / y_.mean_step()) / (8.0 * most_beside_chord));
  fill(currents, dive_depth, projection, stop);
  extend_to_coast();
}

void PlaneCurrents::fill(const ocean::CurrentGrid& currents, core::Metres dive_depth,
                         const geo::LocalProjection& projection, const std::stop_token& stop) {
  constexpr float missing = std::numeric_limits<float>::quiet_NaN();
  const std::size_t slice = x_.size() * y_.size();
  const std::size_t slices = times_s_ ? times_s_->size() : 1;
  nodes_.assign(slice * slices, Node{missing, missing});
  double strongest = 0.0;
  for (std::size_t iy = 0; iy < y_.size() && !stop.stop_requested(); ++iy) {
    for (std::size_t ix = 0; ix < x_.size(); ++ix) {
      const geo::LonLat place = currents.samples().grid.place(columns_[ix], first_row_ + iy);
      const double angle = projection.at(place).convergence.value;
      const double cosine = std::cos(angle);
      const double sine = std::sin(angle);
      for (std::size_t t = 0; t < slices; ++t) {
        const auto c = currents.depth_average_at_node(columns_[ix], first_row_ + iy, dive_depth, t);
        if (!c) continue;
        const double east = c->east.value;
        const double north = c->north.value;
        strongest = std::max(strongest, std::hypot(east, north));
        nodes_[t * slice + iy * x_.size() + ix] = {static_cast<float>(east * cosine - north * sine),
                                                   static_cast<float>(east * sine + north * cosine)};
      }
    }
  }
  // Rounding to float may lengthen a vector by 1e-7 of itself; a bound must not be below it.
  strongest_ = core::MetresPerSecond{strongest * (1.0 + 1e-6)};
}

void PlaneCurrents::extend_to_coast() {
  const std::size_t nx = x_.size();
  const std::size_t ny = y_.size();
  const std::size_t slice = nx * ny;
  extended_.assign(slice, 0);
  std::vector<Node> original(slice);
  for (std::size_t begin = 0; begin < nodes_.size(); begin += slice) {
    std::copy_n(nodes_.begin() + static_cast<std::ptrdiff_t>(begin), slice, original.begin());
    for (std::size_t iy = 0; iy < ny; ++iy) {
      for (std::size_t ix = 0; ix < nx; ++ix) {
        if (!std::isnan(original[iy * nx + ix].x_m_s)) continue;
        double sum_x = 0.0;
        double sum_y = 0.0;
        int wet = 0;
        for (std::size_t jy = iy > 0 ? iy - 1 : 0; jy <= std::min(iy + 1, ny - 1); ++jy) {
          for (std::size_t jx = ix > 0 ? ix - 1 : 0; jx <= std::min(ix + 1, nx - 1); ++jx) {
            const Node& neighbour = original[jy * nx + jx];
            if (std::isnan(neighbour.x_m_s)) continue;
            sum_x += static_cast<double>(neighbour.x_m_s);
            sum_y += static_cast<double>(neighbour.y_m_s);
            ++wet;
          }
        }
        if (wet == 0) continue;
        nodes_[begin + iy * nx + ix] = {static_cast<float>(sum_x / wet), static_cast<float>(sum_y / wet)};
        extended_[iy * nx + ix] = 1;
      }
    }
  }
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
