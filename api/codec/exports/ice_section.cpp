#include "api/codec/exports/ice_section.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "api/codec/bytes/bare_value.hpp"
#include "api/codec/bytes/document_values.hpp"
#include "api/codec/exports/svg_parts.hpp"
#include "engine/planning/problem/under_ice_rules.hpp"

namespace floeplan::codec {
namespace {

// Margins in picture units, for the depth labels, the names of waypoints, and below the lowest line.
constexpr double room_left = 44.0;
constexpr double room_right = 12.0;
constexpr double room_above = 18.0;
constexpr double room_below = 8.0;

/// Converts metres along the route and of depth to picture units.
struct Scales {
  double width{};
  double height{};
  double length_m{};
  double deepest_m{};

  [[nodiscard]] double x(double along_m) const {
    return room_left + (width - room_left - room_right) * along_m / length_m;
  }
  [[nodiscard]] double y(double depth_m) const {
    return room_above + (height - room_above - room_below) * depth_m / deepest_m;
  }
};

/// A round step that divides the depth into two to five parts.
double depth_step_m(double deepest_m) {
  for (const double step_m : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0})
    if (deepest_m / step_m <= 5.0) return step_m;
  return 200.0;
}

/// Lines at a multiple of the thickness, interrupted where it is unknown.
std::vector<IceSection::Line> lines_of(const std::vector<IceAbove>& ice, double over_thickness,
                                       const Scales& scales) {
  std::vector<IceSection::Line> lines;
  bool is_broken = true;
  for (const IceAbove& above : ice) {
    if (above.thickness) {
      if (is_broken) lines.emplace_back();
      lines.back().push_back(
          {scales.x(above.along.value), scales.y(over_thickness * above.thickness->value)});
    }
    is_broken = !above.thickness;
  }
  return lines;
}

/// Distance of each waypoint along the route, metres.
std::vector<double> along_m(const planning::Plan& plan) {
  std::vector<double> along(plan.waypoints.size());
  for (std::size_t i = 1; i < along.size(); ++i)
    along[i] = along[i - 1] + bare(plan.waypoints[i].leg_length).value_or(0.0);
  return along;
}

double turn_m(const planning::Plan& plan, std::size_t waypoint) {
  return bare(plan.surfacing->waypoints.at(waypoint).leg_upper_turn).value_or(0.0);
}

}  // namespace

std::optional<IceSection> draw_ice_section(const planning::Plan& plan, const std::vector<IceAbove>& ice,
                                           double width, double height) {
  if (!(width > room_left + room_right && height > room_above + room_below))
    throw std::invalid_argument{"draw_ice_section: no room"};
  if (!plan.surfacing || plan.waypoints.size() < 2) return std::nullopt;
  const std::vector<double> along = along_m(plan);
  double deepest_m = 0.0;
  for (const IceAbove& above : ice)
    deepest_m = std::max(deepest_m, planning::keel_over_thickness * bare(above.thickness).value_or(0.0));
  for (std::size_t i = 1; i < along.size(); ++i) deepest_m = std::max(deepest_m, turn_m(plan, i));
  if (deepest_m <= 0.0 || along.back() <= 0.0) return std::nullopt;

  const double step_m = depth_step_m(deepest_m);
  const Scales scales{width, height, along.back(), step_m * std::ceil(deepest_m / step_m)};
  IceSection section{.width = width, .height = height};
  for (double depth_m = 0.0; depth_m <= scales.deepest_m; depth_m += step_m) {
    section.grid.push_back({{room_left, scales.y(depth_m)}, {width - room_right, scales.y(depth_m)}});
    section.labels.push_back({{4.0, scales.y(depth_m) + 3.0}, std::to_string(std::lround(depth_m)) + " m"});
  }
  double free_from = 0.0;  // right end of the last name drawn
  for (std::size_t i = 0; i < along.size(); ++i) {
    const double x = scales.x(along[i]);
    section.grid.push_back({{x, room_above}, {x, height - room_below}});
    const std::string name = waypoint_label(i);
    if (x < free_from) continue;
    section.labels.push_back({{x - 3.0, room_above - 6.0}, name});
    constexpr double figure_width = 7.0;
    free_from = x + figure_width * static_cast<double>(name.size() + 1);
  }
  section.draft = lines_of(ice, draft_over_thickness, scales);
  section.keel = lines_of(ice, planning::keel_over_thickness, scales);
  for (std::size_t i = 1; i < along.size(); ++i) {
    section.turn.push_back({scales.x(along[i - 1]), scales.y(turn_m(plan, i))});
    section.turn.push_back({scales.x(along[i]), scales.y(turn_m(plan, i))});
  }
  return section;
}

std::string svg(const IceSection& section) {
  std::string text = svg_head("sea", section.width, section.height);
  for (const auto& line : section.grid) text += svg_line(line, "grid");
  for (const auto& label : section.labels) text += svg_label(label, "small");
  for (const auto& line : section.keel) text += svg_line(line, "keel");
  for (const auto& line : section.draft) text += svg_line(line, "draft");
  text += svg_line(section.turn, "route");
  return text + "</svg>\n";
}

}  // namespace floeplan::codec
