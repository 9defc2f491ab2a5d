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

/// The comment line of a list that holds station: "# hold from 2026-11-22T09:10:00Z until 2026-11-22T11:50:00Z".
[[nodiscard]] std::string hold_comment(const HoldTimes& times);

/// What a goto list orders that keeps the vehicle at a place.
struct HoldOrder {
  geo::LonLat place;                              // in the middle of its rows
  geo::Bearing axis{geo::Bearing::degrees(0.0)};  // from the first row to the second
  core::Metres apart{};                           // the rows
  core::Metres radius{};                          // in which one is reached
  int legs{};                                     // -1: without end
  std::optional<HoldTimes> planned{};             // as its comment says
};

/// Rows of a list without such a comment are no further apart, else it is a line that is flown to and fro: twice the
/// usual circle of a hold, and as much again. A judgement.
inline constexpr core::Metres widest_hold{2000.0};

/// "holds station: 5 legs between rows 980 m apart, planned from 2026-11-22T09:10:00Z until 2026-11-22T11:50:00Z"
[[nodiscard]] std::string hold_text(const HoldOrder& hold);

/// The hold that a goto list orders: two rows between which the vehicle goes to and fro, for more legs than there are
/// rows or without end. Empty for every other document.
[[nodiscard]] std::optional<HoldOrder> hold_order(const Document& document);

}  // namespace floeplan::mission
