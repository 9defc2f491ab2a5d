#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/core/units.hpp"

namespace floeplan::avoidance {

/// Who steers. Each mode but `mission` overrides the autopilot's own waypoint list.
enum class Mode : std::uint8_t {
  mission,   // the autopilot follows its mission plan
  path,      // an evasive route leads back to the planned one
  reactive,  // course by course around what is near
  given_up   // no way on was found for too long: keeps clear of what is near, and nothing else
};

/// Why the system guides as it does. Every guidance carries one.
enum class Reason : std::uint8_t {
  route_clear,         // nothing detected comes near the planned route
  own_state_unusable,  // a number of the vehicle's own state is none, or its time goes back: what was said holds
  at_surface,          // nothing can be steered
  evading,             // the planned route comes too near to a detected object
  too_close,           // an object is or will very soon be too close for the route being followed
  no_path,             // evasion is needed, and path planning has found none in its budget
  path_not_ready,      // evasion is needed, and no path has been planned yet
  goal_occupied,       // the last waypoint is covered by an object; keeps clear until it is free
  boxed_in,            // no heading is free of contact: the one with the latest contact
  current_too_strong,  // no nearer to the goal for that long, against a current that the vehicle does not master
  no_progress          // no nearer to the goal for longer than the settings allow
};

[[nodiscard]] constexpr std::string_view text(Mode mode) {
  switch (mode) {
    case Mode::mission: return "mission";
    case Mode::path: return "path";
    case Mode::reactive: return "reactive";
    case Mode::given_up: return "given up";
  }
  return "";
}

[[nodiscard]] constexpr std::string_view text(Reason reason) {
  switch (reason) {
    case Reason::route_clear: return "route clear";
    case Reason::own_state_unusable: return "own state unusable";
    case Reason::at_surface: return "at the surface";
    case Reason::evading: return "evading";
    case Reason::too_close: return "too close";
    case Reason::no_path: return "no path found";
    case Reason::path_not_ready: return "path not ready";
    case Reason::goal_occupied: return "goal occupied";
    case Reason::boxed_in: return "boxed in";
    case Reason::current_too_strong: return "current too strong";
    case Reason::no_progress: return "no progress";
  }
  return "";
}

/// What the autopilot is asked to do until the next step.
struct Guidance {
  Mode mode{Mode::mission};
  Reason reason{Reason::route_clear};
  std::optional<core::Radians>
      heading{};           // where to point the nose, clockwise from true north; empty: steer for
                           // `waypoint` as the mission asks
  std::size_t waypoint{};  // of the mission's list, the one under way; rises past those that evasion
                           // left behind
  std::optional<core::Metres> shallowest{};  // inflect there at the latest when climbing
  std::optional<core::Metres> deepest{};     // inflect there at the latest when diving
  bool thruster{};                           // a vehicle that has one is asked to use it

  friend bool operator==(const Guidance&, const Guidance&) = default;
};

}  // namespace floeplan::avoidance
