#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::mission {

/// A b_arg to be written.
struct ArgumentValue {
  std::string_view name;
  std::string value;  // a number
};

/// A whole number as a file has it.
[[nodiscard]] std::string whole(double value);
/// A number with this many decimals; zero never has a sign.
[[nodiscard]] std::string decimal(double value, int decimals);

/// The lines `\tb_arg: name(unit) value`, each with the unit of the firmware's dictionary.
/// Errors   std::logic_error for an argument that the dictionary does not know: only known ones are written
[[nodiscard]] std::string argument_lines(std::string_view behavior, const std::vector<ArgumentValue>& values);

/// An argument file: its behavior, comment lines, arguments.
[[nodiscard]] std::string argument_file(std::string_view behavior, const std::string& comments,
                                        const std::vector<ArgumentValue>& values);

/// The section of a list's rows.
[[nodiscard]] std::string waypoint_section(const std::vector<geo::LonLat>& places);

/// "goto_l10.ma" for goto_list and 10.
[[nodiscard]] std::string argument_file_name(std::string_view behavior, int number);

}  // namespace floeplan::mission
