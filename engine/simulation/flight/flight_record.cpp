#include "engine/simulation/flight/flight_record.hpp"

namespace floeplan::simulation {

std::string_view text(EventKind kind) {
  switch (kind) {
    case EventKind::departure: return "departure";
    case EventKind::dive: return "dive";
    case EventKind::inflection: return "inflection";
    case EventKind::surfacing: return "surfacing";
    case EventKind::fix: return "fix";
    case EventKind::waypoint: return "waypoint";
    case EventKind::guidance: return "guidance";
    case EventKind::contact: return "contact";
    case EventKind::end: return "end";
  }
  return "";
}

std::string_view text(FlightEnd end) {
  switch (end) {
    case FlightEnd::arrived: return "arrived";
    case FlightEnd::collided: return "collided";
    case FlightEnd::grounded: return "grounded";
    case FlightEnd::gave_up: return "gave_up";
    case FlightEnd::time_up: return "time_up";
    case FlightEnd::battery: return "battery";
    case FlightEnd::left_data: return "left_data";
    case FlightEnd::stopped: return "stopped";
  }
  return "";
}

}  // namespace floeplan::simulation
