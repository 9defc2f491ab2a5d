#include "api/codec/json_text.hpp"
#include "api/codec/mission_document.hpp"
#include "api/routes/flight_check_service.hpp"
#include "api/routes/parameters.hpp"
#include "api/routes/reply.hpp"
#include "api/routes/resources.hpp"
#include "engine/mission/read_document.hpp"

namespace floeplan::routes {
namespace {

constexpr std::size_t longest_file_name = 200;

/// Query parameters that are members of a plan's inputs, too: with one of them the sea is asked.
const std::vector<std::string> texts{"depart", "vehicle", "currents", "bathymetry", "icebergs", "coastline"};
const std::vector<std::string> numbers{"speed_m_s", "dive_depth_m", "margin_m"};

std::optional<nlohmann::json> inputs_of(const Request& request) {
  nlohmann::json inputs = nlohmann::json::object();
  for (const std::string& name : texts) {
    if (const auto text = request.parameter(name)) inputs[name] = *text;
  }
  for (const std::string& name : numbers) {
    const auto text = request.parameter(name);
    if (!text) continue;
    const auto number = codec::parse_json(*text);
    inputs[name] = number ? *number : nlohmann::json(*text);
  }
  if (request.parameter("steady")) inputs["steady"] = request.parameter("steady") == "true";
  return inputs.empty() && !request.parameter("from") ? std::nullopt : std::optional{inputs};
}

/// Judges the file in the body. A file that is rejected is an answer, not a fault of the request.
Response check_mission(const Context& context, const Request& request, const PathParameters&) {
  const std::string name = request.parameter("name").value_or("");
  if (name.size() > longest_file_name)
    return invalid(request, {{"name", "must be a file name of at most 200 characters"}});
  std::vector<mission::Document> documents{mission::read_document(name, request.body)};
  if (const auto inputs = inputs_of(request)) {
    ParameterReader reader{request};
    const auto from = reader.places("from");
    core::Violations faults = reader.violations();
    if (faults.empty())
      faults =
          check_flight(context.db, *inputs, from ? std::optional{from->front()} : std::nullopt, documents);
    if (!faults.empty()) return invalid(request, faults);
  }
  return json_reply(codec::mission_document(documents.front(), name));
}

}  // namespace

std::vector<Route> mission_check_routes() {
  std::vector<std::string> parameters{"name", "from", "steady"};
  parameters.insert(parameters.end(), texts.begin(), texts.end());
  parameters.insert(parameters.end(), numbers.begin(), numbers.end());
  return {{"POST", "/missions/check", parameters, check_mission}};
}

}  // namespace floeplan::routes
