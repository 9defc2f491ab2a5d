#include "engine/planning/currents/current_envelope.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floeplan::planning::currents {
namespace {

using Box = CurrentEnvelope::Box;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr Box nothing{infinity, -infinity, infinity, -infinity};
/// Straight lines of the plane may bend in the data's coordinates by this share of a cell, with room to
/// spare.
constexpr double beside_cell = 1e-3;

void include(Box& box, const Box& more) {
  box.low_x_m_s = std::min(box.low_x_m_s, more.low_x_m_s);
  box.high_x_m_s = std::max(box.high_x_m_s, more.high_x_m_s);
  box.low_y_m_s = std::min(box.low_y_m_s, more.low_y_m_s);
  box.high_y_m_s = std::max(box.high_y_m_s, more.high_y_m_s);
}

/// Number of cells on each side of a cell that its neighbourhood includes.
std::size_t cells_within(double coordinate_reach, const plane::FastAxis& axis) {
  double narrowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < axis.size(); ++i)
    narrowest = std::min(narrowest, axis.nodes()[i] - axis.nodes()[i - 1]);
  const double cells = std::ceil(coordinate_reach / narrowest + beside_cell);
  return static_cast<std::size_t>(std::min(cells, static_cast<double>(axis.size())));
}

/// For each cell of a row of nodes: the box that encloses the values of its two nodes and of those within
/// `reach` nodes.
void enclose_row(const Box* nodes, std::size_t stride, std::size_t count, std::size_t reach, Box* cells,
                 std::size_t cell_stride) {
  for (std::size_t cell = 0; cell + 1 < count; ++cell) {
    const std::size_t first = cell < reach ? 0 : cell - reach;
    const std::size_t last = std::min(cell + 1 + reach, count - 1);
    Box box = nothing;
    for (std::size_t i = first; i <= last; ++i) include(box, nodes[i * stride]);
    cells[cell * cell_stride] = box;
  }
}

}  // namespace

core::MetresPerSecond Box::most_along(geo::PlanePoint direction) const {
  const double along_x = direction.x_m * static_cast<double>(direction.x_m > 0.0 ? high_x_m_s : low_x_m_s);
  const double along_y = direction.y_m * static_cast<double>(direction.y_m > 0.0 ? high_y_m_s : low_y_m_s);
  return core::MetresPerSecond{along_x + along_y};
}

CurrentEnvelope::CurrentEnvelope(const PlaneCurrents& currents, core::Metres reach) : currents_{currents} {
  const auto strongest = static_cast<float>(currents.strongest().value);
  anywhere_ = {-strongest, strongest, -strongest, strongest};
  const std::size_t nx = currents.x_.size();
  const std::size_t ny = currents.y_.size();
  if (!currents.has_lines() || nx < 2 || ny < 2) return;

  const geo::GridPoint steepest = currents.lookup_.steepest();
  const std::size_t reach_x = cells_within(steepest.x * reach.value, currents.x_);
  const std::size_t reach_y = cells_within(steepest.y * reach.value, currents.y_);
  const std::vector<Box> nodes = boxes_of_nodes();
  std::vector<Box> columns(nx * (ny - 1));
  for (std::size_t ix = 0; ix < nx; ++ix)
    enclose_row(nodes.data() + ix, nx, ny, reach_y, columns.data() + ix, nx);
  boxes_.resize((nx - 1) * (ny - 1));
  for (std::size_t iy = 0; iy + 1 < ny; ++iy)
    enclose_row(columns.data() + iy * nx, 1, nx, reach_x, boxes_.data() + iy * (nx - 1), 1);
}

std::vector<Box> CurrentEnvelope::boxes_of_nodes() const {
  const std::size_t slice = currents_.x_.size() * currents_.y_.size();
  std::vector<Box> boxes(slice, nothing);
  for (std::size_t first = 0; first < currents_.nodes_.size(); first += slice) {
    const PlaneCurrents::Node* const nodes = currents_.nodes_.data() + first;
    for (std::size_t i = 0; i < slice; ++i) {
      const PlaneCurrents::Node& node = nodes[i];
      if (std::isnan(node.x_m_s)) continue;
      include(boxes[i], {node.x_m_s, node.x_m_s, node.y_m_s, node.y_m_s});
    }
  }
  return boxes;
}

Box CurrentEnvelope::about(geo::PlanePoint point) const {
  if (boxes_.empty()) return anywhere_;
  const geo::GridPoint at = currents_.lookup_.coordinates(point);
  const auto x = currents_.x_.locate(at.x);
  const auto y = currents_.y_.locate(at.y);
  if (!x || !y) return anywhere_;
  const Box& box = boxes_[y->cell * (currents_.x_.size() - 1) + x->cell];
  return box.low_x_m_s <= box.high_x_m_s ? box : anywhere_;
}

}  // namespace floeplan::planning::currents
