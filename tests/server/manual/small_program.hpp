#pragma once

#include <CLI/CLI.hpp>

#include "server/manual/help_format.hpp"

namespace floeplan::support {

/// A parser with some commands of the program: plan, also with flags that are rarely needed, and datasets
/// with its subcommand prune.
class SmallProgram {
 public:
  SmallProgram() {
    manual::prepare_help(app);
    auto* plan = app.add_subcommand("plan", "Plan a route");
    for (const char* flag : {"--from", "--to", "--depart", "--arrive-by", "--vehicle", "--objective"})
      plan->add_option(flag, text_, std::string{"The "} + (flag + 2))->option_text("WORD");
    plan->add_option("--margin", number_, "Distance that's kept from ice, metres")->group("Ice");
    plan->add_option("--workers", number_, "Flights at once")
        ->check(CLI::Range(1, 256))
        ->default_str("2")
        ->group("Ice");
    plan->add_option("--positive", text_, "Sign of depths")
        ->check(CLI::IsMember({"up", "down"}))
        ->group("Ice");
    auto* datasets = app.add_subcommand("datasets", "List what is stored");
    datasets->add_subcommand("prune", "Remove old data")->add_flag("--dry-run", flag_, "Say what would go");
    app.add_subcommand("read-files", "For the program itself");
    manual::group_commands(app);
  }

  CLI::App app{"Mission planning", "floeplan"};

 private:
  std::string text_;
  double number_{};
  bool flag_{};
};

}  // namespace floeplan::support
