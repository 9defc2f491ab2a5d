#include <algorithm>

#include "api/routes/processes/process_catalogue.hpp"
#include "api/routes/request/openapi_schema.hpp"
#include "api/routes/request/parameters.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "engine/core/version.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

/// The description of the inputs, taken from the OpenAPI document, so that both are equal.
json inputs_of(const ProcessEntry& process) {
  const json& schema = component_schemas().at(process.inputs_schema);
  const json required = schema.value("required", json::array());
  json inputs = json::object();
  for (const auto& [name, property] : schema.at("properties").items()) {
    json input_schema = self_contained(property);
    const bool is_required = std::find(required.begin(), required.end(), name) != required.end();
    inputs[name] = {{"title", input_schema.value("description", name)},
                    {"minOccurs", is_required ? 1 : 0},
                    {"schema", std::move(input_schema)}};
  }
  return inputs;
}

json outputs_of(const ProcessEntry& process) {
  const json& inputs = component_schemas().at(process.inputs_schema).at("properties");
  json outputs = json::object();
  for (const auto& output : process.outputs) {
    const auto given_back = inputs.find(output.name);
    json schema = given_back == inputs.end() ? json{{"type", "object"}} : self_contained(*given_back);
    outputs[output.name] = {{"title", output.title}, {"schema", std::move(schema)}};
  }
  return outputs;
}

json process_summary(const ProcessEntry& process, const std::string& url) {
  const std::string self = url + "/processes/" + process.id;
  return {{"id", process.id},
          {"title", process.title},
          {"description", process.description},
          {"version", core::version()},
          {"jobControlOptions", json::array({"sync-execute", "async-execute", "dismiss"})},
          {"outputTransmission", json::array({"value"})},
          {"links", json::array({link("self", "application/json", self, "Description of the process"),
                                 link("http://www.opengis.net/def/rel/ogc/1.0/execute", "application/json",
                                      self + "/execution", "Execution of the process")})}};
}

Response list_processes(const Context& context, const Request& request, const PathParameters&) {
  ParameterReader reader{request};
  const auto limit = static_cast<std::size_t>(reader.limit());
  if (!reader.violations().empty()) return invalid(request, reader.violations());
  const std::string& url = context.service.public_url;
  json processes = json::array();
  for (const auto& process : all_processes()) {
    if (processes.size() < limit) processes.push_back(process_summary(process, url));
  }
  return json_reply({{"processes", processes},
                     {"links", json::array({link("self", "application/json", url + "/processes")})}});
}

Response show_process(const Context& context, const Request& request, const PathParameters& path) {
  const ProcessEntry* process = find_process(path.at("process_id"));
  if (process == nullptr) return no_such_process(request, path.at("process_id"));
  json description = process_summary(*process, context.service.public_url);
  description["inputs"] = inputs_of(*process);
  description["outputs"] = outputs_of(*process);
  return json_reply(description);
}

}  // namespace

std::vector<Route> process_routes() {
  return {{"GET", "/processes", {"limit"}, list_processes},
          {"GET", "/processes/{process_id}", {}, show_process}};
}

}  // namespace floeplan::routes
