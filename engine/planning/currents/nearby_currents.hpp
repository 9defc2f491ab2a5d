#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/motion/edge_fan.hpp"
#include "engine/planning/currents/plane_currents.hpp"

namespace floeplan::planning::currents {

/// What a vehicle can meet of the currents on edges of bounded length that leave a point: the water at the point
/// itself as it changes with time, and enclosures of how much it may differ elsewhere, taken from the data's nodes.
/// Accuracy encloses all that the currents answer on edges that the data cover throughout; elsewhere no vehicle
///          gets through
/// Threads  one at a time: enclosures are worked out when they are first needed
class NearbyCurrents {
 public:
  /// `currents` is borrowed and outlives this. `longest_edge`: in metres of the plane; `longest_drive`: along one.
  NearbyCurrents(const PlaneCurrents& currents, core::Metres longest_edge, core::Seconds longest_drive);

  /// Whether there is something to be gained: not where the data's longitudes jump, nor where edges reach over so
  /// many cells of the data that an enclosure would say little, nor with so many data that it would cost too much.
  [[nodiscard]] bool is_useful() const { return useful_; }

  enum class Film {
    forwards,
    backwards  // its clock shows -t, and the water flows the other way
  };
  /// The water about a point from a time on, as the film shows it. Empty where nothing is known. Precondition:
  /// `is_useful()`.
  [[nodiscard]] std::optional<motion::NearbyCurrent> on_film(geo::PlanePoint point, core::Seconds time,
                                                             Film film);

 private:
  enum class Cover : std::uint8_t {
    never,
    always,
    sometimes  // nothing can be said of it
  };
  /// Between which values the current's changes lie: of x and y for each unit of u, of x and y for each of v.
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
  /// Cells along an axis of the data that edges can come to, both ends included.
  struct Span {
    std::size_t from;
    std::size_t to;
  };
  /// One span for the edges that go up the axis and one for those that go down.
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
  /// Slices that an edge can meet at most, from the first one on.
  [[nodiscard]] std::size_t slices_met() const;
  /// Box of the currents of a cell in all slices that an edge can meet from the first one on; it is kept.
  [[nodiscard]] const Box& box_from(Cell cell, std::size_t first_slice);
  [[nodiscard]] std::vector<Box> boxes_of_tile(Cell first, std::size_t first_slice) const;
  /// Box of the currents of one cell in one slice.
  [[nodiscard]] Box box_of(Cell cell, std::size_t slice) const;
  /// What edges into each quarter can meet from a slice on.
  [[nodiscard]] Quarters boxes_about(const Place& place, std::size_t first_slice);
  /// Adds what encloses the water from a slice on; false where nothing can be said.
  bool enclose(motion::NearbyCurrent& near, const Place& place, std::size_t first_slice, float sign);

  const PlaneCurrents& currents_;
  double longest_s_;
  bool useful_{false};
  std::size_t cells_x_{};
  std::size_t cells_y_{};
  // In the data's coordinates:
  geo::GridPoint reach_;       // of an edge, from where it begins
  geo::GridPoint off_line_;    // how far an edge may lie beside a straight line
  geo::GridPoint narrowest_;   // cell
  std::vector<Cover> covers_;  // [y][x]
  std::size_t slices_met_{1};
  std::size_t tiles_x_{};
  std::size_t tiles_y_{};
  std::vector<std::vector<Box>> tiles_;  // [first slice][y][x]; empty before they are needed
};

}  // namespace floeplan::planning::currents
