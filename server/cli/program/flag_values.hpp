#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/messages/command_messages.hpp"

namespace floeplan::cli {

/// Wrong usage of a flag, to be thrown: what the catalogue says of its text.
template <messages::Code code, class... Given>
[[nodiscard]] CLI::ValidationError flag_fault(const std::string& flag, const Given&... values) {
  return CLI::ValidationError{flag, messages::command_text<code>(values...)};
}

/// "LON,LAT" in decimal degrees. Whether the numbers are a place on the Earth is not judged here.
[[nodiscard]] std::optional<geo::LonLat> parse_place(const std::string& text);

/// Numbers between commas: "1000" or "1000,500". Empty unless every part is a finite number.
[[nodiscard]] std::optional<std::vector<double>> parse_numbers(const std::string& text);

/// The parts between commas.
[[nodiscard]] std::vector<std::string> split_at_commas(const std::string& text);

/// Lets a flag of seconds take an ISO 8601 duration, as PT1H, as well.
[[nodiscard]] CLI::Validator seconds_or_duration();

/// Makes an empty text where a flag takes a number wrong usage, in the program and in all of its commands: it would
/// count as if the flag were not there.
void refuse_empty_numbers(CLI::App& app);

}  // namespace floeplan::cli
