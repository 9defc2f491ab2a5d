#include "server/manual/usage_fault.hpp"

#include <regex>
#include <vector>

#include "engine/messages/command_messages.hpp"
#include "server/manual/command_list.hpp"
#include "server/manual/near_words.hpp"

namespace floeplan::manual {
namespace {

/// "a", "a or b", "a, b or c".
std::string alternatives(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

std::vector<std::string> split(const std::string& text) {
  static const std::regex comma{","};
  return {std::sregex_token_iterator{text.begin(), text.end(), comma, -1}, std::sregex_token_iterator{}};
}

/// The number without trailing zeros; the parser writes "0.050000".
std::string plain_number(const std::string& text) {
  static const std::regex zeros{R"(\.?0+$)"};
  return text.find('.') == std::string::npos ? text : std::regex_replace(text, zeros, "");
}

std::string kind_of_number(const CLI::App& command, const std::string& flag) {
  const CLI::Option* option = command.get_option_no_throw(flag);
  return option != nullptr && option->get_type_name().find("INT") != std::string::npos ? "a whole number"
                                                                                       : "a number";
}

/// The parser's message (CLI11 2.1) in this program's words; an unknown message is not changed.
std::string said_plainly(const CLI::App& command, const std::string& said) {
  const std::string path = path_of(command);
  const std::string who = path.empty() ? "floeplan" : path;
  std::smatch found;
  static const std::regex conversion{R"(Could not convert: (\S+) = ([^]*))"};
  if (std::regex_match(said, found, conversion))
    return messages::command_text<"flag-not-a-number">(found[1].str(), kind_of_number(command, found[1]),
                                                       found[2].str());
  static const std::regex range{R"((\S+): Value ([^]*) not in range (\S+) to (\S+))"};
  if (std::regex_match(said, found, range)) {
    return messages::command_text<"flag-out-of-range">(found[1].str(), plain_number(found[3]),
                                                       plain_number(found[4]), found[2].str());
  }
  static const std::regex member{R"((\S+): ([^]*) not in \{(.*)\})"};
  if (std::regex_match(said, found, member))
    return messages::command_text<"flag-of-other-words">(found[1].str(), alternatives(split(found[3])),
                                                         found[2].str());
  if (said == "A subcommand is required") {
    for (const Command& known : commands_of(command))
      if (known.path == path)
        return messages::command_text<"command-missing">(who, alternatives(known.commands));
  }
  static const std::regex required{R"((\S+) is required)"};
  if (std::regex_match(said, found, required))
    return messages::command_text<"argument-missing">(who, found[1].str());
  static const std::regex unexpected{R"(The following arguments? w(?:as|ere) not expected: ([^]*))"};
  if (std::regex_match(said, found, unexpected))
    return messages::command_text<"unexpected-argument">(who, found[1].str());
  static const std::regex missing{R"((\S+): \d+ required (.*) missing)"};
  if (std::regex_match(said, found, missing)) return messages::command_text<"value-missing">(found[1].str());
  static const std::regex excludes{R"((\S+) excludes (\S+))"};
  if (std::regex_match(said, found, excludes))
    return messages::command_text<"flags-exclude-each-other">(found[1].str(), found[2].str());
  return said;
}

}  // namespace

std::string usage_fault(const CLI::App& app, const CLI::ParseError& error) {
  if (auto unknown = unknown_word(app)) return *unknown;
  const CLI::App& command = last_command(app);
  const std::string path = path_of(command);
  return messages::command_text<"wrong-usage">(said_plainly(command, error.what()),
                                               (path.empty() ? "" : path + ' ') + "--help");
}

}  // namespace floeplan::manual
