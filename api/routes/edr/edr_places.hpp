#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "api/routes/edr/edr_area.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"

namespace floeplan::routes {

/// Nodes at which data can be sampled, and the distance of neighbouring ones, counted in nodes of the dataset
/// (1: none is missing).
struct EdrNodes {
  const ocean::HorizontalGrid& grid;  // borrowed
  std::size_t apart{1};
};

/// The requested number of places of an answer.
struct EdrResolution {
  std::optional<std::size_t> columns;  // number of columns; empty: as in the data
  std::optional<std::size_t> rows;
  double most_places{};  // limit of places, if the data have more
};

/// The places of a query: every x combined with every y.
struct EdrPlaces {
  std::vector<double> x_deg;    // ascending, beyond 180 in a box across the antimeridian
  std::vector<double> y_deg;    // ascending
  std::vector<bool> is_inside;  // [y][x]: whether the place is in the shape
  bool is_every_node{false};    // true: the places are all nodes of the data in the shape
  std::string sampling;         // the choice of places, in words

  [[nodiscard]] std::size_t size() const { return x_deg.size() * y_deg.size(); }
};

/// Chooses the places of an answer. For data on a grid of longitudes and latitudes: the nodes in the shape,
/// or, if these are too many, every second, third, ... along both axes, including the node nearest to the
/// shape's middle. For other data: a grid of about the same spacing, centred in the part of the shape's box
/// that the data cover. Along an axis with a requested number of places, that number.
/// Outside  nullopt if none of the places is in the shape
[[nodiscard]] std::optional<EdrPlaces> places_in(const EdrArea& area, const EdrNodes& nodes,
                                                 const EdrResolution& resolution);

/// The places of a query of a single place.
[[nodiscard]] EdrPlaces only_place(geo::LonLat place, std::string sampling);

}  // namespace floeplan::routes
