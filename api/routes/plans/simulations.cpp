
#include "api/routes/plans/simulation_exports.hpp"
#include "api/routes/request/paging.hpp"
#include "api/routes/request/parameters.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "api/routes/request/store_trouble.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/work/simulation_repository.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using repository::SimulationRecord;
using repository::SimulationRepository;

constexpr std::int64_t last_run = 1'000'000;

Response unknown_simulation(const Request& request, const PathParameters& path) {
  return problem_reply<"unknown-simulation">(request, path.at("simulation_id"));
}

std::string address_of_simulation(const Context& context, const SimulationRecord& record) {
  return context.service.public_url + "/simulations/" + record.id.value;
}

/// The simulation without the rows of its flights, which can be thousands.
json summary_of(const Context& context, const SimulationRecord& record) {
  json summary = json::parse(record.document_json);
  summary.erase("flights");
  summary["created"] = core::iso8601(record.created);
  summary["links"] = json::array({link("self", "application/json", address_of_simulation(context, record))});
  return summary;
}

Response list_simulations(const Context& context, const Request& request, const PathParameters&) {
  ParameterReader reader{request};
  const int limit = reader.limit();
  const std::int64_t after = reader.after();
  if (!reader.violations().empty()) return invalid(request, reader.violations());

  const auto plan_id = request.parameter("plan_id");
  const SimulationRepository repository{context.db};
  const auto [found, damaged] = repository.list_past_damage(plan_id, after, limit);
  const std::string& url = context.service.public_url;
  json simulations = json::array();
  for (const SimulationRecord& record : found) simulations.push_back(summary_of(context, record));
  json links = json::array({link("self", "application/json", address_of(request, url))});
  if (found.size() == static_cast<std::size_t>(limit)) {
    links.push_back(link("next", "application/json",
                         address_with(request, url, "after", std::to_string(found.back().row))));
  }
  json page{{"simulations", std::move(simulations)}, {"links", std::move(links)}};
  (void)sql::meets_no_damage([&] { page["numberMatched"] = repository.count(plan_id); });
  name_damaged(page, damaged);
  return json_reply(page);
}

Response show_simulation(const Context& context, const Request& request, const PathParameters& path) {
  const auto record = SimulationRepository{context.db}.find({path.at("simulation_id")});
  if (!record) return unknown_simulation(request, path);
  json document = json::parse(record->document_json);
  const std::string self = address_of_simulation(context, *record);
  document["created"] = core::iso8601(record->created);
  document["inputs"] = json::parse(record->request_json);
  document["links"] = json::array({link("self", "application/json", self)});
  for (const SimulationFormat& format : simulation_formats())
    document["links"].push_back(link("enclosure", format.content_type, self + "/tracks." + format.name));
  return json_reply(document);
}

Response show_flight(const Context& context, const Request& request, const PathParameters& path) {
  const SimulationRepository repository{context.db};
  if (!repository.find({path.at("simulation_id")})) return unknown_simulation(request, path);
  const std::string& text = path.at("run");
  const bool number =
      !text.empty() && text.size() < 8 && text.find_first_not_of("0123456789") == std::string::npos;
  const auto flight =
      number ? repository.find_flight({path.at("simulation_id")}, std::stoll(text)) : std::nullopt;
  if (!flight) {
    return problem_reply<"unknown-flight">(request, text);
  }
  return json_reply(json::parse(flight->document_json));
}

/// All stored flights, or the one in the parameter `run`.
template <std::size_t format_number>
Response export_tracks(const Context& context, const Request& request, const PathParameters& path) {
  ParameterReader reader{request};
  const auto run = reader.integer("run", 0, last_run);
  if (!reader.violations().empty()) return invalid(request, reader.violations());
  const auto record = SimulationRepository{context.db}.find({path.at("simulation_id")});
  if (!record) return unknown_simulation(request, path);

  const SimulationFormat& format = simulation_formats()[format_number];
  auto bytes = export_simulation(context.db, *record, format, run);
  if (!bytes) return problem_reply<"no-flight-kept">(request);
  Response response;
  response.content_type = format.content_type;
  response.headers.emplace_back("Content-Disposition",
                                "attachment; filename=\"" + record->id.value + "." + format.name + "\"");
  response.body = std::move(*bytes);
  return response;
}

Response remove_simulation(const Context& context, const Request& request, const PathParameters& path) {
  if (!SimulationRepository{context.db}.remove({path.at("simulation_id")}))
    return unknown_simulation(request, path);
  Response response;
  response.status = 204;
  return response;
}

}  // namespace

std::vector<Route> simulation_routes() {
  return {{"GET", "/simulations", {"plan_id", "limit", "after"}, list_simulations},
          {"GET", "/simulations/{simulation_id}", {}, show_simulation},
          {"DELETE", "/simulations/{simulation_id}", {}, remove_simulation},
          {"GET", "/simulations/{simulation_id}/flights/{run}", {}, show_flight},
          {"GET", "/simulations/{simulation_id}/tracks.nc", {"run"}, export_tracks<0>},
          {"GET", "/simulations/{simulation_id}/tracks.geojson", {"run"}, export_tracks<1>}};
}

}  // namespace floeplan::routes
