#include "server/manual/command_list.hpp"

namespace floeplan::manual {
namespace {

Argument argument_of(const CLI::Option& option) {
  Argument argument{
      .names = {}, .value = value_of(option), .help = option.get_description(), .group = option.get_group()};
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
  const std::string type = option.get_type_name();
  if (type == "FLOAT") return "NUMBER";
  if (type == "INT" || type == "UINT") return "INTEGER";
  return type;
}

std::string path_of(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  if (parent == nullptr) return "";
  const std::string above = path_of(*parent);
  return above.empty() ? command.get_name() : above + ' ' + command.get_name();
}

}  // namespace floeplan::manual
