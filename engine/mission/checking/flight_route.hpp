#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/mission/document/document.hpp"

namespace floeplan::mission {

/// What the vehicle flies of a file's waypoints.
struct FlownWaypoints {
  std::vector<WaypointRow> rows;  // in the order in which they are flown; of a list without end, one round
  bool goes_round{false};         // the list goes round for ever
  std::vector<std::string>
      notes;  // where that is not each row once, from the first to the last: for the pilot
  core::Violations
      faults;  // why it is not known which rows are flown; they are all there then, as in the file
};

/// The rows of a goto list by `flown_rows`; of a mission those of each list that it gives inline; of other files all.
/// `from`   where the vehicle is, which decides where a list begins that asks for the closest row: on the ellipsoid,
///          the first of equal ones; with none given at its first row
[[nodiscard]] FlownWaypoints flown_waypoints(const Document& document, std::optional<geo::LonLat> from);

/// The flown rows of the documents' lists as one route: lists are flown one after the other, in the order of the
/// documents, and a list of three rows or more that goes round for ever returns once to the row that it began with.
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
/// `start`: where the vehicle is. Where it is not known which rows a list flies, every row is taken once.
[[nodiscard]] FlightRoute route_of(const std::vector<Document>& documents,
                                   std::optional<geo::LonLat> start = std::nullopt);

}  // namespace floeplan::mission
