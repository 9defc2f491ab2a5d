#include "server/manual/help_format.hpp"

#include <algorithm>
#include <memory>
#include <sstream>

#include "server/manual/command_help.hpp"
#include "server/manual/command_list.hpp"
#include "server/manual/plain_text.hpp"

namespace floeplan::manual {
namespace {

constexpr std::size_t line_width = 100;

class HelpFormat : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    if (mode == CLI::AppFormatMode::Sub) return make_expanded(app);
    const CommandHelp* help = help_of_command(path_of(*app));
    const bool is_short = mode == CLI::AppFormatMode::Normal && help != nullptr && !help->needed_most.empty();
    std::string text =
        make_description(app) + '\n' + make_usage(app, std::move(name)) + make_positionals(app);
    if (app->get_parent() == nullptr) {
      return text + make_commands(*app) + make_flags(*app) + make_footer(app);
    }
    text += (is_short ? make_needed_most(*app, *help) : make_flags(*app)) + make_subcommands(app, mode);
    return help == nullptr ? text : text + "\nExample:\n  floeplan " + std::string{help->example} + '\n';
  }

  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    const std::string value = is_positional ? "" : value_of(*option);
    const std::string name = make_option_name(option, is_positional) + (value.empty() ? "" : " " + value);
    return row(name, help_of(*option));
  }

  std::string make_subcommand(const CLI::App* command) const override {
    return row(command->get_name(), command->get_description());
  }

 private:
  [[nodiscard]] std::string row(const std::string& name, const std::string& help) const {
    const std::size_t column = get_column_width();
    const std::string start = "  " + name;
    const std::string gap =
        start.size() + 1 < column ? std::string(column - start.size(), ' ') : '\n' + std::string(column, ' ');
    return start + gap + wrapped(help, line_width - column, column) + '\n';
  }

  /// All commands in the order of the table.
  [[nodiscard]] std::string make_commands(const CLI::App& app) const {
    std::string text;
    std::string_view group;
    for (const CommandHelp& help : command_helps()) {
      if (help.group.empty()) continue;
      if (help.group != group) text += '\n' + std::string{help.group} + ":\n";
      group = help.group;
      text += make_subcommand(app.get_subcommand(std::string{help.command}));
    }
    return text;
  }

  /// All flags in their groups.
  [[nodiscard]] std::string make_flags(const CLI::App& app) const {
    std::string text;
    for (const std::string& group : app.get_groups()) {
      const auto flags = app.get_options(
          [&group](const CLI::Option* one) { return one->nonpositional() && one->get_group() == group; });
      if (!group.empty() && !flags.empty()) text += make_group(group, false, flags);
    }
    return text;
  }

  /// The important flags, and the number of the others.
  [[nodiscard]] std::string make_needed_most(const CLI::App& app, const CommandHelp& help) const {
    std::string text = "\nNeeded most:\n";
    for (const std::string_view flag : help.needed_most)
      text += make_option(app.get_option(std::string{flag}), false);
    std::vector<std::pair<std::string, int>> others;
    for (const CLI::Option* option :
         app.get_options([](const CLI::Option* one) { return one->nonpositional(); })) {
      const std::string group = option->get_group();
      if (group.empty() || std::ranges::find(help.needed_most, option->get_name()) != help.needed_most.end())
        continue;
      const auto known = std::ranges::find(others, group, &std::pair<std::string, int>::first);
      if (known == others.end()) {
        others.emplace_back(group, 1);
      } else {
        ++known->second;
      }
    }
    std::string list;
    for (const auto& [group, count] : others)
      list += (list.empty() ? "" : ", ") + group + ' ' + std::to_string(count);
    return text + '\n' + wrapped("More with --help-all: " + list + '.', line_width) + '\n';
  }
};

}  // namespace

void prepare_help(CLI::App& app) {
  const auto format = std::make_shared<HelpFormat>();
  format->label("SUBCOMMAND", "COMMAND");
  app.formatter(format);
  app.set_help_flag("-h,--help", "Show this help");
  app.set_help_all_flag("--help-all", "Show all flags");
  app.footer("\nfloeplan COMMAND --help explains a command, floeplan help TOPIC a subject.");
}

void group_commands(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    const CommandHelp* help = help_of_command(path_of(*command));
    command->group(help == nullptr ? "" : std::string{help->group});
  }
}

}  // namespace floeplan::manual
