#include <cstdio>
#include <iostream>
#include <memory>

#include "api/codec/inputs/reach_inputs.hpp"
#include "api/fields/process_fields.hpp"
#include "api/service/reach_service.hpp"
#include "server/cli/output/plan_output.hpp"
#include "server/cli/output/violation_output.hpp"
#include "server/cli/program/command.hpp"
#include "server/cli/program/input_flags.hpp"
#include "storage/json/json.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;

void print_reach_table(const json& document) {
  std::printf("%8s  %-22s %12s %9s\n", "hours",
              document.at("direction") == "from" ? "there at" : "leaving at", "area km2", "polygons");
  for (const json& feature : document.at("features")) {
    const json& properties = feature.at("properties");
    std::printf("%8.2f  %-22s %12.1f %9zu\n", properties.at("hours").get<double>(),
                properties.at("time").get<std::string>().c_str(), properties.at("area_km2").get<double>(),
                feature.at("geometry").at("coordinates").size());
  }
  std::printf("--json gives the polygons as GeoJSON\n");
  print_messages(document);
}

int run_reach(const InputFlags& flags, bool json_out, const Program& program) {
  const auto inputs = codec::parse_reach_inputs(flags.inputs());
  if (!inputs) return print_violations(inputs.error(), json_out, flags_of(fields::Process::reach));

  auto db = open_existing_store(program);
  const auto document = service::reach_document(db, *inputs, {}, terminal_progress());
  if (!document) return print_violations(document.error(), json_out, flags_of(fields::Process::reach));
  if (document->at("status") != "ok")
    return print_plan(*document, json_out ? PlanOutput::json : PlanOutput::summary);
  if (json_out) {
    std::cout << document->dump() << '\n';
  } else {
    print_reach_table(*document);
  }
  return done;
}

}  // namespace

void add_reach(CLI::App& app, Program& program) {
  auto flags = std::make_shared<InputFlags>();
  auto json_out = std::make_shared<bool>(false);
  auto* command = app.add_subcommand(
      "reach", "Show what the vehicle can reach, or from where it can still come, in time");
  flags->add_request(*command, "the inputs of process reach");
  flags->add(*command, fields::fields_of(fields::Process::reach));
  command->add_flag("--json", *json_out, "Answer with one GeoJSON document");
  command->callback(
      [flags, json_out, &program] { program.exit_code = run_reach(*flags, *json_out, program); });
}

}  // namespace floeplan::cli
