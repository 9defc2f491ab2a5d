#pragma once

#include <cstddef>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "engine/mission/document.hpp"

namespace floeplan::mission {

/// Rows of the documents' lists as one route: lists are flown one after the other, in the order of the documents,
/// and a list that goes round for ever returns to its first row once.
struct FlightRoute {
  struct Stop {
    geo::LonLat place;
    std::size_t document{};
    int line{};
  };
  std::vector<Stop> stops;

  [[nodiscard]] std::vector<geo::LonLat> places() const;
};

/// Whether the firmware flies the document's list to recover, and no mission of a pilot does: goto_l98.ma, goto_l99.ma.
[[nodiscard]] bool is_recovery_list(const Document& document);

/// Rejected documents have no part in it, nor have lists to recover by where there are others.
[[nodiscard]] FlightRoute route_of(const std::vector<Document>& documents);

}  // namespace floeplan::mission
