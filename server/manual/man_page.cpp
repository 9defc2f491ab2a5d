#include "server/manual/man_page.hpp"

#include <algorithm>

#include "server/manual/command_help.hpp"

namespace floeplan::manual {
namespace {

/// Escapes a text for man(7), which interprets backslashes, dashes, and a dot or quote at the beginning of a
/// line.
std::string plain(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '\\') {
      safe += "\\e";
    } else if (c == '-') {
      safe += "\\-";
    } else {
      safe += c;
    }
  }
  return safe.starts_with('.') || safe.starts_with('\'') ? "\\&" + safe : safe;
}

std::string entry(const Argument& argument) {
  std::string names;
  for (const std::string& name : argument.names) names += (names.empty() ? "" : ", ") + name;
  return ".TP\n\\fB" + plain(names) + "\\fR" +
         (argument.value.empty() ? "" : " \\fI" + plain(argument.value) + "\\fR") + '\n' +
         plain(argument.help) + '\n';
}

/// Flags under the headings of the help, in the order in which the headings first appear.
std::string flags_of(const Command& command) {
  std::vector<std::string> groups;
  for (const Argument& flag : command.flags)
    if (std::ranges::find(groups, flag.group) == groups.end()) groups.push_back(flag.group);
  std::string text;
  for (const std::string& group : groups) {
    if (groups.size() > 1) text += ".SS " + plain(group) + '\n';
    for (const Argument& flag : command.flags)
      if (flag.group == group) text += entry(flag);
  }
  return text;
}

std::string called(const Command& command) {
  return command.path.empty() ? "floeplan" : "floeplan " + command.path;
}

/// Names of related pages: the pages of the command's subcommands and, for a command, the page of the program.
std::string see_also(const Command& command, std::span<const Command> all) {
  std::string text;
  for (const Command& other : all) {
    const bool is_below = std::ranges::any_of(command.commands, [&](const std::string& name) {
      return other.path == (command.path.empty() ? name : command.path + ' ' + name);
    });
    if (is_below || (other.path.empty() && !command.path.empty()))
      text += ".BR " + plain(man_name(other)) + " (1)\n";
  }
  return text;
}

}  // namespace

std::string man_name(const Command& command) {
  std::string name = called(command);
  std::ranges::replace(name, ' ', '-');
  return name;
}

std::string man_page(const Command& command, std::span<const Command> all) {
  std::string text = ".TH " + plain(man_name(command)) + " 1\n.SH NAME\n" + plain(man_name(command)) +
                     " \\- " + plain(command.description) + "\n.SH SYNOPSIS\n.B " + plain(called(command)) +
                     "\n[\\fIflags\\fR]";
  if (!command.commands.empty()) text += " \\fIcommand\\fR";
  for (const Argument& argument : command.arguments) text += " \\fI" + plain(argument.names.front()) + "\\fR";
  text += '\n';
  if (!command.arguments.empty()) text += ".SH ARGUMENTS\n";
  for (const Argument& argument : command.arguments) text += entry(argument);
  text += ".SH OPTIONS\n" + flags_of(command);
  if (const CommandHelp* help = help_of_command(command.path))
    text += ".SH EXAMPLE\n.nf\nfloeplan " + plain(std::string{help->example}) + "\n.fi\n";
  const std::string others = see_also(command, all);
  return others.empty() ? text : text + ".SH SEE ALSO\n" + others;
}

}  // namespace floeplan::manual
