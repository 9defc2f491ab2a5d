#include <iostream>
#include <memory>

#include "engine/core/utc_text.hpp"
#include "server/cli/program/command.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/access/audit_repository.hpp"

namespace floeplan::cli {
namespace {

struct AuditFlags {
  int limit{100};
  bool json_out{false};
};

int show(const AuditFlags& flags, const Program& program) {
  auto db = open_existing_store(program);
  const auto entries = repository::AuditRepository{db}.list(0, flags.limit);
  auto documents = nlohmann::json::array();
  for (const auto& entry : entries) {
    if (!flags.json_out) {
      std::cout << core::iso8601(entry.at) << "  " << entry.caller << "  " << entry.peer << "  "
                << entry.action << "  " << entry.target << '\n';
    }
    documents.push_back({{"at", core::iso8601(entry.at)},
                         {"caller", entry.caller},
                         {"peer", entry.peer},
                         {"action", entry.action},
                         {"target", entry.target},
                         {"request_id", entry.request_id}});
  }
  if (flags.json_out) std::cout << nlohmann::json{{"entries", documents}}.dump(2) << '\n';
  return done;
}

}  // namespace

void add_audit(CLI::App& app, Program& program) {
  auto flags = std::make_shared<AuditFlags>();
  auto* command = app.add_subcommand("audit", "List who did what over HTTP, newest first");
  command->add_option("--limit", flags->limit, "Largest number of entries")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  command->add_flag("--json", flags->json_out, "Answer with one JSON document");
  command->callback([flags, &program] { program.exit_code = show(*flags, program); });
}

}  // namespace floeplan::cli
