#include <iostream>
#include <memory>

#include "api/service/plan_check.hpp"
#include "engine/messages/sentence.hpp"
#include "server/cli/program/command.hpp"
#include "storage/json/json.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;

struct RecheckFlags {
  std::string plan_id;
  bool json_out{false};
};

void print_lines(const json& document, const service::PlanCheck& check) {
  if (!document.at("stale")) std::cout << "No data of the plan have changed.\n";
  for (const json& dataset : document.at("changed_data"))
    std::cout << dataset.at("change").get<std::string>() << "  " << dataset.at("kind").get<std::string>()
              << "  " << dataset.at("name").get<std::string>() << " (" << dataset.at("id").get<std::string>()
              << ")\n";
  for (const messages::Message& message : messages::by_rank(service::all_of(check)))
    std::cout << messages::rank_name(message.rank) << ": " << messages::whole_text(message) << '\n';
}

int run_recheck(const RecheckFlags& flags, const Program& program) {
  auto db = open_existing_store(program);
  const auto record = repository::PlanRepository{db}.find({flags.plan_id});
  if (!record) return complain_of_no_plan(flags.plan_id);
  const service::PlanCheck check = service::check_plan(db, *record);
  const json document = service::plan_check_document(*record, check);
  if (flags.json_out) {
    std::cout << document.dump(2) << '\n';
  } else {
    print_lines(document, check);
  }
  return check.dangers.empty() ? done : could_not;
}

}  // namespace

void add_recheck(CLI::App& app, Program& program) {
  auto flags = std::make_shared<RecheckFlags>();
  auto* command = app.add_subcommand(
      "recheck", "List the data that changed since a plan was made, and check the plan in today's data");
  command->add_option("PLAN", flags->plan_id, "The plan's id")->required();
  command->add_flag("--json", flags->json_out, "Answer with one JSON document");
  command->callback([flags, &program] { program.exit_code = run_recheck(*flags, program); });
}

}  // namespace floeplan::cli
