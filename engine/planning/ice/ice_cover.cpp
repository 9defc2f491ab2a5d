#include "engine/planning/ice/ice_cover.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace floeplan::planning::ice {
namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();

/// Whether there is ice of unknown thickness.
bool is_thickness_missing(float concentration, float thickness_m, const UnderIceRules& rules) {
  // Dense ice with thickness zero means a product without values there, not ice without keels.
  const bool contradicts =
      thickness_m <= 0.0F && static_cast<double>(concentration) > rules.max_concentration_to_surface;
  return concentration > 0.0F && (std::isnan(thickness_m) || contradicts);
}

}  // namespace

IceCover::IceCover(const ocean::IceField& ice, const UnderIceRules& rules,
                   const geo::LocalProjection& projection, const plane::PlaneBox& area, core::UtcTime epoch,
                   const std::stop_token& stop)
    : grid_{ice.samples().grid, projection, area, stop},
      limit_{rules.max_concentration_to_surface},
      spacing_{ice.samples().grid.spacing()} {
  const ocean::IceField::Samples& samples = ice.samples();
  for (const double time_s : samples.times_s.nodes()) times_s_.push_back(time_s - core::unix_seconds(epoch));
  nodes_.reserve(times_s_.size() * grid_.size());
  for (std::size_t t = 0; t < times_s_.size() && !stop.stop_requested(); ++t) {
    for (std::size_t iy = 0; iy < grid_.ny(); ++iy) {
      for (std::size_t ix = 0; ix < grid_.nx(); ++ix) {
        const std::size_t i =
            t * samples.grid.size() + grid_.row(iy) * samples.grid.x().size() + grid_.column(ix);
        const float thickness_m = samples.thickness_m.empty() ? missing : samples.thickness_m[i];
        const bool is_assumed = is_thickness_missing(samples.concentration[i], thickness_m, rules);
        const float told_m =
            std::isnan(thickness_m) ? 0.0F : static_cast<float>(keel_over_thickness) * thickness_m;
        nodes_.push_back({samples.concentration[i],
                          is_assumed ? static_cast<float>(rules.draft_if_unknown.value) : told_m});
        assumed_.push_back(is_assumed);
      }
    }
  }
  has_dense_ice_ = std::ranges::any_of(
      nodes_, [&](const Node& node) { return static_cast<double>(node.concentration) > limit_; });
  if (stop.stop_requested()) return;
  keep_last_keels();
  extend_to_coast();
  for (const Node& node : nodes_)
    deepest_draft_ = std::max(deepest_draft_, core::Metres{static_cast<double>(node.draft_m)});
  measure_distances();
}

/// Between nodes the concentration lies between the values of the surrounding nodes, so distances between
/// cells suffice.
void IceCover::measure_distances() {
  std::vector<bool> opens(grid_.size(), false);
  std::vector<bool> dense(grid_.size(), false);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto concentration = static_cast<double>(nodes_[i].concentration);
    if (concentration <= limit_) opens[i % grid_.size()] = true;
    if (is_dense(nodes_[i])) dense[i % grid_.size()] = true;
  }
  to_openings_ = distances_to(opens);
  to_dense_ice_ = distances_to(dense);
}

/// A cell has the number of its first node. The last node of a row or column begins no cell.
obstacles::CellDistances IceCover::distances_to(const std::vector<bool>& marked_nodes) const {
  const std::size_t nx = grid_.nx();
  std::vector<bool> marked(marked_nodes.size(), false);
  for (std::size_t iy = 0; iy + 1 < grid_.ny(); ++iy) {
    for (std::size_t ix = 0; ix + 1 < nx; ++ix) {
      const std::size_t i = iy * nx + ix;
      marked[i] = marked_nodes[i] || marked_nodes[i + 1] || marked_nodes[i + nx] || marked_nodes[i + nx + 1];
    }
  }
  return obstacles::CellDistances{marked, nx, core::Metres{grid_.least_cell_m()}};
}

core::Metres IceCover::least_way_to_opening(geo::PlanePoint point) const {
  const auto cell = grid_.corner(point);
  return cell ? to_openings_.from(cell->first) : core::Metres{0.0};
}

std::vector<core::Metres> IceCover::least_ways_to_opening(const std::vector<geo::PlanePoint>& points,
                                                          core::Seconds from, core::Seconds until) const {
  const auto after = std::ranges::upper_bound(times_s_, from.count());
  const auto end = std::ranges::lower_bound(times_s_, until.count());
  const auto first = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - times_s_.begin() - 1, 0));
  const auto last = std::min(static_cast<std::size_t>(end - times_s_.begin()), times_s_.size() - 1);
  std::vector<bool> opens(grid_.size(), false);
  for (std::size_t i = first * grid_.size(); i < (last + 1) * grid_.size(); ++i) {
    if (static_cast<double>(nodes_[i].concentration) <= limit_) opens[i % grid_.size()] = true;
  }
  const obstacles::CellDistances distances = distances_to(opens);
  std::vector<core::Metres> ways;
  ways.reserve(points.size());
  for (const geo::PlanePoint point : points) {
    const auto cell = grid_.corner(point);
    ways.push_back(cell ? distances.from(cell->first) : core::Metres{0.0});
  }
  return ways;
}

core::Metres IceCover::least_way_to_dense_ice(geo::PlanePoint point) const {
  const auto cell = grid_.corner(point);
  return cell ? to_dense_ice_.from(cell->first) : core::Metres{0.0};
}

/// Whether the node has ice through which the vehicle may not surface, or had it when last known.
bool IceCover::is_dense(const Node& node) const {
  return std::isnan(node.concentration) ? node.draft_m > 0.0F
                                        : static_cast<double>(node.concentration) > limit_;
}

void IceCover::keep_last_keels() {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (!std::isnan(nodes_[i].concentration)) continue;
    const bool was_dense = i >= grid_.size() && is_dense(nodes_[i - grid_.size()]);
    nodes_[i].draft_m = was_dense ? nodes_[i - grid_.size()].draft_m : 0.0F;
    assumed_[i] = was_dense && assumed_[i - grid_.size()];
  }
}

void IceCover::extend_to_coast() {
  extended_.assign(nodes_.size(), false);
  const std::size_t nx = grid_.nx();
  const std::size_t ny = grid_.ny();
  for (std::size_t begin = 0; begin < nodes_.size(); begin += grid_.size()) {
    const std::vector<Node> original(nodes_.begin() + static_cast<std::ptrdiff_t>(begin),
                                     nodes_.begin() + static_cast<std::ptrdiff_t>(begin + grid_.size()));
    for (std::size_t iy = 0; iy < ny; ++iy) {
      for (std::size_t ix = 0; ix < nx; ++ix) {
        if (!std::isnan(original[iy * nx + ix].concentration)) continue;
        Node& node = nodes_[begin + iy * nx + ix];
        for (std::size_t jy = iy > 0 ? iy - 1 : 0; jy <= std::min(iy + 1, ny - 1); ++jy) {
          for (std::size_t jx = ix > 0 ? ix - 1 : 0; jx <= std::min(ix + 1, nx - 1); ++jx) {
            const Node& neighbour = original[jy * nx + jx];
            if (std::isnan(neighbour.concentration)) continue;
            extended_[begin + iy * nx + ix] = true;
            if (!(node.concentration >= neighbour.concentration))
              node.concentration = neighbour.concentration;
            if (!(neighbour.draft_m > node.draft_m)) continue;
            node.draft_m = neighbour.draft_m;
            assumed_[begin + iy * nx + ix] = assumed_[begin + jy * nx + jx];
          }
        }
      }
    }
  }
}

bool IceCover::is_extended(geo::PlanePoint point, core::Seconds time) const {
  const auto cell = grid_.corner(point);
  if (!cell) return false;
  const ocean::IceMoment when = moment(time);
  for (const std::size_t step : {when.first, when.second}) {
    const std::size_t south = step * grid_.size() + cell->first;
    for (const std::size_t node : {south, south + 1, south + grid_.nx(), south + grid_.nx() + 1})
      if (extended_[node]) return true;
  }
  return false;
}

IceCover::Keels IceCover::keels(geo::PlanePoint point, core::Seconds time) const {
  const auto cell = grid_.corner(point);
  if (!cell) return {};
  const ocean::IceMoment when = moment(time);
  Keels found;
  const auto look = [&](std::size_t step) {
    const std::size_t south = step * grid_.size() + cell->first;
    for (const std::size_t node : {south, south + 1, south + grid_.nx(), south + grid_.nx() + 1}) {
      if (assumed_[node]) found.all_told = false;
      if (!assumed_[node]) found.told_m = std::max(found.told_m, static_cast<double>(nodes_[node].draft_m));
    }
  };
  look(when.first);
  if (when.share > 0.0) look(when.second);
  return found;
}

IceAbove IceCover::above(geo::PlanePoint point, core::Seconds time) const {
  const auto cell = grid_.corner(point);
  if (!cell) return {};
  const ocean::IceMoment when = moment(time);
  if (when.standing == ocean::IceStanding::not_begun) return {};

  const std::size_t nx = grid_.nx();
  double draft_m = 0.0;
  double last_draft_m = 0.0;  // draft of the node when it was last known to be dense
  const auto concentration_at = [&](std::size_t step) {
    const Node* south = nodes_.data() + step * grid_.size() + cell->first;
    const Node* north = south + nx;
    for (const Node& node : {south[0], south[1], north[0], north[1]}) {
      draft_m = std::max(draft_m, static_cast<double>(node.draft_m));
      if (is_dense(node)) last_draft_m = std::max(last_draft_m, static_cast<double>(node.draft_m));
    }
    const auto along = [&](const Node* row) {
      const auto west = static_cast<double>(row[0].concentration);
      return west + cell->fx * (static_cast<double>(row[1].concentration) - west);
    };
    const double low = along(south);
    return low + cell->fy * (along(north) - low);
  };
  double concentration = concentration_at(when.first);
  if (when.share > 0.0) concentration += when.share * (concentration_at(when.second) - concentration);
  if (concentration > limit_) return {.known = when.is_known(), .may_surface = false, .draft_m = draft_m};
  if (concentration <= limit_ && when.is_known()) return {.known = true, .may_surface = true, .draft_m = 0.0};
  return {.draft_m = last_draft_m};
}

}  // namespace floeplan::planning::ice
