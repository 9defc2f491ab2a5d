#include "engine/planning/currents/current_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace floeplan::planning::currents {
namespace {

constexpr double never_m = std::numeric_limits<double>::infinity();
constexpr double sliver = 1e-9;  // share of the edge: a shorter rest of a cell is skipped

motion::WayQuadratic rate(const motion::WayQuadratic& before, const motion::WayQuadratic& after,
                          double per_second) {
  const auto change = [&](motion::CurrentOnEdge a, motion::CurrentOnEdge b) {
    return motion::CurrentOnEdge{(b.along_m_s - a.along_m_s) * per_second,
                                 (b.across_m_s - a.across_m_s) * per_second};
  };
  return {change(before.constant, after.constant), change(before.linear, after.linear),
          change(before.square, after.square)};
}

}  // namespace

CurrentLine::CurrentLine(const PlaneCurrents& currents, const motion::PlaneEdge& edge)
    : currents_{currents}, edge_{edge}, direction_{edge} {
  const double plane_length = geo::distance_m(edge.from, edge.to);
  const double parts = std::ceil(plane_length * currents.straight_parts_per_metre_);
  parts_ = static_cast<std::size_t>(std::max(1.0, parts));
}

bool CurrentLine::begin(core::Seconds depart) {
  if (currents_.times_s_) {
    const auto when = currents_.times_s_->locate(depart.count());
    if (!when) return false;
    slice_ = when->cell;
  }
  return begin_part(0);
}

bool CurrentLine::begin_part(std::size_t part) {
  const auto place = [&](std::size_t i) {
    if (i == parts_) return edge_.to;
    const double share = static_cast<double>(i) / static_cast<double>(parts_);
    return geo::PlanePoint{edge_.from.x_m + share * (edge_.to.x_m - edge_.from.x_m),
                           edge_.from.y_m + share * (edge_.to.y_m - edge_.from.y_m)};
  };
  const double length_m = edge_.ground_length.value;
  const double part_length_m = length_m / static_cast<double>(parts_);
  part_ = part;
  part_start_m_ = part_length_m * static_cast<double>(part);
  part_end_m_ = part + 1 == parts_ ? length_m : part_start_m_ + part_length_m;

  const geo::GridPoint from = part == 0 ? currents_.lookup_.coordinates(edge_.from) : part_end_;
  part_end_ = currents_.lookup_.coordinates(place(part + 1));
  return enter(x_, currents_.x_, from.x, part_end_.x) && enter(y_, currents_.y_, from.y, part_end_.y) &&
         lay_cell();
}

bool CurrentLine::enter(Course& course, const plane::FastAxis& axis, double from, double to) const {
  const auto position = axis.locate(from);
  if (!position) return false;
  course.cell = position->cell;
  course.start = from;
  course.per_metre = (to - from) / (part_end_m_ - part_start_m_);
  find_exit(course, axis);
  return leave_cells_before(course, axis, part_start_m_);
}

void CurrentLine::find_exit(Course& course, const plane::FastAxis& axis) const {
  course.exit_way_m = never_m;
  if (course.per_metre == 0.0) return;
  const double border = axis.nodes()[course.cell + (course.per_metre > 0.0 ? 1 : 0)];
  const double exit_way_m = part_start_m_ + (border - course.start) / course.per_metre;
  if (exit_way_m < part_end_m_ - sliver * edge_.ground_length.value) course.exit_way_m = exit_way_m;
}

bool CurrentLine::leave_cells_before(Course& course, const plane::FastAxis& axis, double way_m) const {
  while (course.exit_way_m <= way_m + sliver * edge_.ground_length.value) {
    if (course.per_metre > 0.0) {
      if (course.cell + 2 >= axis.size()) return false;
      ++course.cell;
    } else {
      if (course.cell == 0) return false;
      --course.cell;
    }
    find_exit(course, axis);
  }
  return true;
}

bool CurrentLine::pass_way() {
  const double way_m = stretch_.end_way_m;
  if (way_m >= part_end_m_) return begin_part(part_ + 1);
  return leave_cells_before(x_, currents_.x_, way_m) && leave_cells_before(y_, currents_.y_, way_m) &&
         lay_cell();
}

bool CurrentLine::pass_time() {
  if (slice_ + 2 >= currents_.times_s_->size()) return false;
  ++slice_;
  stretch_.at_start = later_;
  return lay_time_step();
}

bool CurrentLine::lay_cell() {
  stretch_.end_way_m = std::min({x_.exit_way_m, y_.exit_way_m, part_end_m_});
  if (!sample(slice_, stretch_.at_start)) return false;
  return !currents_.times_s_ || lay_time_step();
}

bool CurrentLine::lay_time_step() {
  if (!sample(slice_ + 1, later_)) return false;
  const plane::FastAxis& times = *currents_.times_s_;
  stretch_.start_s = times.nodes()[slice_];
  stretch_.end_s = times.nodes()[slice_ + 1];
  stretch_.per_second = rate(stretch_.at_start, later_, times.inverse_width(slice_));
  return true;
}

bool CurrentLine::sample(std::size_t slice, motion::WayQuadratic& result) const {
  const std::size_t nx = currents_.x_.size();
  const PlaneCurrents::Node* south =
      currents_.nodes_.data() + (slice * currents_.y_.size() + y_.cell) * nx + x_.cell;
  const PlaneCurrents::Node* north = south + nx;

  // Position in the cell as shares of its sides: p0 + p1 * way and q0 + q1 * way, where way is the distance
  // covered.
  const double x_scale = currents_.x_.inverse_width(x_.cell);
  const double y_scale = currents_.y_.inverse_width(y_.cell);
  const double p1 = x_.per_metre * x_scale;
  const double q1 = y_.per_metre * y_scale;
  const double p0 = (x_.start - currents_.x_.nodes()[x_.cell]) * x_scale - p1 * part_start_m_;
  const double q0 = (y_.start - currents_.y_.nodes()[y_.cell]) * y_scale - q1 * part_start_m_;

  // Bilinear interpolation: f = sw + p * eastward + q * northward + p * q * twist
  const auto quadratic = [&](float sw, float se, float nw, float ne) {
    const auto origin = static_cast<double>(sw);
    const double eastward = static_cast<double>(se) - origin;
    const double northward = static_cast<double>(nw) - origin;
    const double twist = static_cast<double>(ne) - static_cast<double>(nw) - eastward;
    return std::array{origin + p0 * eastward + q0 * northward + p0 * q0 * twist,
                      p1 * eastward + q1 * northward + (p0 * q1 + p1 * q0) * twist, p1 * q1 * twist};
  };
  const auto x = quadratic(south[0].x_m_s, south[1].x_m_s, north[0].x_m_s, north[1].x_m_s);
  const auto y = quadratic(south[0].y_m_s, south[1].y_m_s, north[0].y_m_s, north[1].y_m_s);
  if (std::isnan(x[0])) return false;
  result = {direction_({x[0], y[0]}), direction_({x[1], y[1]}), direction_({x[2], y[2]})};
  return true;
}

CurrentLine PlaneCurrents::line(const motion::PlaneEdge& edge) const { return {*this, edge}; }

}  // namespace floeplan::planning::currents
