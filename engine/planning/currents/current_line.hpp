#pragma once

#include <cstddef>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/motion/plane_edge.hpp"
#include "engine/motion/quadratic_stretch.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/planning/currents/plane_currents.hpp"
#include "engine/planning/plane/fast_axis.hpp"

namespace floeplan::planning::currents {

/// The current that a vehicle meets along one edge. Within each cell of the data and each of their time steps
/// it is exactly a quadratic of the distance covered, and linear in time.
/// Accuracy the edge is taken as straight in the data's coordinates, in parts short enough that the error is
/// at most a four thousandth of a cell
class CurrentLine {
 public:
  /// `currents` and `edge` are borrowed and must outlive the line.
  CurrentLine(const PlaneCurrents& currents, const motion::PlaneEdge& edge);

  /// Puts the vehicle at the edge's start at `depart`; false if there are no data at that time.
  bool begin(core::Seconds depart);
  [[nodiscard]] const motion::QuadraticStretch& stretch() const { return stretch_; }
  /// `pass_way` moves on to the next stretch in space, `pass_time` to the next in time; false if there are no
  /// data.
  bool pass_way();
  bool pass_time();

 private:
  /// One data coordinate along the current part of the line, and the cell that the vehicle is in.
  struct Course {
    double start{};
    double per_metre{};
    std::size_t cell{};
    double exit_way_m{};  // infinite if the vehicle stays in the cell to the part's end
  };

  bool begin_part(std::size_t part);
  bool enter(Course& course, const plane::FastAxis& axis, double from, double to) const;
  void find_exit(Course& course, const plane::FastAxis& axis) const;
  bool leave_cells_before(Course& course, const plane::FastAxis& axis, double way_m) const;
  bool lay_cell();
  bool lay_time_step();
  [[nodiscard]] bool sample(std::size_t slice, motion::WayQuadratic& result) const;

  const PlaneCurrents& currents_;
  const motion::PlaneEdge& edge_;
  motion::EdgeDirection direction_;
  std::size_t parts_{1};
  std::size_t part_{};
  double part_start_m_{};
  double part_end_m_{};
  geo::GridPoint part_end_;  // in the data's coordinates
  Course x_;
  Course y_;
  std::size_t slice_{};
  motion::WayQuadratic later_;  // at the end of the time step
  motion::QuadraticStretch stretch_;
};

}  // namespace floeplan::planning::currents
