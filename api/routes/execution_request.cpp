#include "api/routes/execution_request.hpp"

#include <algorithm>
#include <utility>

#include "api/codec/json_text.hpp"
#include "api/routes/reply.hpp"
#include "engine/core/violation_list.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

constexpr const char* known_keys = "inputs, outputs, response, force";

/// The names of the outputs that the client wants; none: all of them.
json wanted_outputs(const json& body, const ProcessEntry& process, core::Violations& violations) {
  json wanted = json::array();
  if (!body.contains("outputs")) return wanted;
  const json& outputs = body.at("outputs");
  if (!outputs.is_object()) {
    core::note(violations, {"/outputs", "must be an object with the outputs that are wanted as its keys"});
    return wanted;
  }
  for (const auto& [name, ignored] : outputs.items()) {
    if (std::ranges::find(process.outputs, name, &ProcessOutput::name) == process.outputs.end()) {
      core::note(violations, {"/outputs/" + name, "is not an output of the process " + process.id});
    }
    wanted.push_back(name);
  }
  return wanted;
}

std::string read_response(const json& body, core::Violations& violations) {
  const json response = body.value("response", json("document"));
  if (response == "raw" || response == "document") return response.get<std::string>();
  core::note(violations, {"/response", "must be raw or document"});
  return {};
}

bool read_force(const json& body, core::Violations& violations) {
  const json force = body.value("force", json(false));
  if (force.is_boolean()) return force.get<bool>();
  core::note(violations, {"/force", "must be true or false"});
  return false;
}

}  // namespace

tl::expected<ExecutionRequest, Response> read_execution(const Request& request, const ProcessEntry& process) {
  const std::string type = request.header("content-type");
  if (!type.empty() && type.find("json") == std::string::npos) {
    return tl::unexpected(problem_reply(
        request,
        {415, "unsupported-media-type", "Unsupported media type", "The body must be application/json.", {}}));
  }
  auto body = codec::parse_json(request.body);
  if (!body)
    return tl::unexpected(problem_reply(request, {400, "invalid-json", "Invalid JSON", body.error(), {}}));
  if (!body->is_object())
    return tl::unexpected(invalid(request, {{"", "must be an object with \"inputs\""}}));

  core::Violations violations;
  for (const auto& [key, value] : body->items()) {
    if (key != "inputs" && key != "outputs" && key != "response" && key != "force") {
      core::note(violations, {"/" + key, std::string{"is not known; the known keys are "} + known_keys});
    }
  }
  if (!body->contains("inputs")) core::note(violations, {"/inputs", "is required"});
  ExecutionRequest result;
  result.force = read_force(*body, violations);
  const json reply{{"outputs", wanted_outputs(*body, process, violations)},
                   {"response", read_response(*body, violations)}};
  if (!violations.empty()) return tl::unexpected(invalid(request, std::move(violations)));
  result.reply_json = reply.dump();
  result.inputs = std::move(body->at("inputs"));
  return result;
}

}  // namespace floeplan::routes
