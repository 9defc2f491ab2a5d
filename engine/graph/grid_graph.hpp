#pragma once

#include <cstdint>
#include <vector>

namespace floeplan::graph {

using Vertex = std::uint32_t;

/// A step from one vertex to another, in columns and rows.
struct Offset {
  int dx{};
  int dy{};

  friend bool operator==(Offset, Offset) = default;
};

/// The steps of a k-sector grid: all (i, j) with max(|i|, |j|) <= k and without a common divisor, because a
/// shorter step already leads in that direction. 8, 16 or 32 steps for k = 1, 2, 3. Counter-clockwise from
/// east.
/// Source   Eichhorn 2009, Figure 4
/// Errors   std::invalid_argument unless 1 <= sectors <= 5
[[nodiscard]] std::vector<Offset> sector_offsets(int sectors);

/// A directed edge. `step` is the index of its offset.
struct Edge {
  Vertex tail{};
  Vertex head{};
  std::uint8_t step{};
};

/// A grid of nx columns and ny rows. Vertices are numbered row by row and joined by the steps of a k-sector
/// grid. A closed vertex has no edges. Edges are computed, not stored.
/// Threads  const members may be called from several threads at once
class GridGraph {
 public:
  /// `open`: nx * ny flags; empty: every vertex is open.
  /// Errors   std::invalid_argument for an empty or oversized grid or a wrong number of entries
  GridGraph(int nx, int ny, int sectors, std::vector<std::uint8_t> open = {});

  [[nodiscard]] int nx() const { return nx_; }
  [[nodiscard]] int ny() const { return ny_; }
  [[nodiscard]] const std::vector<Offset>& offsets() const { return offsets_; }
  /// Number of all vertices, open or closed.
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_);
  }
  [[nodiscard]] bool is_open(Vertex v) const { return open_.empty() || open_[v] != 0; }

  [[nodiscard]] Vertex vertex(int column, int row) const { return static_cast<Vertex>(row * nx_ + column); }
  [[nodiscard]] int column(Vertex v) const { return static_cast<int>(v % static_cast<Vertex>(nx_)); }
  [[nodiscard]] int row(Vertex v) const { return static_cast<int>(v / static_cast<Vertex>(nx_)); }
  [[nodiscard]] Vertex tail_of(Vertex head, std::uint8_t step) const {
    return vertex(column(head) - offsets_[step].dx, row(head) - offsets_[step].dy);
  }

  /// A copy in which only open vertices with a set flag in `kept` stay open. `kept` has `size()` flags.
  [[nodiscard]] GridGraph keeping(const std::vector<bool>& kept) const;

  [[nodiscard]] std::int64_t count_open_vertices() const;
  /// Number of directed edges between open vertices.
  [[nodiscard]] std::int64_t count_edges() const;

  /// Calls `visit(Edge)` for every edge that leaves `tail`, in the order of the offsets.
  template <class Visit>
  void for_each_edge(Vertex tail, Visit&& visit) const {
    const int x = column(tail);
    const int y = row(tail);
    const bool is_inside = x >= reach_ && x < nx_ - reach_ && y >= reach_ && y < ny_ - reach_;
    const auto steps = static_cast<std::uint8_t>(offsets_.size());
    for (std::uint8_t step = 0; step < steps; ++step) {
      if (!is_inside) {
        const int head_x = x + offsets_[step].dx;
        const int head_y = y + offsets_[step].dy;
        if (head_x < 0 || head_x >= nx_ || head_y < 0 || head_y >= ny_) continue;
      }
      const Vertex head = tail + strides_[step];
      if (is_open(head)) visit(Edge{tail, head, step});
    }
  }

 private:
  int nx_;
  int ny_;
  int reach_;  // columns or rows that the longest step spans
  std::vector<Offset> offsets_;
  std::vector<Vertex> strides_;  // change of the vertex number for each step, modulo 2^32
  std::vector<std::uint8_t> open_;
};

}  // namespace floeplan::graph
