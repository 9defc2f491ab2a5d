#include "server/manual/completion.hpp"

#include <stdexcept>

namespace floeplan::manual {
namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// Lines of a shell's `case` that find the command on a command line, from word to word.
std::string steps(std::span<const Command> commands) {
  std::string text;
  for (const Command& command : commands) {
    if (command.commands.empty()) continue;
    const std::string below = command.path.empty() ? "$word" : command.path + " $word";
    text += "      " + quoted(command.path) + ") case $word in " + joined(command.commands, "|") +
            ") command=\"" + below + "\" ;; esac ;;\n";
  }
  return text;
}

std::string for_bash(std::span<const Command> commands) {
  std::string text =
      "# Completion of floeplan for bash, as floeplan completion bash writes it.\n"
      "_floeplan() {\n"
      "  local word command='' words=''\n"
      "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
      "    case $command in\n" +
      steps(commands) +
      "    esac\n"
      "  done\n"
      "  case $command in\n";
  for (const Command& command : commands) {
    std::vector<std::string> words = command.commands;
    for (const Argument& flag : command.flags)
      words.insert(words.end(), flag.names.begin(), flag.names.end());
    text += "    " + quoted(command.path) + ") words=" + quoted(joined(words, " ")) + " ;;\n";
  }
  return text +
         "  esac\n"
         "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"${COMP_WORDS[COMP_CWORD]}\")\n"
         "}\n"
         "complete -o default -F _floeplan floeplan\n";
}

/// "name:help", the notation of zsh.
std::string described(const std::string& name, const std::string& help) {
  return quoted(replaced(name, ":", "\\:") + ":" + help);
}

const Command* find(std::span<const Command> commands, const std::string& path) {
  for (const Command& command : commands)
    if (command.path == path) return &command;
  return nullptr;
}

std::string path_below(const Command& command, const std::string& name) {
  return command.path.empty() ? name : command.path + ' ' + name;
}

std::string for_zsh(std::span<const Command> commands) {
  std::string text =
      "#compdef floeplan\n"
      "# Completion of floeplan for zsh, as floeplan completion zsh writes it.\n"
      "_floeplan() {\n"
      "  local word command=''\n"
      "  local -a commands flags\n"
      "  for word in \"${(@)words[2,CURRENT-1]}\"; do\n"
      "    case $command in\n" +
      steps(commands) +
      "    esac\n"
      "  done\n"
      "  case $command in\n";
  for (const Command& command : commands) {
    text += "    " + quoted(command.path) + ") commands=(";
    for (const std::string& name : command.commands)
      text += ' ' + described(name, find(commands, path_below(command, name))->description);
    text += " ) flags=(";
    for (const Argument& flag : command.flags)
      for (const std::string& name : flag.names) text += ' ' + described(name, flag.help);
    text += " ) ;;\n";
  }
  return text +
         "  esac\n"
         "  _describe command commands\n"
         "  _describe -o flag flags\n"  // zsh offers options only after a "-"
         "  (( $#commands )) || _files\n"
         "}\n"
         "# From a folder of $fpath zsh runs this file as the function; eval or source only declares it.\n"
         "if [[ $funcstack[1] == _floeplan ]]; then _floeplan \"$@\"; else compdef _floeplan floeplan; fi\n";
}

/// The condition that the command line contains this command.
std::string fish_condition(const Command& command) {
  if (command.path.empty()) return "__fish_use_subcommand";
  return "__fish_seen_subcommand_from " + command.path.substr(command.path.rfind(' ') + 1);
}

std::string for_fish(std::span<const Command> commands) {
  std::string text = "# Completion of floeplan for fish, as floeplan completion fish writes it.\n";
  for (const Command& command : commands) {
    const std::string start = "complete -c floeplan -n " + quoted(fish_condition(command));
    for (const std::string& name : command.commands)
      text += start + " -a " + name + " -d " +
              quoted(find(commands, path_below(command, name))->description) + '\n';
    for (const Argument& flag : command.flags) {
      text += start;
      for (const std::string& name : flag.names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      text += (flag.value.empty() ? "" : " -r") + std::string{" -d "} + quoted(flag.help) + '\n';
    }
  }
  return text;
}

}  // namespace

std::string quoted(const std::string& text) {
  std::string safe;
  for (const char c : text) safe += c == '\'' ? std::string{"'\\''"} : std::string(1, c);
  return "'" + safe + "'";
}

std::vector<std::string> shells() { return {"bash", "zsh", "fish"}; }

std::string completion(std::string_view shell, std::span<const Command> commands) {
  if (shell == "bash") return for_bash(commands);
  if (shell == "zsh") return for_zsh(commands);
  if (shell == "fish") return for_fish(commands);
  throw std::invalid_argument{"no completion for this shell"};
}

}  // namespace floeplan::manual
