#include "engine/mission/writing/argument_lines.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "engine/mission/document/behavior_table.hpp"
#include "engine/mission/document/packed_degrees.hpp"

namespace floeplan::mission {

std::string whole(double value) { return decimal(value, 0); }

std::string decimal(double value, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  const std::string_view digits = text.data();
  const bool zero = digits.find_first_of("123456789") == std::string_view::npos;
  return std::string{zero && digits.starts_with('-') ? digits.substr(1) : digits};
}

std::string argument_lines(std::string_view behavior, const std::vector<ArgumentValue>& values) {
  const BehaviorRule* rule = find_behavior(behavior);
  std::string text;
  for (const ArgumentValue& each : values) {
    const ArgumentRule* known = rule == nullptr ? nullptr : rule->find(each.name);
    if (known == nullptr)
      throw std::logic_error{std::string{behavior} + " has no argument " + std::string{each.name}};
    text += "\tb_arg: " + std::string{each.name} + "(" + std::string{known->unit} + ") " + each.value + "\n";
  }
  return text;
}

std::string argument_file(std::string_view behavior, const std::string& comments,
                          const std::vector<ArgumentValue>& values) {
  return "behavior_name=" + std::string{behavior} + "\n" + comments + "\n<start:b_arg>\n" +
         argument_lines(behavior, values) + "<end:b_arg>\n";
}

std::string waypoint_section(const std::vector<geo::LonLat>& places) {
  std::string text = "<start:waypoints>\n";
  for (const geo::LonLat place : places) {
    text += packed_degrees(geo::wrap_longitude(place.lon_deg)) + "\t" + packed_degrees(place.lat_deg) + "\n";
  }
  return text + "<end:waypoints>\n";
}

std::string argument_file_name(std::string_view behavior, int number) {
  std::array<char, 16> digits{};
  std::snprintf(digits.data(), digits.size(), "%02d", number);
  return std::string{file_prefix(behavior)} + digits.data() + ".ma";
}

}  // namespace floeplan::mission
