#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/motion/edge_fan.hpp"
#include "engine/planning/currents/plane_currents.hpp"

namespace floeplan::planning::currents {

/// The currents that a vehicle can meet on edges of bounded length from a point: the current at the point as
/// it changes with time, and bounds of the difference elsewhere, from the nodes of the data.
/// Accuracy the bounds hold on all edges that the data cover throughout; other edges are closed anyway
/// Threads  one at a time: bounds are computed when they are first needed
class NearbyCurrents {
 public:
  /// `currents` is borrowed and must outlive this. `longest_edge`: metres of the plane; `longest_drive`: time
  /// along it.
  NearbyCurrents(const PlaneCurrents& currents, core::Metres longest_edge, core::Seconds longest_drive);

  /// Whether the bounds help. They do not if the longitudes of the data jump, if edges cross many cells,
  /// because the bounds are then wide, or if the data are large, because the bounds then take too long.
  [[nodiscard]] bool is_useful() const { return useful_; }

  enum class Film {
    forwards,
    backwards  // time-reversed: the clock shows -t, and currents are reversed
  };
  /// The current around a point from `time` on; in a time-reversed search, with the time and the current
  /// reversed. Empty where it is unknown. Precondition: `is_useful()`.
  [[nodiscard]] std::optional<motion::NearbyCurrent> on_film(geo::PlanePoint point, core::Seconds time,
                                                             Film film);

 private:
  enum class Cover : std::uint8_t {
    never,
    always,
    sometimes  // the data have gaps, so no bound is known
  };
  /// Bounds of the current's slopes: the changes of x and y per unit of u, then of x and y per unit of v.
  struct Box {
    std::array<float, 4> low;
    std::array<float, 4> high;

    void include(const Box& more);
  };
  struct Cell {
    std::size_t x;
    std::size_t y;
  };
  struct Place {
    plane::GridLookup::Surroundings around;
    Cell cell;
    std::size_t first;  // index of the south-western node
    double fx;
    double fy;
  };
  /// Range of cells along a data axis that edges can reach, both ends included.
  struct Span {
    std::size_t from;
    std::size_t to;
  };
  /// The ranges for edges up the axis and for edges down the axis.
  struct Spans {
    Span up;
    Span down;
  };
  using Quarters = std::array<Box, motion::NearbyCurrent::quarters>;
  [[nodiscard]] std::optional<Place> place(geo::PlanePoint point) const;
  [[nodiscard]] motion::CurrentXy at(const Place& place, std::size_t slice) const;
  void judge_cells();
  [[nodiscard]] static Spans spans(const plane::FastAxis& axis, std::size_t cell, double share, double reach,
                                   double off_line, double narrowest);
  /// Largest number of slices that an edge can meet.
  [[nodiscard]] std::size_t slices_met() const;
  /// Bounds for a cell over all slices that an edge can meet from `first_slice` on; cached.
  [[nodiscard]] const Box& box_from(Cell cell, std::size_t first_slice);
  [[nodiscard]] std::vector<Box> boxes_of_tile(Cell first, std::size_t first_slice) const;
  /// Bounds for one cell in one slice.
  [[nodiscard]] Box box_of(Cell cell, std::size_t slice) const;
  /// Bounds for edges into each quarter, from `first_slice` on.
  [[nodiscard]] Quarters boxes_about(const Place& place, std::size_t first_slice);
  /// Adds the bounds from `first_slice` on to `near`; false if none are known.
  bool enclose(motion::NearbyCurrent& near, const Place& place, std::size_t first_slice, float sign);

  const PlaneCurrents& currents_;
  double longest_s_;
  bool useful_{false};
  std::size_t cells_x_{};
  std::size_t cells_y_{};
  // In units of the data's coordinates:
  geo::GridPoint reach_;       // largest extent of an edge
  geo::GridPoint off_line_;    // deviation of an edge from a straight line
  geo::GridPoint narrowest_;   // narrowest cell
  std::vector<Cover> covers_;  // [y][x]
  std::size_t slices_met_{1};
  std::size_t tiles_x_{};
  std::size_t tiles_y_{};
  std::vector<std::vector<Box>> tiles_;  // [first slice][y][x]; empty until needed
};

}  // namespace floeplan::planning::currents
