#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/core/units.hpp"

namespace floeplan::avoidance {

/// Which part of the system steers. Every mode except `mission` overrides the autopilot's waypoint list.
enum class Mode : std::uint8_t {
  mission,   // the autopilot follows its mission plan
  path,      // the vehicle follows an evasive path back to the planned route
  reactive,  // steers around near objects, course by course
  given_up   // found no way for too long: only keeps clear of near objects
};

/// Reason for the present guidance.
enum class Reason : std::uint8_t {
  route_clear,         // no detected object comes near the planned route
  own_state_unusable,  // own state invalid, or its time goes back: the last guidance stays
  at_surface,          // the vehicle cannot steer
  evading,             // the planned route comes too near to a detected object
  too_close,           // an object is, or will very soon be, too close for the followed route
  no_path,             // evasion is needed, but path planning found no path within its budget
  path_not_ready,      // evasion is needed, and no path has been planned yet
  goal_occupied,       // an object covers the last waypoint; keeps clear until it is free
  boxed_in,            // every heading leads to contact: the one with the latest contact is steered
  current_too_strong,  // no nearer to the goal for too long, in a current that is too strong
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

/// Orders to the autopilot until the next step.
struct Guidance {
  Mode mode{Mode::mission};
  Reason reason{Reason::route_clear};
  std::optional<core::Radians>
      heading{};           // where to point the nose, clockwise from true north; empty: steer for
                           // `waypoint` as the mission asks
  std::size_t waypoint{};  // of the mission's list, the one under way; rises past those that evasion
                           // left behind
  std::optional<core::Metres> shallowest{};  // turn at this depth at the latest when climbing
  std::optional<core::Metres> deepest{};     // turn at this depth at the latest when diving
  bool thruster{};                           // use the thruster, if the vehicle has one

  friend bool operator==(const Guidance&, const Guidance&) = default;
};

}  // namespace floeplan::avoidance
