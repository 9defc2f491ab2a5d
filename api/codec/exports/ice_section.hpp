#pragma once

#include <optional>
#include <string>
#include <vector>

#include "api/codec/exports/svg_parts.hpp"
#include "engine/core/units.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::codec {

/// The sea ice above one place of a route.
struct IceAbove {
  core::Metres along{};                     // distance along the route from its start
  std::optional<core::Metres> thickness{};  // thickness of level ice; empty: unknown
};

/// A section along a route: the draft of the ice above it, and the depth at which the dives of each leg turn.
/// In picture units, y downwards.
struct IceSection {
  using Line = std::vector<PicturePoint>;

  double width{};
  double height{};
  std::vector<Line> grid{};  // lines of depths and waypoints
  std::vector<PictureLabel> labels{};
  std::vector<Line> draft{};  // draft of level ice; one line for each stretch with known thickness
  std::vector<Line> keel{};   // depth of the deepest keels; likewise
  Line turn{};                // depth at which dives turn, by leg
};

/// Ratio of draft to thickness of level ice: nine tenths are under water.
inline constexpr double draft_over_thickness = 0.9;

/// Draws the section of a plan with ice above it; empty if there is no ice or none is known.
/// `ice`    ice at places along the route, in order
/// Errors   std::invalid_argument for a picture that is too small
[[nodiscard]] std::optional<IceSection> draw_ice_section(const planning::Plan& plan,
                                                         const std::vector<IceAbove>& ice, double width,
                                                         double height);

/// The section as an SVG element.
[[nodiscard]] std::string svg(const IceSection& section);

}  // namespace floeplan::codec
