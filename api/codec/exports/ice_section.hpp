#pragma once

#include <optional>
#include <string>
#include <vector>

#include "api/codec/exports/svg_parts.hpp"
#include "engine/core/units.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::codec {

/// The sea ice above a place of a route.
struct IceAbove {
  core::Metres along{};                     // the route, from its start
  std::optional<core::Metres> thickness{};  // of level ice; empty where it is not known
};

/// A section along a route: how deep the ice above it reaches, and how deep the dives of each leg turn. In picture
/// units, y downwards.
struct IceSection {
  using Line = std::vector<PicturePoint>;

  double width{};
  double height{};
  std::vector<Line> grid{};  // depths, and the waypoints
  std::vector<PictureLabel> labels{};
  std::vector<Line> draft{};  // of level ice; a line for each stretch where it is known
  std::vector<Line> keel{};   // of the deepest keels, the same
  Line turn{};                // of the dives, by leg
};

/// Draft of level ice over its thickness: nine tenths lie under water.
inline constexpr double draft_over_thickness = 0.9;

/// Draws the section of a plan that has ice above it; empty where no ice is known, and where there is none.
/// `ice`    along the route, in its order
/// Errors   std::invalid_argument for a picture without room
[[nodiscard]] std::optional<IceSection> draw_ice_section(const planning::Plan& plan,
                                                         const std::vector<IceAbove>& ice, double width,
                                                         double height);

/// The section as an SVG element.
[[nodiscard]] std::string svg(const IceSection& section);

}  // namespace floeplan::codec
