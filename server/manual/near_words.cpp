#include "server/manual/near_words.hpp"

#include <algorithm>

#include "engine/core/near_word.hpp"
#include "engine/messages/command_messages.hpp"
#include "server/manual/command_list.hpp"

namespace floeplan::manual {
namespace {

/// Names of the subcommands, without hidden ones.
std::vector<std::string> commands_below(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!command->get_group().empty()) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> flag_names(const CLI::App& app) {
  std::vector<std::string> flags;
  for (const CLI::Option* option : app.get_options([](const CLI::Option*) { return true; })) {
    if (option->get_group().empty()) continue;
    for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
  }
  return flags;
}

/// A word as a message names it: in quotes, unless dashes set it off.
std::string named(const std::string& word) { return word.starts_with("-") ? word : '"' + word + '"'; }

/// The message for an unknown word.
/// `who`   subject of the message: "plan has no flag"
/// `list`  the help command that lists the words
std::string unknown(const std::string& who, const std::string& written, const std::vector<std::string>& words,
                    const std::string& list) {
  const std::string meant = core::near_word(written, words);
  return meant.empty() ? messages::command_text<"unknown-word">(who, named(written), list)
                       : messages::command_text<"misspelt-word">(who, named(written), named(meant));
}

}  // namespace

std::optional<std::string> unknown_word(const CLI::App& app) {
  const std::vector<std::string> remaining = app.remaining(true);
  if (remaining.empty()) return std::nullopt;
  const CLI::App& command = last_command(app);
  const std::string path = path_of(command);
  const std::string who = path.empty() ? "there is no" : path + " has no";
  const std::string help = path.empty() ? "" : path + ' ';
  const std::string word = remaining.front().substr(0, remaining.front().find('='));
  if (const auto of_all = flag_names(app);
      &command != &app && std::ranges::find(of_all, word) != of_all.end())
    return messages::command_text<"flag-before-command">(word, path);
  if (word.starts_with("-")) return unknown(who + " flag", word, flag_names(command), help + "--help-all");
  const std::vector<std::string> commands = commands_below(command);
  if (commands.empty()) return std::nullopt;
  return unknown(who + " command", word, commands, help + "--help");
}

}  // namespace floeplan::manual
