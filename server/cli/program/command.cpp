#include "server/cli/program/command.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "engine/core/violation_list.hpp"
#include "storage/repository/store/migrations.hpp"

namespace floeplan::cli {
namespace {

constexpr core::Seconds quiet{1.0};  // shorter work shows no progress

}  // namespace

std::filesystem::path default_store() {
  if (const char* data_home = std::getenv("XDG_DATA_HOME"); data_home != nullptr && *data_home != '\0') {
    return std::filesystem::path{data_home} / "floeplan";
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
    return std::filesystem::path{home} / ".local/share/floeplan";
  }
  return "floeplan-data";
}

sql::Connection open_store(const Program& program) {
  return program.server ? repository::open_store_at_server(*program.server)
                        : repository::open_store(program.store);
}

void refuse_store_at_server(const Program& program) {
  if (program.server) throw std::runtime_error{messages::command_text<"store-at-server">()};
}

sql::Connection open_existing_store(const Program& program) {
  if (!program.server && program.store != default_store() && !std::filesystem::exists(program.store))
    throw std::runtime_error{messages::command_text<"no-store">(program.store.string())};
  return open_store(program);
}

core::UtcTime now() { return std::chrono::time_point_cast<core::Seconds>(std::chrono::system_clock::now()); }

core::Seconds steady_now() { return std::chrono::steady_clock::now().time_since_epoch(); }

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

int complain_of_no_plan(const std::string& id) { return complain<"no-stored-plan">(could_not, id); }

core::ProgressCallback terminal_progress(const SteadyClock& clock) {
  if (isatty(STDERR_FILENO) == 0) return [](std::string_view, double) {};
  struct Line {
    core::Seconds begin;
    int percent{0};  // largest percentage reported
    std::string text{};
    ~Line() {
      if (!text.empty()) std::cerr << "\r\033[K" << std::flush;
    }
  };
  return [clock, line = std::make_shared<Line>(clock())](std::string_view stage, double fraction) {
    line->percent = std::clamp(static_cast<int>(100.0 * fraction), line->percent, 99);
    if (clock() - line->begin < quiet) return;
    // a longer line would wrap and could not be removed
    const std::string_view in_short = stage.substr(0, stage.find(':'));
    std::string text = std::string{in_short} + ' ' + std::to_string(line->percent) + " %";
    if (text == line->text) return;
    line->text = std::move(text);
    std::cerr << "\r\033[K" << line->text << std::flush;
  };
}

}  // namespace floeplan::cli
