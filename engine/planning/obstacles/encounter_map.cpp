#include "engine/planning/obstacles/encounter_map.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::planning::obstacles {
namespace {

constexpr std::size_t nodes = 49;           // on each side of the lattice
constexpr double shortest_slot_s = 3600.0;  // the step of the forecast
constexpr double most_map_slots = 49.0;
constexpr double least_slots = 4.0;
constexpr double most_evaluations = 2e7;  // each of one berg at one node and time: half a second in all
constexpr double longest_step_m = 1000.0;
constexpr int most_steps = 64;

/// Position of a value on an axis of nodes, limited to its ends.
double place(double value, double step, std::size_t count) {
  return std::clamp(value / step, 0.0, static_cast<double>(count - 1));
}

}  // namespace

EncounterMap::EncounterMap(const IcebergDiscs& icebergs, const plane::PlaneBox& area, core::Seconds horizon,
                           core::MetresPerSecond speed, const std::stop_token& stop)
    : area_{area} {
  const double affordable =
      most_evaluations / (static_cast<double>(nodes * nodes) * static_cast<double>(icebergs.size() + 1));
  const double wanted = std::min({1.0 + horizon.count() / shortest_slot_s, most_map_slots, affordable});
  slots_ = static_cast<std::size_t>(std::max(std::floor(wanted), least_slots));
  slot_s_ = horizon.count() / static_cast<double>(slots_ - 1);
  const double cell_x_m = area.width_m() / static_cast<double>(nodes - 1);
  const double cell_y_m = area.height_m() / static_cast<double>(nodes - 1);
  const core::Metres blur{std::max(cell_x_m, cell_y_m)};
  rates_per_s_.reserve(slots_ * nodes * nodes);
  for (std::size_t slot = 0; slot < slots_; ++slot) {
    for (std::size_t iy = 0; iy < nodes; ++iy) {
      if (stop.stop_requested()) return;
      for (std::size_t ix = 0; ix < nodes; ++ix) {
        const geo::PlanePoint point{area.low.x_m + static_cast<double>(ix) * cell_x_m,
                                    area.low.y_m + static_cast<double>(iy) * cell_y_m};
        const core::Seconds time{static_cast<double>(slot) * slot_s_};
        rates_per_s_.push_back(static_cast<float>(icebergs.encounter_rate(point, time, speed, blur)));
      }
    }
  }
}

double EncounterMap::rate_in_slot(std::size_t slot, double column, double row) const {
  const auto ix = std::min(static_cast<std::size_t>(column), nodes - 2);
  const auto iy = std::min(static_cast<std::size_t>(row), nodes - 2);
  const double fx = column - static_cast<double>(ix);
  const double fy = row - static_cast<double>(iy);
  const float* at = rates_per_s_.data() + (slot * nodes + iy) * nodes + ix;
  const auto node = [&](std::size_t i) { return static_cast<double>(at[i]); };
  const double south = node(0) + fx * (node(1) - node(0));
  const double north = node(nodes) + fx * (node(nodes + 1) - node(nodes));
  return south + fy * (north - south);
}

double EncounterMap::rate(geo::PlanePoint point, double t_s) const {
  const double column =
      place(point.x_m - area_.low.x_m, area_.width_m() / static_cast<double>(nodes - 1), nodes);
  const double row =
      place(point.y_m - area_.low.y_m, area_.height_m() / static_cast<double>(nodes - 1), nodes);
  const double slot = place(t_s, slot_s_, slots_);
  const auto before = std::min(static_cast<std::size_t>(slot), slots_ - 2);
  const double early = rate_in_slot(before, column, row);
  const double late = rate_in_slot(before + 1, column, row);
  return early + (slot - static_cast<double>(before)) * (late - early);
}

double EncounterMap::along(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart,
                           core::Seconds time) const {
  const double length_m = geo::distance_m(a, b);
  const int steps = std::clamp(static_cast<int>(std::ceil(length_m / longest_step_m)), 1, most_steps);
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double share = (i + 0.5) / steps;
    sum += rate({a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)},
                depart.count() + share * time.count());
  }
  return sum / steps * time.count();
}

}  // namespace floeplan::planning::obstacles
