#include "server/manual/manual_commands.hpp"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "engine/core/near_word.hpp"
#include "engine/messages/command_messages.hpp"
#include "server/manual/command_list.hpp"
#include "server/manual/completion.hpp"
#include "server/manual/guide_text.hpp"
#include "server/manual/man_page.hpp"
#include "server/manual/plain_text.hpp"

namespace floeplan::manual {
namespace {

/// A width that every terminal has.
constexpr std::size_t page_width = 80;

void list_topics() {
  std::cout << "Pages of the guide (floeplan help TOPIC):\n";
  for (const GuideText& page : guide_texts())
    std::cout << "  " << page.name << std::string(20 - page.name.size(), ' ') << page.title() << '\n';
  std::cout << "\nfloeplan help COMMAND tells all flags of a command; floeplan --help lists the commands.\n";
}

/// The message for an unknown topic; names the topic that was probably meant.
std::string no_topic(const CLI::App& app, const std::string& topic) {
  std::vector<std::string> words;
  for (const GuideText& page : guide_texts()) words.emplace_back(page.name);
  const std::vector<Command> commands = commands_of(app);
  words.insert(words.end(), commands.front().commands.begin(), commands.front().commands.end());
  const std::string meant = core::near_word(topic, words);
  return meant.empty() ? messages::command_text<"unknown-topic">(topic)
                       : messages::command_text<"misspelt-topic">(topic, meant);
}

/// Prints a topic; false if there is none with this name.
bool show_topic(const CLI::App& app, const std::string& topic) {
  for (const GuideText& page : guide_texts()) {
    if (page.name != topic) continue;
    std::cout << plain_text(page.text, page_width);
    return true;
  }
  for (const CLI::App* command :
       app.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); })) {
    if (command->get_name() != topic) continue;
    std::cout << command->help("floeplan", CLI::AppFormatMode::All);
    return true;
  }
  return false;
}

/// Writes man pages and completions below a folder, in the layout of /usr/share.
/// Errors   std::runtime_error when a file cannot be written
void write_manual(const CLI::App& app, const std::filesystem::path& share) {
  const auto write = [&](const std::filesystem::path& name, const std::string& text) {
    std::filesystem::create_directories((share / name).parent_path());
    std::ofstream stream{share / name, std::ios::binary};
    stream << text;
    stream.close();
    if (!stream)
      throw std::runtime_error{messages::command_text<"file-not-written">((share / name).string())};
  };
  const std::vector<Command> commands = commands_of(app);
  for (const Command& command : commands)
    write("man/man1/" + man_name(command) + ".1", man_page(command, commands));
  write("bash-completion/completions/floeplan", completion("bash", commands));
  write("zsh/vendor-completions/_floeplan", completion("zsh", commands));
  write("fish/vendor_completions.d/floeplan.fish", completion("fish", commands));
}

}  // namespace

void add_manual_commands(CLI::App& app, const std::function<void(const std::string&)>& refuse) {
  auto topic = std::make_shared<std::string>();
  auto* help = app.add_subcommand("help", "Show a page of the guide, or list all pages");
  help->add_option("TOPIC", *topic, "A page of the guide, or a command");
  help->callback([topic, refuse, &app] {
    if (topic->empty()) {
      list_topics();
    } else if (!show_topic(app, *topic)) {
      refuse(no_topic(app, *topic));
    }
  });

  auto shell = std::make_shared<std::string>();
  auto* complete =
      app.add_subcommand("completion", "Write the script that completes commands and flags in a shell");
  complete->add_option("SHELL", *shell, "bash, zsh or fish")->required()->check(CLI::IsMember(shells()));
  complete->callback([shell, &app] { std::cout << completion(*shell, commands_of(app)); });

  auto share = std::make_shared<std::filesystem::path>();
  auto* manual = app.add_subcommand("write-manual", "Write the man pages and completions of a package");
  manual->add_option("DIR", *share, "Folder such as /usr/share")->required();
  manual->callback([share, &app] { write_manual(app, *share); });
}

}  // namespace floeplan::manual
