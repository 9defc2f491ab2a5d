#include "server/cli/run.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <map>
#include <string>

#include "engine/motion/edge_fan.hpp"
#include "server/cli/program/command.hpp"
#include "server/cli/program/flag_values.hpp"
#include "server/cli/serving/serve.hpp"
#include "server/manual/help_format.hpp"
#include "server/manual/manual_commands.hpp"
#include "server/manual/usage_fault.hpp"
#include "storage/sql/store_address.hpp"

namespace floeplan::cli {
namespace {

/// The sets of instructions that this processor supports, by name.
std::map<std::string, motion::FanPath> instruction_sets() {
  std::map<std::string, motion::FanPath> sets;
  for (const motion::FanPath path : motion::fan_paths()) {
    switch (path) {
      case motion::FanPath::reference: sets["reference"] = path; break;
      case motion::FanPath::baseline: sets["baseline"] = path; break;
      case motion::FanPath::avx2: sets["avx2"] = path; break;
      case motion::FanPath::avx512: sets["avx512"] = path; break;
    }
  }
  return sets;
}

/// Adds the hidden flag --instructions, which chooses the processor instructions for searches. Plans do not
/// depend on them; the flag serves to test this.
void add_instructions(CLI::App& app) {
  const std::map<std::string, motion::FanPath> sets = instruction_sets();
  app.add_option_function<std::string>(
         "--instructions", [sets](const std::string& name) { motion::limit_fan_paths(sets.at(name)); })
      ->check(CLI::IsMember(sets))
      ->group("");
}

void add_commands(CLI::App& app, Program& program) {
  add_serve(app, program);
  add_worker(app, program);
  add_ingest(app, program);
  add_read_files(app, program);
  add_formats(app, program);
  add_datasets(app, program);
  add_probe(app, program);
  add_plan(app, program);
  add_evaluate(app, program);
  add_reach(app, program);
  add_simulate(app, program);
  add_export(app, program);
  add_recheck(app, program);
  add_compare(app, program);
  add_check(app, program);
  add_compare_flight(app, program);
  add_reproduce(app, program);
  add_demo(app, program);
  add_token(app, program);
  add_audit(app, program);
  add_store(app, program);
  add_backup(app, program);
  add_restore(app, program);
  add_verify(app, program);
  add_repair(app, program);
  manual::add_manual_commands(
      app, [&program](const std::string& why) { program.exit_code = complain(wrong_usage, why); });
}

void add_everything(CLI::App& app, Program& program) {
  manual::prepare_help(app);
  app.require_subcommand(1);
  program.store = default_store();
  app.add_option("--data", program.store,
                 "Folder of the store; default: floeplan in $XDG_DATA_HOME, or in ~/.local/share");
  app.add_option_function<std::string>(
      "--store",
      [&program](const std::string& text) {
        const auto address = sql::parse_store_address(text);
        if (!address) throw flag_fault<"no-store-address">("--store", text, sql::store_address_forms);
        if (address->folder) program.store = *address->folder;
        program.server = address->server;
      },
      std::string{"Where the store is: "} + sql::store_address_forms + "; a password belongs into ~/.pgpass");
  app.add_option("--log-level", program.log_level, "Level of a server's log on stderr")
      ->check(CLI::IsMember({"debug", "info", "warning", "error", "off"}))
      ->capture_default_str();
  add_instructions(app);
  app.set_config("--config", "", "File with options in TOML, a [section] for each command");
  add_commands(app, program);
  manual::group_commands(app);
  refuse_empty_numbers(app);
}

/// Parses the command line of `serve` again, because the file of --config may have changed.
ServeOptions serve_options_of(std::vector<std::string> words) {
  CLI::App app;
  Program program;
  ServeOptions options;
  program.serve = [&options](const ServeOptions& read) {
    options = read;
    return 0;
  };
  add_everything(app, program);
  std::reverse(words.begin(), words.end());  // CLI11 expects the arguments in reverse order
  try {
    app.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    throw std::runtime_error{error.what()};
  }
  return options;
}

}  // namespace

int run(int argc, char** argv, const std::string& version) {
  CLI::App app{"Mission planning for underwater gliders in and under ice", "floeplan"};
  app.set_version_flag("--version", version);
  Program program;
  program.serve = serve;
  program.reread_serve = [words = std::vector<std::string>{argv + 1, argv + argc}] {
    return serve_options_of(words);
  };
  add_everything(app, program);

  try {
    app.parse(argc, argv);
    return program.exit_code;
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::CallForAllHelp& help) {
    return app.exit(help);
  } catch (const CLI::CallForVersion& call) {
    return app.exit(call);
  } catch (const CLI::ParseError& error) {
    return complain(wrong_usage, manual::usage_fault(app, error));
  } catch (const BadDataError& error) {
    return complain(bad_data, error.what());
  } catch (const std::exception& error) {
    return complain(could_not, error.what());
  }
}

}  // namespace floeplan::cli
