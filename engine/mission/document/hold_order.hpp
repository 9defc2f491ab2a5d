#pragma once

#include <optional>
#include <string>

#include "engine/core/units.hpp"
#include "engine/geo/bearing.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/mission/document/document.hpp"
#include "engine/mission/document/flown_rows.hpp"

namespace floeplan::mission {

/// Times of a hold: from the planned arrival at a place to the planned departure from it.
struct HoldTimes {
  core::UtcTime from{};
  core::UtcTime until{};

  friend bool operator==(const HoldTimes&, const HoldTimes&) = default;
};

/// Comment line of a list for a hold: "# hold from 2026-11-22T09:10:00Z until 2026-11-22T11:50:00Z".
[[nodiscard]] std::string hold_comment(const HoldTimes& times);

/// The hold that a goto list of two rows orders.
struct HoldOrder {
  geo::LonLat place;                              // half-way between the two rows
  geo::Bearing axis{geo::Bearing::degrees(0.0)};  // from the first row to the second
  core::Metres apart{};                           // distance of the rows
  core::Metres radius{};                          // within which a row counts as reached
  int legs{};                                     // -1: without end
  std::optional<HoldTimes> planned{};             // from the list's comment
};

/// Largest distance of two rows that count as a hold, if the list has no such comment; further apart they are
/// a line that is flown to and fro. Twice the diameter of the usual hold circle. A judgement.
inline constexpr core::Metres widest_hold{2000.0};

/// Text such as "holds station: 5 legs between rows 980 m apart, planned from 2026-11-22T09:10:00Z until
/// 2026-11-22T11:50:00Z".
[[nodiscard]] std::string hold_text(const HoldOrder& hold);

/// The hold that a goto list orders: the vehicle goes to and fro between two rows, for more than two legs or
/// without end. Empty for every other document.
[[nodiscard]] std::optional<HoldOrder> hold_order(const Document& document);

}  // namespace floeplan::mission
