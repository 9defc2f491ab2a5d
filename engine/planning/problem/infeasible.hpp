#pragma once

#include <array>
#include <optional>
#include <string>
#include <tl/expected.hpp>
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
  no_escape,           // from somewhere on the route no way leads to where it may surface
  goal_unreachable,    // every way is closed
  arrival_too_early,   // even the earliest departure arrives later than asked for
  energy_exceeded,     // the battery does not last
  too_large,           // the grid would not fit into bounded memory
  cancelled
};

[[nodiscard]] std::string reason_name(Reason reason);

/// What stands in the way, whatever it makes impossible.
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

/// Another value for one input, by its name in the inputs; everything else as it was asked for.
struct Change {
  using Nothing = std::monostate;
  using Value =
      std::variant<double, bool, core::UtcTime, geo::LonLat, std::string, std::array<double, 2>, Nothing>;
  std::string input;
  Value from;
  Value to;
  std::string
      text;  // for a person: "raise the speed through the water from 0.35 to 0.42 m/s"; of all of `with`, too
  std::vector<Change> with{};  // to be made as well, for alone it does not help
};

struct Infeasible {
  Reason reason{};
  geo::LonLat at{};                          // where the search or the vehicle stopped
  core::UtcTime when{};                      // and at what time it would have been there
  messages::Message why{};                   // what stands in the way, and what would help
  std::vector<messages::Message> besides{};  // what more was found out, in that order
  Constraint binding{};
  bool at_a_stop{false};          // the start, a via or the goal itself cannot be used
  std::vector<Change> changes{};  // found to make it possible, any one of them; the smallest first
  /// Moves of a stop that cannot be used to places where the vehicle may be: not tried yet, the likeliest to help
  /// first.
  std::vector<Change> moves{};
  /// The search came to its bound on memory: there may be a way all the same.
  bool search_cut_short{false};
  /// The work set aside for finding them was done before all were tried: smaller ones, or others, may help, too.
  bool changes_cut_short{false};
  /// What stands in the way opens so much later, where that is known.
  std::optional<core::Seconds> postponed{};

  /// For a person: what closes the route, and what else was found, a sentence each.
  [[nodiscard]] std::string explanation() const;
  /// What would help, by the last of `besides` that says so; one sentence.
  [[nodiscard]] std::string suggestion() const;
};

template <class T>
using Result = tl::expected<T, Infeasible>;

}  // namespace floeplan::planning
