#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "api/codec/exports/svg_parts.hpp"

namespace floeplan::codec {

/// Sea ice as lines alone, because a printer may know no colour. Denser marks mean more ice, as on the map of the
/// browser. In picture units, y downwards; lines may end outside the picture.
struct IceMarks {
  using Line = std::vector<PicturePoint>;

  std::vector<Line> hatch{};  // dots from the ice edge on, then slanting lines, more of them, crossing lines
  std::vector<Line> unknown{};  // dashes where the data have no value, so that blank means open water
  std::vector<Line> edge{};     // the ice edge
  std::vector<Line> limit{};    // beyond it the vehicle may not surface
};

/// Concentration at a point of the picture, 0 to 1; empty: unknown.
using ConcentrationAt = std::function<std::optional<double>(PicturePoint)>;

/// `limit`  the largest concentration in which the vehicle may surface
/// Accuracy  the ice is sampled every six units of the picture
[[nodiscard]] IceMarks draw_ice(double width, double height, const ConcentrationAt& concentration,
                                double limit);

/// The key to these marks, to be printed below the map.
struct IceKey {
  double width{};
  double height{};
  IceMarks marks{};
  std::vector<PictureLabel> labels{};
};
[[nodiscard]] IceKey draw_ice_key(double width, double limit);

/// The marks as elements of a picture.
[[nodiscard]] std::string svg(const IceMarks& marks);
/// The key as an SVG element.
[[nodiscard]] std::string svg(const IceKey& key);

}  // namespace floeplan::codec
