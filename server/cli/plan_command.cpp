#include <algorithm>
#include <memory>
#include <thread>

#include "api/codec/inputs/plan_inputs.hpp"
#include "api/fields/process_fields.hpp"
#include "api/service/plan_service.hpp"
#include "api/service/threads.hpp"
#include "server/cli/output/plan_output.hpp"
#include "server/cli/output/violation_output.hpp"
#include "server/cli/program/command.hpp"
#include "server/cli/program/input_flags.hpp"
#include "storage/json/json.hpp"

namespace floeplan::cli {
namespace {

int run_plan(const InputFlags& flags, PlanOutput output, const Program& program) {
  const bool json_out = output == PlanOutput::json;
  const auto inputs = codec::parse_plan_inputs(flags.inputs());
  if (!inputs) return print_violations(inputs.error(), json_out, flags_of(fields::Process::plan_route));

  auto db = open_existing_store(program);
  const service::Threads threads{std::max(1U, std::thread::hardware_concurrency())};
  const auto document = service::plan_route_document(db, *inputs, threads, {}, terminal_progress(), now());
  if (!document) return print_violations(document.error(), json_out, flags_of(fields::Process::plan_route));
  return print_plan(*document, output);
}

}  // namespace

void add_plan(CLI::App& app, Program& program) {
  auto flags = std::make_shared<InputFlags>();
  auto* command = app.add_subcommand("plan", "Plan the fastest route through the stored data");
  flags->add_request(*command, "the inputs of process plan-route");
  flags->add(*command, fields::fields_of(fields::Process::plan_route));
  command->callback([flags, output = add_plan_output(*command), &program] {
    program.exit_code = run_plan(*flags, output(), program);
  });
}

}  // namespace floeplan::cli
