#include "api/routes/processes/execution_request.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "api/codec/bytes/json_text.hpp"
#include "api/routes/request/reply.hpp"
#include "engine/messages/fault.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

constexpr const char* known_keys = "inputs, outputs, response, force";

/// The names of the requested outputs; empty means all.
json wanted_outputs(const json& body, const ProcessEntry& process, messages::Faults& faults) {
  json wanted = json::array();
  if (!body.contains("outputs")) return wanted;
  const json& outputs = body.at("outputs");
  if (!outputs.is_object()) {
    faults.refuse<"wrong-shape">("/outputs", "an object with the outputs that are wanted as its keys");
    return wanted;
  }
  for (const auto& [name, ignored] : outputs.items()) {
    if (std::ranges::find(process.outputs, name, &ProcessOutput::name) == process.outputs.end()) {
      faults.refuse<"not-an-output">("/outputs/" + name, process.id);
    }
    wanted.push_back(name);
  }
  return wanted;
}

std::string read_response(const json& body, messages::Faults& faults) {
  const json response = body.value("response", json("document"));
  if (response == "raw" || response == "document") return response.get<std::string>();
  faults.refuse<"wrong-shape">("/response", "raw or document");
  return {};
}

/// Whether an input has its media type or schema beside the value (qualifiedInputValue of OGC 18-062r2,
/// 7.11.2.3).
bool is_qualified(const json& input) {
  constexpr auto known =
      std::to_array<std::string_view>({"value", "mediaType", "encoding", "schema", "format"});
  if (!input.is_object() || !input.contains("value")) return false;
  for (const auto& [key, ignored] : input.items())
    if (std::ranges::find(known, std::string_view{key}) == known.end()) return false;
  return true;
}

/// Replaces an input by its bare value. Links and encoded values are refused: the server fetches and decodes
/// nothing.
void unwrap(json& input, const std::string& pointer, messages::Faults& faults) {
  if (input.is_object() && input.contains("href") && !input.contains("type"))
    return faults.refuse<"link-not-followed">(pointer);
  if (!is_qualified(input)) return;
  const json encoding = input.value("encoding", json());
  if (!encoding.is_null() && encoding != "utf-8" && encoding != "UTF-8")
    return faults.refuse<"wrong-shape">(pointer + "/encoding", "utf-8 or be left out");
  json value = std::move(input.at("value"));
  input = std::move(value);
}

/// Unwraps every input, also arrays of qualified values.
void unwrap_inputs(json& inputs, messages::Faults& faults) {
  if (!inputs.is_object()) return;
  for (auto& [name, input] : inputs.items()) {
    const std::string pointer = "/inputs/" + name;
    unwrap(input, pointer, faults);
    if (!input.is_array() || input.empty() || !std::ranges::all_of(input, is_qualified)) continue;
    for (std::size_t i = 0; i < input.size(); ++i)
      unwrap(input[i], pointer + "/" + std::to_string(i), faults);
  }
}

bool read_force(const json& body, messages::Faults& faults) {
  const json force = body.value("force", json(false));
  if (force.is_boolean()) return force.get<bool>();
  faults.refuse<"wrong-shape">("/force", "true or false");
  return false;
}

}  // namespace

tl::expected<ExecutionRequest, Response> read_execution(const Request& request, const ProcessEntry& process) {
  const std::string type = request.header("content-type");
  if (!type.empty() && type.find("json") == std::string::npos) {
    return tl::unexpected(problem_reply<"no-json">(request));
  }
  auto body = codec::parse_json(request.body);
  if (!body) return tl::unexpected(problem_reply<"invalid-json">(request, body.error()));
  if (!body->is_object())
    return tl::unexpected(
        invalid(request, {messages::fault<"wrong-shape">("", "an object with \"inputs\"")}));

  messages::Faults faults;
  for (const auto& [key, value] : body->items()) {
    if (key != "inputs" && key != "outputs" && key != "response" && key != "force") {
      faults.refuse<"unknown-member">("/" + key, known_keys);
    }
  }
  if (!body->contains("inputs")) faults.refuse<"required">("/inputs", "those of the process, an object");
  ExecutionRequest result;
  result.force = read_force(*body, faults);
  const json reply{{"outputs", wanted_outputs(*body, process, faults)},
                   {"response", read_response(*body, faults)}};
  if (body->contains("inputs")) unwrap_inputs(body->at("inputs"), faults);
  if (!faults.found().empty()) return tl::unexpected(invalid(request, faults.found()));
  result.reply_json = reply.dump();
  result.inputs = std::move(body->at("inputs"));
  return result;
}

}  // namespace floeplan::routes
