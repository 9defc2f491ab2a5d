#include "api/codec/exports/svg_parts.hpp"

#include <array>
#include <cstdio>

#include "api/codec/bytes/xml_text.hpp"

namespace floeplan::codec {

std::string svg_head(const char* ground, double width, double height) {
  std::array<char, 256> head{};
  std::snprintf(head.data(), head.size(),
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" role=\"img\">\n"
                "<rect class=\"%s\" width=\"%.0f\" height=\"%.0f\"/>\n",
                width, height, ground, width, height);
  return head.data();
}

std::string svg_points(const std::vector<PicturePoint>& points) {
  std::string text;
  for (const auto& point : points) {
    std::array<char, 48> pair{};
    std::snprintf(pair.data(), pair.size(), "%s%.1f,%.1f", text.empty() ? "" : " ", point.x, point.y);
    text += pair.data();
  }
  return text;
}

std::string svg_line(const std::vector<PicturePoint>& points, const char* style) {
  return "<polyline class=\"" + std::string{style} + "\" points=\"" + svg_points(points) + "\"/>\n";
}

std::string svg_label(const PictureLabel& label, const char* style) {
  std::array<char, 96> start{};
  std::snprintf(start.data(), start.size(), "<text class=\"%s\" x=\"%.1f\" y=\"%.1f\">", style, label.at.x,
                label.at.y);
  return start.data() + xml_text(label.text) + "</text>\n";
}

}  // namespace floeplan::codec
