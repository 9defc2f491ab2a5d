#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "engine/reproduction/figure.hpp"

namespace floeplan::reproduction {
namespace {

// Margins in pixels around the drawing of a panel, for lines of text.
constexpr double left = 62.0;
constexpr double right = 22.0;
constexpr double above = 30.0;
constexpr double below = 52.0;
constexpr double title_height = 34.0;
constexpr double legend_line = 24.0;
constexpr double legend_width = 270.0;

/// Text formatted as by printf; for numbers and short texts.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...) {
  std::array<char, 400> text{};
  std::va_list values;
  va_start(values, pattern);
  std::vsnprintf(text.data(), text.size(), pattern, values);
  va_end(values);
  return text.data();
}

std::string text_at(double x, double y, const char* anchor, const std::string& words, const char* more = "") {
  return format("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\"%s>", x, y, anchor, more) + words +
         "</text>\n";
}

/// Position of the plane on the page.
struct Frame {
  const Figure& figure;
  double x0;  // upper left corner of the drawing
  double y0;

  [[nodiscard]] double x(double plane_x) const {
    return x0 + (plane_x - figure.x.low) / (figure.x.high - figure.x.low) * figure.x.pixels;
  }
  [[nodiscard]] double y(double plane_y) const {
    return y0 + (figure.y.high - plane_y) / (figure.y.high - figure.y.low) * figure.y.pixels;
  }
};

std::string axes(const Frame& frame) {
  const FigureAxis& x = frame.figure.x;
  const FigureAxis& y = frame.figure.y;
  const double bottom = frame.y0 + y.pixels;
  std::string svg =
      format("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"none\" stroke=\"#444\"/>\n",
             frame.x0, frame.y0, x.pixels, y.pixels);
  for (double value = x.low; value <= x.high + 1e-9; value += x.step) {
    svg += format("<path d=\"M%.1f %.1fv5\" stroke=\"#444\"/>\n", frame.x(value), bottom);
    svg += text_at(frame.x(value), bottom + 19.0, "middle", format("%g", value));
  }
  for (double value = y.low; value <= y.high + 1e-9; value += y.step) {
    svg += format("<path d=\"M%.1f %.1fh-5\" stroke=\"#444\"/>\n", frame.x0, frame.y(value));
    svg += text_at(frame.x0 - 9.0, frame.y(value) + 4.5, "end", format("%g", value));
  }
  svg += text_at(frame.x0 + 0.5 * x.pixels, bottom + 38.0, "middle", x.label);
  const double label_x = frame.x0 - 42.0;
  const double label_y = frame.y0 + 0.5 * y.pixels;
  svg += text_at(label_x, label_y, "middle", y.label,
                 format(" transform=\"rotate(-90 %.1f %.1f)\"", label_x, label_y).c_str());
  return svg;
}

/// An arrow that begins at this place of the page. If it is too short for a head, a dot.
std::string arrow(double x, double y, double dx, double dy) {
  const double length = std::hypot(dx, dy);
  if (length < 2.0) return format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"0.8\"/>\n", x, y);
  const double head = std::min(6.0, 0.5 * length);
  const double ex = dx / length;
  const double ey = dy / length;
  const double neck_x = x + dx - head * ex;
  const double neck_y = y + dy - head * ey;
  return format(
      "<path d=\"M%.1f %.1fL%.1f %.1f\"/><path d=\"M%.1f %.1fL%.1f %.1fL%.1f %.1fz\" stroke=\"none\"/>\n", x,
      y, neck_x, neck_y, x + dx, y + dy, neck_x - 0.4 * head * ey, neck_y + 0.4 * head * ex,
      neck_x + 0.4 * head * ey, neck_y - 0.4 * head * ex);
}

std::string arrows(const Frame& frame, const FigurePanel& panel) {
  std::string svg = "<g stroke=\"#8fb0c6\" fill=\"#8fb0c6\">\n";
  for (const FigureArrow& each : panel.arrows) {
    const double dx = each.current.x_m_s * frame.figure.pixels_per_speed;
    const double dy = -each.current.y_m_s * frame.figure.pixels_per_speed;
    svg += arrow(frame.x(each.at.x_m) - 0.5 * dx, frame.y(each.at.y_m) - 0.5 * dy, dx, dy);
  }
  return svg + "</g>\n";
}

std::string stroke_of(const FigurePath& path) {
  return format("stroke=\"%s\" stroke-width=\"2.2\"%s", path.colour.c_str(),
                path.dashed ? " stroke-dasharray=\"7 4\"" : "");
}

std::string path_line(const Frame& frame, const FigurePath& path) {
  std::string svg = "<polyline fill=\"none\" stroke-linejoin=\"round\" " + stroke_of(path) + " points=\"";
  for (const geo::PlanePoint point : path.points)
    svg += format("%.1f,%.1f ", frame.x(point.x_m), frame.y(point.y_m));
  svg.back() = '"';
  return svg + "/>\n";
}

std::string panel_svg(const Frame& frame, const FigurePanel& panel, int number) {
  const Figure& figure = frame.figure;
  std::string svg = format(
      "<clipPath id=\"panel%d\"><rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/></clipPath>\n",
      number, frame.x0, frame.y0, figure.x.pixels, figure.y.pixels);
  svg += format("<g clip-path=\"url(#panel%d)\">\n", number) + arrows(frame, panel);
  for (const Obstacle& obstacle : panel.obstacles) {
    svg += format("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"#7a6652\"/>\n",
                  frame.x(obstacle.low.x_m), frame.y(obstacle.high.y_m),
                  frame.x(obstacle.high.x_m) - frame.x(obstacle.low.x_m),
                  frame.y(obstacle.low.y_m) - frame.y(obstacle.high.y_m));
  }
  svg += "</g>\n" + axes(frame);
  for (const FigurePath& path : panel.paths) svg += path_line(frame, path);
  svg +=
      format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"5\" fill=\"#fff\" stroke=\"#000\" stroke-width=\"1.6\"/>\n",
             frame.x(figure.start.x_m), frame.y(figure.start.y_m));
  svg += format(
      "<rect x=\"%.1f\" y=\"%.1f\" width=\"9\" height=\"9\" fill=\"#fff\" stroke=\"#000\" "
      "stroke-width=\"1.6\"/>\n",
      frame.x(figure.goal.x_m) - 4.5, frame.y(figure.goal.y_m) - 4.5);
  if (panel.vehicle) {
    svg += format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4.5\" fill=\"#d55e00\"/>\n",
                  frame.x(panel.vehicle->x_m), frame.y(panel.vehicle->y_m));
  }
  return svg + text_at(frame.x0 + figure.x.pixels, frame.y0 - 9.0, "end", panel.title);
}

/// Entries of the legend: marks of start and goal, scale of the arrows, one line per path.
std::vector<std::string> legend_entries(const Figure& figure) {
  std::vector<std::string> entries;
  entries.push_back(
      "<circle cx=\"18\" cy=\"0\" r=\"5\" fill=\"#fff\" stroke=\"#000\" stroke-width=\"1.6\"/>" +
      text_at(30.0, 4.5, "start", "start") +
      "<rect x=\"84\" y=\"-4.5\" width=\"9\" height=\"9\" fill=\"#fff\" stroke=\"#000\" "
      "stroke-width=\"1.6\"/>" +
      text_at(100.0, 4.5, "start", "goal"));
  entries.push_back("<g stroke=\"#8fb0c6\" fill=\"#8fb0c6\">" +
                    arrow(0.0, 0.0, figure.pixels_per_speed, 0.0) + "</g>" +
                    text_at(figure.pixels_per_speed + 9.0, 4.5, "start", "current of 1" + figure.speed_unit));
  for (const FigurePath& path : figure.panels.front().paths) {
    entries.push_back("<path d=\"M0 0h36\" " + stroke_of(path) + "/>" +
                      text_at(45.0, 4.5, "start",
                              path.name +
                                  format(": %.*f", figure.time_unit.empty() ? 3 : 2, path.travel_time) +
                                  figure.time_unit));
  }
  if (figure.panels.front().vehicle) {
    entries.push_back("<circle cx=\"18\" cy=\"0\" r=\"4.5\" fill=\"#d55e00\"/>" +
                      text_at(45.0, 4.5, "start", "vehicle"));
  }
  return entries;
}

}  // namespace

std::string figure_svg(const Figure& figure) {
  const double panel_width = left + figure.x.pixels + right;
  const double panel_height = above + figure.y.pixels + below;
  const int in_a_row = figure.panels_in_a_row;
  const int rows = (static_cast<int>(figure.panels.size()) + in_a_row - 1) / in_a_row;
  const double width = in_a_row * panel_width;
  const std::vector<std::string> entries = legend_entries(figure);
  const int entries_in_a_row = std::max(1, static_cast<int>((width - left) / legend_width));
  const int legend_rows = (static_cast<int>(entries.size()) + entries_in_a_row - 1) / entries_in_a_row;
  const double legend_top = title_height + rows * panel_height + 10.0;
  const double height = legend_top + legend_rows * legend_line + 6.0;

  std::string svg = format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\" "
      "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"13\" fill=\"#222\">\n",
      width, height, width, height);
  svg += "<title>" + figure.title + "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  svg += text_at(left, 26.0, "start", figure.title, " font-size=\"17\" font-weight=\"bold\"");
  for (int i = 0; i < static_cast<int>(figure.panels.size()); ++i) {
    const int row = i / in_a_row;
    const Frame frame{figure, (i % in_a_row) * panel_width + left, title_height + row * panel_height + above};
    svg += panel_svg(frame, figure.panels[static_cast<std::size_t>(i)], i);
  }
  for (int i = 0; i < static_cast<int>(entries.size()); ++i) {
    const int row = i / entries_in_a_row;
    svg += format("<g transform=\"translate(%.1f %.1f)\">", left + (i % entries_in_a_row) * legend_width,
                  legend_top + row * legend_line) +
           entries[static_cast<std::size_t>(i)] + "</g>\n";
  }
  return svg + "</svg>\n";
}

}  // namespace floeplan::reproduction
