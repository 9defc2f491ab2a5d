#pragma once

#include <array>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <tuple>
#include <variant>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/messages/message.hpp"

namespace floeplan::planning {

/// Why a valid request has no plan.
enum class Reason {
  start_on_land,
  start_too_shallow,
  start_near_iceberg,
  start_in_zone,
  goal_on_land,
  goal_too_shallow,
  goal_near_iceberg,
  goal_in_zone,
  outside_data,        // the vehicle would leave the area or the period that the data cover
  current_too_strong,  // no heading holds the course
  too_shallow,         // a given route crosses land or shallow water
  near_iceberg,        // a given route passes an iceberg too closely
  in_zone,             // a given route breaks the rule of a zone
  under_ice,           // no room to pass below the ice
  no_surfacing,        // the vehicle would be too long without a place where it may surface
  no_escape,           // from some waypoint no route leads to a place to surface
  goal_unreachable,    // no route is open
  arrival_too_early,   // even the earliest departure arrives after the wanted time
  energy_exceeded,     // the battery does not last
  too_large,           // the grid would exceed the memory limit
  cancelled
};

[[nodiscard]] std::string reason_name(Reason reason);

/// The kind of constraint that closes the route. It does not depend on the objective of the request.
enum class Constraint {
  current,
  depth,
  land,
  ice,
  iceberg,
  zone,
  data_area,
  data_period,
  battery,
  memory,
  caller
};

[[nodiscard]] std::string constraint_name(Constraint constraint);

/// Another value for one input of the request; all other inputs stay. `input` is the name in the API.
struct Change {
  using Nothing = std::monostate;
  using Value =
      std::variant<double, bool, core::UtcTime, geo::LonLat, std::string, std::array<double, 2>, Nothing>;
  std::string input;
  Value from;
  Value to;
  std::string
      text;  // for a person, with all of `with`: "raise the speed through the water from 0.35 to 0.42 m/s"
  std::vector<Change> with{};  // further changes that are needed, because this one alone does not help

  /// For core::packed.
  friend auto members_of(Change& change) {
    auto& [input, from, to, text, with] = change;
    return std::tie(input, from, to, text, with);
  }
};

struct Infeasible {
  Reason reason{};
  geo::LonLat at{};                          // where the search or the vehicle stopped
  core::UtcTime when{};                      // when the vehicle would have been there
  messages::Message why{};                   // what closes the route, and what would help
  std::vector<messages::Message> besides{};  // further findings, in the order in which they were made
  Constraint binding{};
  bool at_a_stop{false};          // the start, the goal or a via point itself cannot be used
  std::vector<Change> changes{};  // each alone makes a plan possible; the smallest first
  /// Moves of an unusable stop to places where the vehicle may be. They are not tried yet; the most promising
  /// come first.
  std::vector<Change> moves{};
  /// The search reached its memory limit, so a route may exist nevertheless.
  bool search_cut_short{false};
  /// The work reserved for finding changes was used up: smaller or other changes may help, too.
  bool changes_cut_short{false};
  /// The time until the closure that binds ends, if that is known.
  std::optional<core::Seconds> postponed{};

  /// For a person: what closes the route, and further findings, one sentence each.
  [[nodiscard]] std::string explanation() const;
  /// For a person: what would help, one sentence. Taken from the last of `besides` that has a hint.
  [[nodiscard]] std::string suggestion() const;

  /// For core::packed.
  friend auto members_of(Infeasible& it) {
    auto& [reason, at, when, why, besides, binding, at_a_stop, changes, moves, cut_short, changes_cut_short,
           postponed] = it;
    return std::tie(reason, at, when, why, besides, binding, at_a_stop, changes, moves, cut_short,
                    changes_cut_short, postponed);
  }
};

template <class T>
using Result = tl::expected<T, Infeasible>;

}  // namespace floeplan::planning
