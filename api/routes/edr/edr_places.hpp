#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "api/routes/edr/edr_area.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"

namespace floeplan::routes {

/// The nodes that data are known at, and how many of the data's own lie from one of them to the next (1: all are
/// there).
struct EdrNodes {
  const ocean::HorizontalGrid& grid;  // borrowed
  std::size_t apart{1};
};

/// How many places an answer is to have.
struct EdrResolution {
  std::optional<std::size_t> columns;  // as many as that; empty: as the data have
  std::optional<std::size_t> rows;
  double most_places{};  // of an answer, where the data have more
};

/// The places of a query: every x combined with every y.
struct EdrPlaces {
  std::vector<double> x_deg;    // ascending, beyond 180 in a box across the antimeridian
  std::vector<double> y_deg;    // ascending
  std::vector<bool> is_inside;  // [y][x]: in the shape
  bool is_every_node{false};    // no node of the data in the shape is left out
  std::string sampling;         // the same in words

  [[nodiscard]] std::size_t size() const { return x_deg.size() * y_deg.size(); }
};

/// Of data whose grid is one of longitudes and latitudes its own nodes in the shape, or every second, third, ... of
/// them along both axes, where all would be too many; those that are left include the node next to the middle of the
/// shape. Of other data a grid about as fine as theirs, centred in what the shape's box shares with them. Along an
/// axis with a number of places asked for, so many.
/// Outside  nullopt where none of these lies in the shape
[[nodiscard]] std::optional<EdrPlaces> places_in(const EdrArea& area, const EdrNodes& nodes,
                                                 const EdrResolution& resolution);

/// The one place.
[[nodiscard]] EdrPlaces only_place(geo::LonLat place, std::string sampling);

}  // namespace floeplan::routes
