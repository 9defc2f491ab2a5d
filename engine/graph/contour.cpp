#include "engine/graph/contour.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace floeplan::graph {
namespace {

/// The outline crosses a line between vertices at least this share from its ends, so that rings stay apart:
/// by some centimetres, more than the rounding of places in documents.
constexpr double least_share = 1e-3;
/// The limit of lines that lead out of the grid, so that the area ends on the grid's rim.
constexpr double rim_share = 1e-6;

/// The grid with a frame of outside vertices around it. Lines between neighbours are numbered: for each
/// vertex first the one to the right, then the one upwards.
class FramedGrid {
 public:
  FramedGrid(int nx, int ny, const std::vector<std::uint8_t>& inside) : nx_{nx}, ny_{ny}, inside_{inside} {}

  [[nodiscard]] bool is_inside(int x, int y) const {
    return x >= 0 && x < nx_ && y >= 0 && y < ny_ && inside_[vertex(x, y)] != 0;
  }
  [[nodiscard]] bool is_vertex(int x, int y) const { return x >= 0 && x < nx_ && y >= 0 && y < ny_; }
  [[nodiscard]] Vertex vertex(int x, int y) const { return static_cast<Vertex>(y * nx_ + x); }

  [[nodiscard]] std::size_t line(int x, int y, bool upwards) const {
    const auto width = static_cast<std::size_t>(nx_) + 2;
    return 2 * (static_cast<std::size_t>(y + 1) * width + static_cast<std::size_t>(x + 1)) +
           (upwards ? 1 : 0);
  }

 private:
  int nx_;
  int ny_;
  const std::vector<std::uint8_t>& inside_;
};

/// A piece of the outline through one cell, from one line to another. The inside lies on its left.
struct Piece {
  std::size_t from{};
  std::size_t to{};
  GridPlace start;  // where the piece begins, on the line `from`
};

class Tracer {
 public:
  Tracer(int nx, int ny, const std::vector<std::uint8_t>& inside, const BorderShare& share)
      : grid_{nx, ny, inside}, share_{share} {
    for (int y = -1; y < ny; ++y) {
      for (int x = -1; x < nx; ++x) cross_cell(x, y);
    }
    std::ranges::sort(pieces_, {}, &Piece::from);
  }

  [[nodiscard]] std::vector<GridRing> rings() const {
    std::vector<GridRing> result;
    std::vector<bool> used(pieces_.size(), false);
    for (std::size_t first = 0; first < pieces_.size(); ++first) {
      if (used[first]) continue;
      GridRing ring;
      for (std::size_t i = first; !used[i]; i = piece_from(pieces_[i].to)) {
        used[i] = true;
        ring.push_back(pieces_[i].start);
      }
      result.push_back(std::move(ring));
    }
    return result;
  }

 private:
  using Corner = std::array<int, 2>;

  /// Each group of consecutive inside corners, counter-clockwise, is cut off by one piece. It enters on the
  /// line after the group and leaves on the line before it.
  void cross_cell(int x, int y) {
    const std::array<Corner, 4> corners{{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
    const std::array<std::size_t, 4> lines{grid_.line(x, y, false), grid_.line(x + 1, y, true),
                                           grid_.line(x, y + 1, false), grid_.line(x, y, true)};
    std::array<bool, 4> in{};
    for (std::size_t i = 0; i < 4; ++i) in[i] = grid_.is_inside(corners[i][0], corners[i][1]);
    for (std::size_t last = 0; last < 4; ++last) {
      const std::size_t after = (last + 1) % 4;
      if (!in[last] || in[after]) continue;
      std::size_t first = last;
      while (in[(first + 3) % 4]) first = (first + 3) % 4;
      pieces_.push_back({lines[last], lines[(first + 3) % 4], border(corners[last], corners[after])});
    }
  }

  [[nodiscard]] GridPlace border(Corner inside, Corner outside) const {
    double share = rim_share;
    if (grid_.is_vertex(outside[0], outside[1])) {
      share = std::clamp(share_(grid_.vertex(inside[0], inside[1]), grid_.vertex(outside[0], outside[1])),
                         least_share, 1.0 - least_share);
    }
    return {inside[0] + share * (outside[0] - inside[0]), inside[1] + share * (outside[1] - inside[1])};
  }

  [[nodiscard]] std::size_t piece_from(std::size_t line) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(pieces_, line, {}, &Piece::from) -
                                    pieces_.begin());
  }

  FramedGrid grid_;
  const BorderShare& share_;
  std::vector<Piece> pieces_;
};

double doubled_area(const GridRing& ring) {
  double sum = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridPlace& a = ring[i];
    const GridPlace& b = ring[(i + 1) % ring.size()];
    sum += a.column * b.row - b.column * a.row;
  }
  return sum;
}

bool contains(const GridRing& ring, GridPlace place) {
  bool odd = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GridPlace& a = ring[i];
    const GridPlace& b = ring[(i + 1) % ring.size()];
    if ((a.row > place.row) == (b.row > place.row)) continue;
    const double column = a.column + (place.row - a.row) / (b.row - a.row) * (b.column - a.column);
    if (column > place.column) odd = !odd;
  }
  return odd;
}

}  // namespace

std::vector<GridPolygon> contour(int nx, int ny, const std::vector<std::uint8_t>& inside,
                                 const BorderShare& share) {
  std::vector<GridPolygon> polygons;
  std::vector<GridRing> holes;
  for (GridRing& ring : Tracer{nx, ny, inside, share}.rings()) {
    if (doubled_area(ring) > 0.0) {
      polygons.push_back({std::move(ring), {}});
    } else {
      holes.push_back(std::move(ring));
    }
  }
  for (GridRing& hole : holes) {
    // A hole belongs to the smallest polygon around it.
    GridPolygon* around = nullptr;
    double least = 0.0;
    for (GridPolygon& polygon : polygons) {
      if (!contains(polygon.outer, hole.front())) continue;
      const double area = doubled_area(polygon.outer);
      if (around == nullptr || area < least) {
        around = &polygon;
        least = area;
      }
    }
    if (around != nullptr) around->holes.push_back(std::move(hole));
  }
  return polygons;
}

}  // namespace floeplan::graph
