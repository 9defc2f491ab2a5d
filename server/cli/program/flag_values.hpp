#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/messages/command_messages.hpp"

namespace floeplan::cli {

/// An exception for wrong usage of a flag, with a message of the catalogue.
template <messages::Code code, class... Given>
[[nodiscard]] CLI::ValidationError flag_fault(const std::string& flag, const Given&... values) {
  return CLI::ValidationError{flag, messages::command_text<code>(values...)};
}

/// Parses "LON,LAT" in decimal degrees. Does not check that the position is on the Earth.
[[nodiscard]] std::optional<geo::LonLat> parse_place(const std::string& text);

/// Parses numbers separated by commas: "1000" or "1000,500". Empty unless all are finite numbers.
[[nodiscard]] std::optional<std::vector<double>> parse_numbers(const std::string& text);

/// The parts of a text, separated by commas.
[[nodiscard]] std::vector<std::string> split_at_commas(const std::string& text);

/// Lets a flag in seconds also accept an ISO 8601 duration, as PT1H.
[[nodiscard]] CLI::Validator seconds_or_duration();

/// Refuses an empty text for a number in any flag of the program and its commands. The parser would treat it
/// like a missing flag.
void refuse_empty_numbers(CLI::App& app);

}  // namespace floeplan::cli
