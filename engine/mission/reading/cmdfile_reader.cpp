#include <algorithm>
#include <array>
#include <cmath>

#include "engine/messages/seaglider_file_messages.hpp"
#include "engine/mission/document/line_words.hpp"
#include "engine/mission/reading/seaglider_lines.hpp"
#include "engine/mission/reading/seaglider_readers.hpp"

namespace floeplan::mission {
namespace {

/// Range of a parameter that a vehicle accepts.
struct ParameterRule {
  std::string_view name;
  double least;
  double most;
  bool whole{false};
  bool advice{false};  // true: values outside are accepted, but not advised
};

/// The parameters that pilots set to fly a route. Source: basestation3 parmdata.py.
constexpr std::array parameters{
    ParameterRule{"D_ABORT", 0, 1100},
    ParameterRule{"D_CALL", 0, 5},
    ParameterRule{"D_FINISH", 0, 6000},
    ParameterRule{"D_FLARE", 0, 50},
    ParameterRule{"D_NO_BLEED", 10, 1100, false, true},
    ParameterRule{"D_OFFGRID", 10, 1100},
    ParameterRule{"D_SAFE", 0, 1100},
    ParameterRule{"D_SURF", 0.5, 10},
    ParameterRule{"D_TGT", 0, 1100},
    ParameterRule{"ESCAPE_HEADING", 0, 360},
    ParameterRule{"FERRY_MAX", 0, 90, false, true},
    ParameterRule{"GLIDE_SLOPE", -90, 90},
    ParameterRule{"HEADING", -1, 360},
    ParameterRule{"ICE_FREEZE_MARGIN", -2, 2},
    ParameterRule{"KALMAN_USE", 0, 2, true},
    ParameterRule{"MAX_BUOY", -600, 600, false, true},
    ParameterRule{"NAV_MODE", 0, 3, true},
    ParameterRule{"N_DIVES", 0, 999999, true},
    ParameterRule{"N_NOCOMM", 0, 10, true},
    ParameterRule{"N_NOSURFACE", -20, 20, true},
    ParameterRule{"SM_CC", 150, 800},
    ParameterRule{"T_ABORT", 720, 44600, true},
    ParameterRule{"T_DIVE", 5, 2880, true},
    ParameterRule{"T_LOITER", 0, 1728000, true},
    ParameterRule{"T_MISSION", 10, 43200, true},
    ParameterRule{"USE_BATHY", -50, 50, true},
    ParameterRule{"USE_ICE", -50, 50, true},
};

bool is_directive(std::string_view line) {
  static constexpr std::array directives{"$GO", "$RESUME", "$QUIT", "$EXIT_TO_MENU"};
  return std::ranges::find(directives, line) != directives.end();
}

void check_range(const Argument& parameter, Document& document) {
  const auto rule = std::ranges::find(parameters, std::string_view{parameter.name}, &ParameterRule::name);
  if (rule == parameters.end())
    return report(document, parameter.line,
                  messages::seaglider_file_message<"unknown_parameter">(parameter.name));
  if (rule->whole && parameter.value != std::floor(parameter.value))
    report(document, parameter.line, messages::seaglider_file_message<"not_whole">(parameter.name));
  if (parameter.value < rule->least || parameter.value > rule->most)
    report(document, parameter.line,
           rule->advice ? messages::seaglider_file_message<"out_of_range/advice">(parameter.name)
                        : messages::seaglider_file_message<"out_of_range/parameter">(parameter.name));
}

void read_parameter(std::string_view word, int line, Document& document) {
  const std::size_t comma = word.find(',');
  const std::string_view name = word.substr(1, comma == std::string_view::npos ? comma : comma - 1);
  if (comma == std::string_view::npos || !is_name(name))
    return report(document, line, messages::seaglider_file_message<"unknown_line/cmdfile">());
  const std::string_view raw = word.substr(comma + 1);
  const auto value = parse_number(raw);
  if (!value)
    return report(document, line, messages::seaglider_file_message<"value_not_a_number/cmdfile">(name));
  Argument parameter{std::string{name}, std::string{name}, "", std::string{raw}, *value, line};
  const auto before = std::ranges::find(document.sensors, parameter.name, &Argument::name);
  if (before != document.sensors.end())
    report(document, line,
           before->value == *value
               ? messages::seaglider_file_message<"parameter_twice/same">(parameter.name, before->line)
               : messages::seaglider_file_message<"parameter_twice">(parameter.name, before->line));
  check_range(parameter, document);
  document.sensors.push_back(std::move(parameter));
}

/// Checks the limits against each other: a dive must be shorter and shallower than the limits at which it is
/// aborted.
void check_limits(Document& document) {
  const auto require_less = [&](const char* less, const char* more) {
    const auto low = std::ranges::find(document.sensors, less, &Argument::name);
    const auto high = std::ranges::find(document.sensors, more, &Argument::name);
    if (low == document.sensors.end() || high == document.sensors.end() || low->value < high->value) return;
    report(document, low->line, messages::seaglider_file_message<"beyond_limit">(less, more));
  };
  require_less("D_TGT", "D_ABORT");
  require_less("T_DIVE", "T_MISSION");
  require_less("T_MISSION", "T_ABORT");
}

}  // namespace

void read_cmdfile(const FileText& text, Document& document) {
  int directive_line = 0;
  for (const SeagliderLine& line : seaglider_lines(text, document)) {
    if (directive_line != 0)
      report(document, line.number, messages::seaglider_file_message<"after_directive">(directive_line));
    if (line.words.size() > 1 || !line.words.front().starts_with('$')) {
      report(document, line.number, messages::seaglider_file_message<"unknown_line/cmdfile">());
    } else if (is_directive(line.words.front())) {
      directive_line = line.number;
    } else {
      read_parameter(line.words.front(), line.number, document);
    }
  }
  if (directive_line == 0) report(document, 0, messages::seaglider_file_message<"no_directive">());
  check_limits(document);
}

}  // namespace floeplan::mission
