#include <algorithm>

#include "api/codec/bytes/json_text.hpp"
#include "api/codec/documents/mission_document.hpp"
#include "api/codec/reading/input_reader.hpp"
#include "api/routes/plans/mission_uploads.hpp"
#include "api/routes/request/parameters.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "api/service/flight_check_service.hpp"
#include "engine/mission/reading/read_document.hpp"
#include "storage/json/json.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

/// Query parameters that are members of a plan's inputs, too: with one of them the sea is asked.
const std::vector<std::string> texts{"depart",     "vehicle", "currents", "tides",     "tides_mode", "wind",
                                     "bathymetry", "ice",     "icebergs", "coastline", "zones"};
const std::vector<std::string> numbers{"speed_m_s", "dive_depth_m", "margin_m"};

/// Adds what the query says of the flight to what the body says.
void add_query(const Request& request, json& inputs) {
  for (const std::string& name : texts) {
    if (const auto text = request.parameter(name)) inputs[name] = *text;
  }
  for (const std::string& name : numbers) {
    const auto text = request.parameter(name);
    if (!text) continue;
    const auto number = codec::parse_json(*text);
    inputs[name] = number ? *number : json(*text);
  }
  if (request.parameter("steady")) inputs["steady"] = request.parameter("steady") == "true";
}

/// Where the vehicle is, as the query or the inputs say it; out of the inputs it is taken.
std::optional<geo::LonLat> take_start(const Request& request, json& inputs, core::Violations& faults) {
  ParameterReader query{request};
  codec::InputReader body{inputs, "/inputs"};
  const auto from_query = query.places("from");
  const auto from_body = body.place("from");
  faults = query.violations();
  faults.insert(faults.end(), body.violations().begin(), body.violations().end());
  inputs.erase("from");
  return from_query ? std::optional{from_query->front()} : from_body;
}

/// Judges the files in the body as one flight. A file that is rejected is an answer, not a fault of the request.
Response check_missions(const Context& context, const Request& request, const PathParameters&) {
  auto uploads = read_uploads(request);
  if (!uploads) return invalid(request, uploads.error());
  add_query(request, uploads->inputs);
  core::Violations faults;
  const auto start = take_start(request, uploads->inputs, faults);
  if (!faults.empty()) return invalid(request, faults);

  std::vector<mission::Document> documents;
  for (const UploadedFile& file : uploads->files)
    documents.push_back(mission::read_document(file.name, file.bytes));
  if (!uploads->inputs.empty() || start) {
    faults = service::check_flight(context.db, uploads->inputs, start, documents);
    if (!faults.empty()) return invalid(request, faults);
  }
  if (const auto plan = request.parameter("plan_id")) {
    faults = service::compare_with_plan(context.db, *plan, documents);
    if (!faults.empty()) return invalid(request, faults);
  }
  if (uploads->alone)
    return json_reply(codec::mission_document(documents.front(), uploads->files.front().name));
  json answers = json::array();
  for (std::size_t i = 0; i < documents.size(); ++i)
    answers.push_back(codec::mission_document(documents[i], uploads->files[i].name));
  return json_reply(answers);
}

}  // namespace

std::vector<Route> mission_check_routes() {
  std::vector<std::string> parameters{"name", "from", "plan_id", "steady"};
  parameters.insert(parameters.end(), texts.begin(), texts.end());
  parameters.insert(parameters.end(), numbers.begin(), numbers.end());
  return {{"POST", "/missions/check", parameters, check_missions, Access::viewer}};
}

}  // namespace floeplan::routes
