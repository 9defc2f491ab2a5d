#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::support {

/// A goto list as the vehicle reads it.
struct ReadList {
  std::map<std::string, double> b_args;  // by name and unit: "num_waypoints(nodim)"
  std::vector<geo::LonLat> waypoints;
};

/// Strict reader of `goto_lNN.ma`, written from the format's grammar, independent of the writer under test.
/// Errors   std::runtime_error that names the line: anything but ASCII, LF, lines below 100 characters, the
///          sections in their order, one number a b_arg, two packed angles a row, minutes below 60
[[nodiscard]] ReadList read_goto_list(const std::string& text);

/// Degrees of one packed angle.
/// Errors   std::runtime_error unless it is [-]D...DMM.mmmm with minutes below 60
[[nodiscard]] double degrees_of_packed(const std::string& text);

}  // namespace floeplan::support
