#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "engine/core/progress.hpp"
#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/messages/command_messages.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::cli {

/// Seconds since any fixed instant. An empty function means that no time passes.
using SteadyClock = std::function<core::Seconds()>;

/// How the program ends; scripts depend on the numbers.
enum ExitCode : int { done = 0, could_not = 1, wrong_usage = 2, bad_data = 3 };

struct ServeOptions;

/// State that all subcommands share. They are registered with the parser and set `exit_code` when they run.
struct Program {
  std::filesystem::path
      store;  // --data, or --store of a folder: holds the store, or what comes on its way to a server's
  std::optional<std::string> server{};  // --store of a database server that keeps the store
  std::string log_level{"info"};        // --log-level, of the lines that a server writes
  int exit_code{done};
  std::function<int(const ServeOptions&)> serve{};  // runs the command serve
  std::function<ServeOptions()> reread_serve{};     // as in ServeOptions
};

/// Thrown for a file of input data that was read but has invalid content; the exit code is then `bad_data`.
class BadDataError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The default of --data: floeplan in the XDG data folder, or else in ~/.local/share.
[[nodiscard]] std::filesystem::path default_store();

/// The store of a command that may create it.
/// Errors   as `repository::open_store` and `repository::open_store_at_server`
[[nodiscard]] sql::Connection open_store(const Program& program);

/// Ends a command that works on a store's files where a database server keeps the store.
/// Errors   std::runtime_error
void refuse_store_at_server(const Program& program);

/// The store of a command that reads stored data.
/// Errors   std::runtime_error if the folder of --data does not exist: a plan from a mistyped path would lead
///          through an empty sea. Otherwise the errors of `open_store`
[[nodiscard]] sql::Connection open_existing_store(const Program& program);

[[nodiscard]] core::UtcTime now();
/// Time of the steady clock, which changes of the system time do not affect.
[[nodiscard]] core::Seconds steady_now();

/// The path of this program's executable, however it was started.
[[nodiscard]] std::filesystem::path own_program();

/// Prints one line on stderr: "floeplan: what; why; what to do". Returns `code`.
int complain(ExitCode code, const std::string& sentence);
/// Prints the message of the catalogue with this code, and returns the exit code.
template <messages::Code message, class... Given>
int complain(ExitCode code, const Given&... values) {
  return complain(code, messages::command_text<message>(values...));
}
/// Prints one line on stderr for each violation. Returns `code`.
int complain(ExitCode code, const core::Violations& violations);

/// Prints that no plan is stored under this id.
int complain_of_no_plan(const std::string& id);

/// Shows stage and percent in one line on stderr. The line appears once the work has taken a second, is written anew as the
/// work goes on, and is wiped at the end. Where stderr is no terminal nothing is written. The percent never falls, and 100
/// is never shown.
/// `clock`  tells the time since any moment
[[nodiscard]] core::ProgressCallback terminal_progress(const SteadyClock& clock = steady_now);

void add_ingest(CLI::App& app, Program& program);
void add_read_files(CLI::App& app, Program& program);
void add_formats(CLI::App& app, Program& program);
void add_datasets(CLI::App& app, Program& program);
void add_probe(CLI::App& app, Program& program);
void add_plan(CLI::App& app, Program& program);
void add_evaluate(CLI::App& app, Program& program);
void add_reach(CLI::App& app, Program& program);
void add_export(CLI::App& app, Program& program);
void add_check(CLI::App& app, Program& program);
void add_compare_flight(CLI::App& app, Program& program);
void add_reproduce(CLI::App& app, Program& program);
void add_demo(CLI::App& app, Program& program);
void add_simulate(CLI::App& app, Program& program);
void add_serve(CLI::App& app, Program& program);
void add_worker(CLI::App& app, Program& program);

// Of stored plans.
void add_recheck(CLI::App& app, Program& program);
void add_compare(CLI::App& app, Program& program);

// For the operator of a server.
void add_token(CLI::App& app, Program& program);
void add_audit(CLI::App& app, Program& program);
void add_store(CLI::App& app, Program& program);
void add_backup(CLI::App& app, Program& program);
void add_restore(CLI::App& app, Program& program);
void add_verify(CLI::App& app, Program& program);
void add_repair(CLI::App& app, Program& program);

}  // namespace floeplan::cli
