#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <string>

#include "engine/core/version.hpp"
#include "server/cli/command.hpp"
#include "server/cli/flag_values.hpp"
#include "server/cli/operator_commands.hpp"
#include "server/cli/plan_commands.hpp"
#include "server/commit.hpp"

namespace {

/// "floeplan 0.2.0 (62e0624)": what a report of a fault has to name.
std::string version_line() {
  const std::string commit = floeplan::server::commit();
  return std::string{floeplan::core::program_version()} + (commit.empty() ? "" : " (" + commit + ")");
}

}  // namespace

// NOLINTNEXTLINE(bugprone-exception-escape): with no memory even to build the commands there is nothing to say it with
int main(int argc, char** argv) {
  using namespace floeplan;
  std::signal(SIGXFSZ,
              SIG_IGN);  // a file that may not grow is a full disk, which is said; by default it is a crash

  CLI::App app{"Mission planning for underwater gliders in and under ice", "floeplan"};
  app.set_version_flag("--version", version_line());
  app.require_subcommand(1);

  cli::Program program;
  program.store = cli::default_store();
  app.add_option("--data", program.store, "Folder of the store")->capture_default_str();
  app.add_option("--log-level", program.log_level, "Of a server's log on stderr")
      ->check(CLI::IsMember({"debug", "info", "warning", "error", "off"}))
      ->capture_default_str();
  app.set_config("--config", "", "File with options in TOML, a [section] for each command");
  cli::add_serve(app, program);
  cli::add_ingest(app, program);
  cli::add_read_files(app, program);
  cli::add_datasets(app, program);
  cli::add_probe(app, program);
  cli::add_plan(app, program);
  cli::add_evaluate(app, program);
  cli::add_reach(app, program);
  cli::add_simulate(app, program);
  cli::add_export(app, program);
  cli::add_recheck(app, program);
  cli::add_compare(app, program);
  cli::add_check(app, program);
  cli::add_compare_flight(app, program);
  cli::add_reproduce(app, program);
  cli::add_demo(app, program);
  cli::add_token(app, program);
  cli::add_audit(app, program);
  cli::add_backup(app, program);
  cli::add_restore(app, program);
  cli::refuse_empty_numbers(app);

  try {
    app.parse(argc, argv);
    return program.exit_code;
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::CallForVersion& version) {
    return app.exit(version);
  } catch (const CLI::ParseError& error) {
    return cli::complain(cli::wrong_usage,
                         std::string{error.what()} + "; floeplan --help lists commands and flags");
  } catch (const cli::BadDataError& error) {
    return cli::complain(cli::bad_data, error.what());
  } catch (const std::exception& error) {
    return cli::complain(cli::could_not, error.what());
  }
}
