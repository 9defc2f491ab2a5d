#pragma once

#include <string>
#include <tl/expected.hpp>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"

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
  goal_unreachable,    // every way is closed
  too_large,           // the grid would not fit into bounded memory
  cancelled
};

[[nodiscard]] std::string reason_name(Reason reason);

struct Infeasible {
  Reason reason{};
  geo::LonLat at;           // where the search or the vehicle stopped
  core::UtcTime when;       // and at what time it would have been there
  std::string explanation;  // for a person, one sentence
  std::string suggestion;   // what would help, one sentence
};

template <class T>
using Result = tl::expected<T, Infeasible>;

}  // namespace floeplan::planning
