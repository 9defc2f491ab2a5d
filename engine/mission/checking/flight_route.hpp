#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/mission/document/document.hpp"

namespace floeplan::mission {

/// The waypoints of a file in the order in which the vehicle flies them.
struct FlownWaypoints {
  std::vector<WaypointRow> rows;  // in flown order; of a list without end, one round
  bool goes_round{false};         // the list repeats without end
  std::vector<std::string>
      notes;  // for the pilot: what differs from flying each row once, from the first to the last
  core::Violations
      faults;  // why it is unknown which rows are flown; `rows` then holds all rows, as in the file
};

/// The rows that the vehicle flies. A goto list gives the rows of `flown_rows`, a mission the rows of each of
/// its inline lists, other files all their rows.
/// `from`   place of the vehicle. A list that asks for the closest row begins at the row closest to it on the
///          ellipsoid, the first of equals. Empty: such a list begins at its first row
[[nodiscard]] FlownWaypoints flown_waypoints(const Document& document, std::optional<geo::LonLat> from);

/// All flown rows of the documents' lists as one route. Lists are flown in the order of the documents. A list
/// of three rows or more that repeats without end returns once to the row that it began with.
struct FlightRoute {
  struct Stop {
    geo::LonLat place;
    std::size_t document{};
    int line{};
  };
  std::vector<Stop> stops;

  [[nodiscard]] std::vector<geo::LonLat> places() const;
};

/// Whether the document is goto_l98.ma or goto_l99.ma, which the firmware flies to recover the vehicle; no
/// pilot's mission does.
[[nodiscard]] bool is_recovery_list(const Document& document);

/// The route of the documents, without rejected ones, and without recovery lists if there are other lists.
/// `start`: place of the vehicle. If the flown rows of a list are unknown, every row is taken once.
[[nodiscard]] FlightRoute route_of(const std::vector<Document>& documents,
                                   std::optional<geo::LonLat> start = std::nullopt);

}  // namespace floeplan::mission
