#include "server/manual/command_list.hpp"

#include <algorithm>

namespace floeplan::manual {
namespace {

struct TypeAndCheck {
  std::string type;   // "UINT"
  std::string check;  // "UINT in [1 - 256]", "{up,down}"; empty: none
};

/// Splits the parser's text of type and range: "UINT:UINT in [1 - 256]".
TypeAndCheck type_and_check(const CLI::Option& option) {
  const std::string name = option.get_type_name();
  const auto colon = name.find(':');
  return {name.substr(0, colon), colon == std::string::npos ? "" : name.substr(colon + 1)};
}

Argument argument_of(const CLI::Option& option) {
  Argument argument{
      .names = {}, .value = value_of(option), .help = help_of(option), .group = option.get_group()};
  if (option.get_positional()) {
    argument.names.push_back(option.get_name(true, false));
    return argument;
  }
  for (const std::string& name : option.get_snames()) argument.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) argument.names.push_back("--" + name);
  return argument;
}

void add(std::vector<Command>& all, const CLI::App& app) {
  Command command{.path = path_of(app),
                  .description = app.get_description(),
                  .arguments = {},
                  .flags = {},
                  .commands = {}};
  for (const CLI::Option* option : app.get_options([](const CLI::Option*) { return true; })) {
    if (option->get_group().empty()) continue;
    (option->get_positional() ? command.arguments : command.flags).push_back(argument_of(*option));
  }
  const auto below = app.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); });
  for (const CLI::App* one : below) command.commands.push_back(one->get_name());
  all.push_back(std::move(command));
  for (const CLI::App* one : below) add(all, *one);
}

}  // namespace

std::vector<Command> commands_of(const CLI::App& app) {
  std::vector<Command> all;
  add(all, app);
  return all;
}

std::string value_of(const CLI::Option& option) {
  if (!option.get_option_text().empty()) return option.get_option_text();
  if (option.get_type_size() == 0) return "";
  const auto [type, check] = type_and_check(option);
  if (check.starts_with('{')) {
    std::string words = check.substr(1, check.find('}') - 1);
    std::ranges::replace(words, ',', '|');
    return words;
  }
  if (type == "FLOAT") return "NUMBER";
  if (type == "INT" || type == "UINT") return "INTEGER";
  return type;
}

std::string help_of(const CLI::Option& option) {
  std::string help = option.get_description();
  const auto [type, check] = type_and_check(option);
  if (const auto from = check.find('['), to = check.find(" - "), end = check.find(']');
      from != std::string::npos && to != std::string::npos && end != std::string::npos)
    help += "; " + check.substr(from + 1, to - from - 1) + " to " + check.substr(to + 3, end - to - 3);
  return option.get_default_str().empty() ? help : help + "; default " + option.get_default_str();
}

const CLI::App& last_command(const CLI::App& app) {
  const CLI::App* last = &app;
  while (!last->get_subcommands().empty()) last = last->get_subcommands().back();
  return *last;
}

std::string path_of(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  if (parent == nullptr) return "";
  const std::string above = path_of(*parent);
  return above.empty() ? command.get_name() : above + ' ' + command.get_name();
}

}  // namespace floeplan::manual
