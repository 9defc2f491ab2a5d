#include "engine/ocean/currents/current_column.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::ocean {

CurrentColumn::CurrentColumn(core::Metres depth, const geo::VelocityEn& velocity, std::size_t levels) {
  knots_.reserve(levels + 1);
  knots_.push_back({0.0, velocity.east.value, velocity.north.value, 0.0, 0.0});
  add(depth, velocity);
}

void CurrentColumn::add(core::Metres depth, const geo::VelocityEn& velocity) {
  const Knot& above = knots_.back();
  Knot knot{std::max(depth.value, 0.0), velocity.east.value, velocity.north.value, 0.0, 0.0};
  const double thickness_m = knot.depth_m - above.depth_m;
  knot.east_m2_s = above.east_m2_s + 0.5 * thickness_m * (above.east_m_s + knot.east_m_s);
  knot.north_m2_s = above.north_m2_s + 0.5 * thickness_m * (above.north_m_s + knot.north_m_s);
  knots_.push_back(knot);
}

CurrentColumn::Knot CurrentColumn::at(double depth_m) const {
  const auto below = std::ranges::lower_bound(knots_, depth_m, {}, &Knot::depth_m);
  if (below == knots_.end()) return knots_.back();
  if (below == knots_.begin()) return knots_.front();
  const Knot& upper = *(below - 1);
  const double share = (depth_m - upper.depth_m) / (below->depth_m - upper.depth_m);
  const double thickness_m = depth_m - upper.depth_m;
  const double east = upper.east_m_s + share * (below->east_m_s - upper.east_m_s);
  const double north = upper.north_m_s + share * (below->north_m_s - upper.north_m_s);
  return {depth_m, east, north, upper.east_m2_s + 0.5 * thickness_m * (upper.east_m_s + east),
          upper.north_m2_s + 0.5 * thickness_m * (upper.north_m_s + north)};
}

geo::VelocityEn CurrentColumn::mean(core::Metres top, core::Metres bottom) const {
  const Knot high = at(top.value);
  const Knot low = at(bottom.value);
  const double thickness_m = low.depth_m - high.depth_m;
  if (!(thickness_m > 0.0)) return {{high.east_m_s}, {high.north_m_s}};
  return {{(low.east_m2_s - high.east_m2_s) / thickness_m},
          {(low.north_m2_s - high.north_m2_s) / thickness_m}};
}

}  // namespace floeplan::ocean
