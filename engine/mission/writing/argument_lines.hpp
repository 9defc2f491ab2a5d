#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::mission {

/// A b_arg to write.
struct ArgumentValue {
  std::string_view name;
  std::string value;  // formatted number
};

/// A whole number in the form of the files.
[[nodiscard]] std::string whole(double value);
/// A number with this number of decimals; zero never has a sign.
[[nodiscard]] std::string decimal(double value, int decimals);

/// Lines `\tb_arg: name(unit) value`, each with the unit from the firmware's dictionary.
/// Errors   std::logic_error for an argument that is not in the dictionary
[[nodiscard]] std::string argument_lines(std::string_view behavior, const std::vector<ArgumentValue>& values);

/// Text of an argument file: behavior, comment lines, arguments.
[[nodiscard]] std::string argument_file(std::string_view behavior, const std::string& comments,
                                        const std::vector<ArgumentValue>& values);

/// Section with the rows of a list.
[[nodiscard]] std::string waypoint_section(const std::vector<geo::LonLat>& places);

/// File name such as "goto_l10.ma" for goto_list and 10.
[[nodiscard]] std::string argument_file_name(std::string_view behavior, int number);

}  // namespace floeplan::mission
