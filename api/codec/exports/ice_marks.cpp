#include "api/codec/exports/ice_marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/graph/contour.hpp"

namespace floeplan::codec {
namespace {

using Line = IceMarks::Line;

/// The ice edge, then open, close and very close ice. Source: WMO Sea-Ice Nomenclature, WMO No. 259; the edge of 15 % is
/// the convention of passive microwave products.
constexpr std::array<double, 4> levels{0.15, 0.4, 0.7, 0.9};

constexpr double node_spacing = 6.0;
constexpr double hatch_spacing = 12.0;
constexpr double dot_length = 1.2;
constexpr double unknown_spacing = 18.0;
constexpr double unknown_length = 5.0;
constexpr double sampled_every = 2.0;  // along a line of the hatch

/// Concentrations on a lattice that reaches one node beyond the picture; NaN: unknown.
class Lattice {
 public:
  Lattice(double width, double height, const ConcentrationAt& concentration)
      : nx_{static_cast<int>(std::ceil(width / node_spacing)) + 3},
        ny_{static_cast<int>(std::ceil(height / node_spacing)) + 3} {
    values_.reserve(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_));
    for (int row = 0; row < ny_; ++row)
      for (int column = 0; column < nx_; ++column)
        values_.push_back(concentration(point({static_cast<double>(column), static_cast<double>(row)}))
                              .value_or(std::numeric_limits<double>::quiet_NaN()));
  }

  /// Bilinear; NaN beside unknown nodes.
  [[nodiscard]] double at(PicturePoint point) const {
    const double column = std::clamp(point.x / node_spacing + 1.0, 0.0, nx_ - 1.001);
    const double row = std::clamp(point.y / node_spacing + 1.0, 0.0, ny_ - 1.001);
    const int i = static_cast<int>(column);
    const int j = static_cast<int>(row);
    return std::lerp(std::lerp(value(i, j), value(i + 1, j), column - i),
                     std::lerp(value(i, j + 1), value(i + 1, j + 1), column - i), row - j);
  }

  /// The lines around what lies above a level, interrupted where the ice beside them is unknown.
  [[nodiscard]] std::vector<Line> lines_at(double level) const {
    std::vector<std::uint8_t> inside(values_.size());
    std::ranges::transform(values_, inside.begin(), [&](double value) { return value > level ? 1 : 0; });
    const auto share = [&](graph::Vertex in, graph::Vertex out) {
      return std::isnan(values_[out]) ? 0.5 : (values_[in] - level) / (values_[in] - values_[out]);
    };
    std::vector<Line> lines;
    for (const graph::GridPolygon& polygon : graph::contour(nx_, ny_, inside, share)) {
      add_line(polygon.outer, lines);
      for (const graph::GridRing& hole : polygon.holes) add_line(hole, lines);
    }
    return lines;
  }

 private:
  [[nodiscard]] double value(int column, int row) const {
    return values_[static_cast<std::size_t>(row) * static_cast<std::size_t>(nx_) +
                   static_cast<std::size_t>(column)];
  }
  [[nodiscard]] static PicturePoint point(graph::GridPlace place) {
    return {(place.column - 1.0) * node_spacing, (place.row - 1.0) * node_spacing};
  }
  /// Whether a crossing lies between two nodes with ice data; on the rim of the lattice it does not.
  [[nodiscard]] bool is_known(graph::GridPlace place) const {
    const auto node = [&](double column, double row) {
      const bool is_on_lattice = column >= 0.0 && row >= 0.0 && column < nx_ && row < ny_;
      return is_on_lattice && !std::isnan(value(static_cast<int>(column), static_cast<int>(row)));
    };
    return node(std::floor(place.column), std::floor(place.row)) &&
           node(std::ceil(place.column), std::ceil(place.row));
  }
  void add_line(const graph::GridRing& ring, std::vector<Line>& lines) const {
    Line line;
    const auto finish = [&] {
      if (line.size() > 1) lines.push_back(line);
      line.clear();
    };
    for (std::size_t i = 0; i <= ring.size(); ++i) {  // the last place is joined to the first
      const graph::GridPlace place = ring[i % ring.size()];
      if (is_known(place))
        line.push_back(point(place));
      else
        finish();
    }
    finish();
  }

  int nx_;
  int ny_;
  std::vector<double> values_;
};

/// A rectangle that is hatched.
struct Area {
  double left{};
  double top{};
  double right{};
  double bottom{};
};

/// Adds the parts with enough ice of slanting lines. `down` is 1 if they lead down to the right, -1 if up.
template <class Ice>
void add_slanting(const Area& area, double down, double offset, double level, const Ice& ice,
                  std::vector<Line>& lines) {
  const double height = area.bottom - area.top;
  for (double start = area.left - height + offset; start < area.right; start += hatch_spacing) {
    Line line;
    const auto finish = [&] {
      if (line.size() == 2) lines.push_back(line);
      line.clear();
    };
    for (double gone = 0.0; gone <= height; gone += sampled_every) {
      const PicturePoint here{start + gone, down > 0.0 ? area.top + gone : area.bottom - gone};
      if (here.x < area.left || here.x > area.right || !(ice(here) >= level)) {
        finish();
        continue;
      }
      if (line.size() == 2)
        line.back() = here;
      else
        line.push_back(here);
    }
    finish();
  }
}

/// Adds short horizontal lines, every second row of them shifted, where `is_wanted`.
template <class Wanted>
void add_rows(const Area& area, double spacing, double length, const Wanted& is_wanted,
              std::vector<Line>& lines) {
  double shift = 0.25 * spacing;
  for (double y = area.top + 0.25 * spacing; y < area.bottom; y += 0.5 * spacing) {
    for (double x = area.left + shift; x + length < area.right; x += spacing)
      if (is_wanted({x, y})) lines.push_back({{x, y}, {x + length, y}});
    shift = spacing - shift;
  }
}

template <class Ice>
void add_hatch(const Area& area, const Ice& ice, std::vector<Line>& lines) {
  add_rows(area, hatch_spacing, dot_length, [&](PicturePoint here) { return ice(here) >= levels[0]; }, lines);
  add_slanting(area, 1.0, 0.0, levels[1], ice, lines);
  add_slanting(area, 1.0, 0.5 * hatch_spacing, levels[2], ice, lines);
  add_slanting(area, -1.0, 0.0, levels[3], ice, lines);
}

template <class Ice>
void add_unknown(const Area& area, const Ice& ice, std::vector<Line>& lines) {
  add_rows(
      area, unknown_spacing, unknown_length, [&](PicturePoint here) { return std::isnan(ice(here)); }, lines);
}

std::string percent(double share) { return std::to_string(std::lround(100.0 * share)) + " %"; }

}  // namespace

IceMarks draw_ice(double width, double height, const ConcentrationAt& concentration, double limit) {
  const Lattice lattice{width, height, concentration};
  const auto ice = [&](PicturePoint here) { return lattice.at(here); };
  const Area all{0.0, 0.0, width, height};
  IceMarks marks;
  add_hatch(all, ice, marks.hatch);
  add_unknown(all, ice, marks.unknown);
  marks.edge = lattice.lines_at(levels[0]);
  marks.limit = lattice.lines_at(limit);
  return marks;
}

IceKey draw_ice_key(double width, double limit) {
  constexpr double swatch_width = 36.0;
  constexpr double swatch_height = 14.0;
  constexpr double gap = 4.0;
  IceKey key{.width = width, .height = 44.0};
  const double cell = width / 5.0;
  const auto swatch = [&](int column, double top) {
    const double left = cell * column + gap;
    return Area{left, top, left + swatch_width, top + swatch_height};
  };
  const auto name = [&](const Area& at, const std::string& text) {
    key.labels.push_back({{at.right + gap, at.bottom - 4.0}, text});
  };
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const Area at = swatch(static_cast<int>(i), gap);
    add_hatch(at, [&](PicturePoint) { return levels[i]; }, key.marks.hatch);
    name(at, "ice " + percent(levels[i]) + " to " + percent(i + 1 < levels.size() ? levels[i + 1] : 1.0));
  }
  const Area unknown = swatch(4, gap);
  add_unknown(
      unknown, [](PicturePoint) { return std::numeric_limits<double>::quiet_NaN(); }, key.marks.unknown);
  name(unknown, "no ice data");
  const auto line = [&](const Area& at) {
    return Line{{at.left, 0.5 * (at.top + at.bottom)}, {at.right, 0.5 * (at.top + at.bottom)}};
  };
  const Area edge = swatch(0, 24.0);
  key.marks.edge.push_back(line(edge));
  name(edge, "ice edge, " + percent(levels[0]));
  const Area bound = swatch(1, 24.0);
  key.marks.limit.push_back(line(bound));
  name(bound, "surfacing limit: no surfacing in more than " + percent(limit));
  return key;
}

std::string svg(const IceMarks& marks) {
  std::string text;
  const auto add = [&](const std::vector<Line>& lines, const char* style) {
    if (lines.empty()) return;
    text += "<path class=\"" + std::string{style} + "\" d=\"";
    for (const Line& line : lines) text += "M" + svg_points(line);
    text += "\"/>\n";
  };
  add(marks.hatch, "hatch");
  add(marks.unknown, "hatch");
  add(marks.edge, "edge");
  add(marks.limit, "limit");
  return text;
}

std::string svg(const IceKey& key) {
  std::string text = svg_head("paper", key.width, key.height) + svg(key.marks);
  for (const auto& label : key.labels) text += svg_label(label, "small");
  return text + "</svg>\n";
}

}  // namespace floeplan::codec
