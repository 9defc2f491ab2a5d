#include "engine/mission/document/document_rules.hpp"

#include <algorithm>
#include <iterator>

#include "engine/core/letter_case.hpp"
#include "engine/messages/mission_file_messages.hpp"
#include "engine/mission/document/argument_rules.hpp"
#include "engine/mission/document/behavior_table.hpp"
#include "engine/mission/document/line_words.hpp"
#include "engine/mission/document/list_rules.hpp"

namespace floeplan::mission {
namespace {

/// No file has more rows. A larger number, or the number of a mission parameter, is not a count.
constexpr double most_declared = 999'999.0;

/// Warns of a file name that belongs to another behavior's argument file. Other names ("Line 90.ma") pass.
void check_file_name(const Document& document, const Behavior& behavior, Messages& messages) {
  const std::string lower = core::lower_case(document.name);
  const std::string stem = lower.substr(0, lower.rfind('.'));
  const auto last_letter = std::find_if_not(stem.rbegin(), stem.rend(), is_digit);
  const auto letters = static_cast<std::size_t>(std::distance(last_letter, stem.rend()));
  const BehaviorRule* named = find_by_file_prefix(stem.substr(0, letters));
  if (letters == stem.size() || named == nullptr || find_behavior(behavior.name) == nullptr) return;
  if (named->name != behavior.name) {
    messages.push_back(finding(behavior.line, messages::mission_file_message<"file_name_of_another_behavior">(
                                                  document.name, named->name, behavior.name)));
  } else if (stem.size() - letters > 2) {
    messages.push_back(
        finding(0, messages::mission_file_message<"file_number_above_99/name">(document.name)));
  }
}

void check_arguments_file(Document& document) {
  if (document.behaviors.empty()) return;
  const Behavior& behavior = document.behaviors.front();
  check_arguments(behavior, document.messages);
  check_file_name(document, behavior, document.messages);
  if (behavior.name == "goto_list") {
    if (const Argument* count = behavior.find("num_waypoints");
        count != nullptr && count->value >= 0.0 && count->value <= most_declared) {
      document.waypoints_declared = static_cast<int>(count->value);
    }
    check_list(behavior, document.waypoints, document.messages);
  } else if (!document.waypoints.empty()) {
    report(document, document.waypoints.front().line,
           messages::mission_file_message<"waypoints_elsewhere">());
  }
}

void check_mission_rules(Document& document) {
  for (const Behavior& behavior : document.behaviors) {
    check_arguments(behavior, document.messages);
    if (behavior.name == "goto_list") check_inline_list(behavior, document.messages);
    if (behavior.name == "goto_list" || behavior.name == "goto_wpt") {
      std::ranges::copy(inline_waypoints(behavior, document.messages),
                        std::back_inserter(document.waypoints));
    }
  }
  if (std::ranges::find(document.behaviors, "abend", &Behavior::name) == document.behaviors.end()) {
    report(document, 0, messages::mission_file_message<"no_abend">());
  }
}

}  // namespace

void check_document(Document& document) {
  check_duplicates(document.sensors, false, document.messages);
  if (document.kind == DocumentKind::mission) {
    check_mission_rules(document);
  } else {
    check_arguments_file(document);
  }
}

}  // namespace floeplan::mission
