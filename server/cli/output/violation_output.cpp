#include "server/cli/output/violation_output.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <regex>

#include "api/codec/bytes/document_values.hpp"
#include "engine/core/violation_list.hpp"
#include "server/cli/program/command.hpp"
#include "storage/json/json.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// The flag for a JSON pointer, with its remaining part: "/via/2" becomes "--via 3", "/objective/energy"
/// "--objective (energy)".
std::string with_flag(const std::string& pointer, const std::vector<InputFlag>& flags) {
  for (const InputFlag& known : flags) {
    if (!pointer.starts_with(known.pointer)) continue;
    const std::string rest = pointer.substr(known.pointer.size());
    if (rest.empty()) return known.flag;
    if (rest.front() != '/') continue;
    const std::string below = rest.substr(1);
    const bool counts = !below.empty() && below.size() < 9 &&
                        std::ranges::all_of(below, [](char c) { return c >= '0' && c <= '9'; });
    return known.flag + ' ' + (counts ? std::to_string(std::stoul(below) + 1) : '(' + below + ')');
  }
  return pointer;
}

/// Whether the rule begins with a verb, so that it completes a sentence that begins with the flag.
bool is_predicate(const std::string& rule) {
  constexpr std::array verbs{"is",    "must", "has",     "needs", "takes",
                             "holds", "lies", "belongs", "does",  "cannot"};
  const std::string first = rule.substr(0, rule.find(' '));
  return std::ranges::any_of(verbs, [&](const char* verb) { return first == verb; });
}

}  // namespace

std::vector<InputFlag> flags_of(fields::Process process) {
  std::vector<InputFlag> flags;
  for (const fields::Field& field : fields::fields_of(process))
    if (!field.flag.empty()) flags.push_back({fields::pointer_of(field), "--" + std::string{field.flag}});
  flags.push_back({"/uncertainty/quantile", "--robust"});  // a number given instead of "mean"
  return flags;
}

std::string in_words_of_flags(const core::Violation& violation, const std::vector<InputFlag>& flags) {
  if (flags.empty()) return (violation.field.empty() ? "" : violation.field + ": ") + violation.rule;
  // The user's text is at the end of the rule and may itself be a quoted word; it is not changed.
  const std::size_t given = std::min(violation.rule.find(", not \""), violation.rule.size());
  std::string rule = violation.rule.substr(0, given);
  for (const InputFlag& known : flags) {
    const std::string member = known.pointer.substr(known.pointer.rfind('/') + 1);
    replace_all(rule, '"' + member + '"', known.flag);
  }
  replace_all(rule, "[longitude, latitude]", "LON,LAT");
  static const std::regex array{R"(\[([^\[\],]+), ([^\[\],]+)(?:, ([^\[\],]+))?\])"};
  for (std::smatch found; std::regex_search(rule, found, array);) {
    const std::string third = found[3].matched ? ',' + found[3].str() : "";
    rule = found.prefix().str() + found[1].str() + ',' + found[2].str() + third + found.suffix().str();
  }
  rule += violation.rule.substr(given);
  const std::string flag = with_flag(violation.field, flags);
  if (flag.empty()) return rule;
  return flag + (is_predicate(rule) ? " " : ": ") + rule;
}

int print_violations(const core::Violations& violations, bool json_out, const std::vector<InputFlag>& flags) {
  if (json_out)
    std::cout << json{{"status", "invalid"}, {"errors", codec::errors_json(violations)}}.dump(2) << '\n';
  for (const core::Violation& violation : core::shortened(violations))
    complain(bad_data, in_words_of_flags(violation, flags));
  return bad_data;
}

}  // namespace floeplan::cli
