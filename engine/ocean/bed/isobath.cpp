#include "engine/ocean/bed/isobath.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>

namespace floeplan::ocean {
namespace {

/// A side of a cell: twice the number of its lower or left node, plus one if it runs upwards.
using Side = std::size_t;

/// Line pieces between sides. A side lies between two cells, so at most one piece begins there and one ends
/// there.
class Pieces {
 public:
  void add(Side from, Side to) {
    next_.emplace(from, to);
    ends_.insert(to);
  }

  /// Joins the pieces to lines. No piece remains.
  std::vector<std::vector<Side>> take_lines() {
    std::vector<Side> beginnings;
    for (const auto& [from, to] : next_)
      if (!ends_.contains(from)) beginnings.push_back(from);
    std::vector<std::vector<Side>> lines;
    lines.reserve(beginnings.size());
    for (const Side from : beginnings) lines.push_back(take_line(from));
    while (!next_.empty()) lines.push_back(take_line(next_.begin()->first));
    return lines;
  }

 private:
  std::vector<Side> take_line(Side first) {
    std::vector<Side> line{first};
    for (auto piece = next_.find(first); piece != next_.end(); piece = next_.find(line.back())) {
      line.push_back(piece->second);
      next_.erase(piece);
    }
    return line;
  }

  std::map<Side, Side> next_;
  std::set<Side> ends_;
};

class Tracer {
 public:
  Tracer(const Bathymetry& bathymetry, core::Metres depth)
      : grid_{bathymetry.grid()},
        depths_{bathymetry.depth_m()},
        level_{depth.value},
        columns_{grid_.x().size()} {}

  std::vector<Isobath> run() {
    for (std::size_t row = 0; row + 1 < grid_.y().size(); ++row)
      for (std::size_t column = 0; column + 1 < columns_; ++column) cross(row * columns_ + column);
    std::vector<Isobath> lines;
    for (const auto& sides : pieces_.take_lines()) {
      Isobath& line = lines.emplace_back();
      for (const Side side : sides) line.push_back(place_on(side));
    }
    return lines;
  }

 private:
  /// Adds the pieces of one cell, by its lower left node.
  void cross(std::size_t node) {
    // Corners counter-clockwise from the lower left; side i runs from corner i to the next one.
    const std::array<std::size_t, 4> corners{node, node + 1, node + columns_ + 1, node + columns_};
    const std::array<Side, 4> sides{2 * node, 2 * (node + 1) + 1, 2 * (node + columns_), 2 * node + 1};
    double sum_m = 0.0;
    unsigned deep = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const double depth_m = depths_[corners[i]];
      if (std::isnan(depth_m)) return;
      sum_m += depth_m;
      deep |= (depth_m >= level_ ? 1U : 0U) << i;
    }
    if (deep == 0 || deep == 15) return;

    // Deeper water lies on the left of the line. So going round the cell counter-clockwise, the line enters
    // at a side from deep to shallow, and leaves at one from shallow to deep.
    const bool joined = sum_m / 4.0 >= level_;
    for (unsigned in = 0; in < 4; ++in) {
      if (!turns_shallow(deep, in)) continue;
      // Separate deep corners are each cut off alone: the line turns back to the side before. Joined ones
      // leave the shallow corner.
      const unsigned step = is_saddle(deep) && !joined ? 3 : 1;
      unsigned out = (in + step) % 4;
      while (!turns_deep(deep, out)) out = (out + step) % 4;
      pieces_.add(sides[in], sides[out]);
    }
  }

  static bool corner(unsigned deep, unsigned i) { return ((deep >> (i % 4)) & 1U) != 0; }
  static bool turns_shallow(unsigned deep, unsigned side) {
    return corner(deep, side) && !corner(deep, side + 1);
  }
  static bool turns_deep(unsigned deep, unsigned side) {
    return !corner(deep, side) && corner(deep, side + 1);
  }
  static bool is_saddle(unsigned deep) { return deep == 0b0101 || deep == 0b1010; }

  [[nodiscard]] geo::LonLat place_on(Side side) const {
    const std::size_t a = side / 2;
    const std::size_t b = side % 2 == 0 ? a + 1 : a + columns_;
    const double share = (level_ - depths_[a]) / (static_cast<double>(depths_[b]) - depths_[a]);
    const auto& x = grid_.x();
    const auto& y = grid_.y();
    return grid_.projection().to_lon_lat({std::lerp(x[a % columns_], x[b % columns_], share),
                                          std::lerp(y[a / columns_], y[b / columns_], share)});
  }

  const HorizontalGrid& grid_;
  const std::vector<float>& depths_;
  double level_;
  std::size_t columns_;
  Pieces pieces_;
};

}  // namespace

std::vector<Isobath> isobaths(const Bathymetry& bathymetry, core::Metres depth) {
  return Tracer{bathymetry, depth}.run();
}

}  // namespace floeplan::ocean
