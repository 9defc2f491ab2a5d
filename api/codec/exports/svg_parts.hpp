#pragma once

#include <string>
#include <vector>

/// Elements of SVG, one line each. Places have one decimal: the same picture gives the same bytes.
namespace floeplan::codec {

/// A point of a picture, in picture units, y downwards.
struct PicturePoint {
  double x{};
  double y{};
};

struct PictureLabel {
  PicturePoint at;
  std::string text;
};

/// Begins a picture, with a ground of this style.
[[nodiscard]] std::string svg_head(const char* ground, double width, double height);
/// The corners of a line or an outline.
[[nodiscard]] std::string svg_points(const std::vector<PicturePoint>& points);
[[nodiscard]] std::string svg_line(const std::vector<PicturePoint>& points, const char* style);
[[nodiscard]] std::string svg_label(const PictureLabel& label, const char* style);

}  // namespace floeplan::codec
