#include "server/cli/program/command.hpp"

#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "engine/core/violation_list.hpp"
#include "storage/repository/store/migrations.hpp"

namespace floeplan::cli {

std::filesystem::path default_store() {
  if (const char* data_home = std::getenv("XDG_DATA_HOME"); data_home != nullptr && *data_home != '\0') {
    return std::filesystem::path{data_home} / "floeplan";
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
    return std::filesystem::path{home} / ".local/share/floeplan";
  }
  return "floeplan-data";
}

sql::Connection open_existing_store(const Program& program) {
  if (program.store != default_store() && !std::filesystem::exists(program.store))
    throw std::runtime_error{
        "there is no store in " + program.store.string() +
        "; name its folder with --data, or read data into it with floeplan ingest FILE..."};
  return repository::open_store(program.store);
}

core::UtcTime now() { return std::chrono::time_point_cast<core::Seconds>(std::chrono::system_clock::now()); }

std::filesystem::path own_program() { return "/proc/self/exe"; }

int complain(ExitCode code, const std::string& sentence) {
  std::cerr << "floeplan: " << sentence << '\n';
  return code;
}

int complain(ExitCode code, const core::Violations& violations) {
  for (const core::Violation& violation : core::shortened(violations))
    complain(code, (violation.field.empty() ? "" : violation.field + ": ") + violation.rule);
  return code;
}

int complain_of_no_plan(const std::string& id) {
  return complain(could_not, "no plan has the id " + id + "; floeplan plan prints the id");
}

core::ProgressCallback terminal_progress() {
  if (isatty(STDERR_FILENO) == 0) return [](std::string_view, double) {};
  struct State {
    std::chrono::steady_clock::time_point begin{std::chrono::steady_clock::now()};
    bool shown{false};
    ~State() {
      if (shown) std::cerr << "\r\033[K";
    }
  };
  return [state = std::make_shared<State>()](std::string_view stage, double fraction) {
    if (std::chrono::steady_clock::now() - state->begin < std::chrono::seconds{1}) return;
    state->shown = true;
    std::cerr << "\r\033[K" << stage << ' ' << static_cast<int>(100.0 * fraction) << " %" << std::flush;
  };
}

}  // namespace floeplan::cli
