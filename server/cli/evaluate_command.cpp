#include <filesystem>
#include <memory>

#include "api/codec/inputs/plan_inputs.hpp"
#include "api/fields/process_fields.hpp"
#include "api/service/plan_service.hpp"
#include "server/cli/output/plan_output.hpp"
#include "server/cli/output/violation_output.hpp"
#include "server/cli/program/command.hpp"
#include "server/cli/program/input_flags.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/work/plan_repository.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;

int run_evaluate(const std::string& route, const InputFlags& flags, PlanOutput output,
                 const Program& program) {
  const bool json_out = output == PlanOutput::json;
  json inputs = flags.inputs();
  if (std::filesystem::is_regular_file(route)) {
    inputs["route_file"] = file_member(route);
  } else if (route.find('.') != std::string::npos || route.find('/') != std::string::npos) {
    return complain<"file-not-readable">(could_not, "file", route);
  } else {
    inputs["plan_id"] = route;
  }
  const auto parsed = codec::parse_evaluate_inputs(inputs);
  if (!parsed) return print_violations(parsed.error(), json_out, flags_of(fields::Process::evaluate_route));

  auto db = open_existing_store(program);
  if (parsed->plan_id && !repository::PlanRepository{db}.find({*parsed->plan_id}))
    return complain_of_no_plan(*parsed->plan_id);
  const auto document = service::evaluate_route_document(db, *parsed, {});
  if (!document)
    return print_violations(document.error(), json_out, flags_of(fields::Process::evaluate_route));
  return print_plan(*document, output);
}

}  // namespace

void add_evaluate(CLI::App& app, Program& program) {
  auto flags = std::make_shared<InputFlags>();
  auto route = std::make_shared<std::string>();
  auto* command = app.add_subcommand("evaluate", "Time a given route in the stored data");
  command
      ->add_option("ROUTE", *route,
                   "A plan's id or a file with a route: GeoJSON, .ma, .mi, GPX, KML, CSV, NMEA, Seaglider "
                   "targets or an IMC plan")
      ->required();
  flags->add_request(*command, "the inputs of process evaluate-route");
  flags->add(*command, fields::fields_of(fields::Process::evaluate_route));
  command->callback([flags, route, output = add_plan_output(*command), &program] {
    program.exit_code = run_evaluate(*route, *flags, output(), program);
  });
}

}  // namespace floeplan::cli
