#include "server/cli/program/flag_values.hpp"

#include <charconv>
#include <cmath>

#include "engine/core/utc_text.hpp"

namespace floeplan::cli {
namespace {

bool takes_number(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type.starts_with("FLOAT") || type.starts_with("INT") || type.starts_with("UINT");
}

std::string refuse_empty(const std::string& text) {
  return text.empty() ? messages::command_text<"empty-number">() : "";
}

}  // namespace

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (;;) {
    const std::size_t comma = text.find(',', begin);
    parts.push_back(text.substr(begin, comma - begin));
    if (comma == std::string::npos) return parts;
    begin = comma + 1;
  }
}

std::optional<std::vector<double>> parse_numbers(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& part : split_at_commas(text)) {
    const char* begin = part.data();
    const char* end = begin + part.size();
    if (begin != end && *begin == '+') ++begin;
    double number = 0.0;
    const auto [stopped, error] = std::from_chars(begin, end, number);
    if (error != std::errc{} || stopped != end || !std::isfinite(number)) return std::nullopt;
    numbers.push_back(number);
  }
  return numbers;
}

std::optional<geo::LonLat> parse_place(const std::string& text) {
  const auto numbers = parse_numbers(text);
  if (!numbers || numbers->size() != 2) return std::nullopt;
  return geo::LonLat{(*numbers)[0], (*numbers)[1]};
}

CLI::Validator seconds_or_duration() {
  const auto to_seconds = [](std::string& text) -> std::string {
    const auto duration = core::parse_iso8601_duration(text);
    if (duration) {
      text = std::to_string(duration->count());
      return "";
    }
    const auto numbers = parse_numbers(text);
    if (numbers && numbers->size() == 1) return "";
    return messages::command_text<"no-seconds-and-no-duration">(text);
  };
  return CLI::Validator{to_seconds, ""};
}

void refuse_empty_numbers(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (takes_number(*option)) option->check(refuse_empty);
  }
  for (CLI::App* command : app.get_subcommands({})) refuse_empty_numbers(*command);
}

}  // namespace floeplan::cli
