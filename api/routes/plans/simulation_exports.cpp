#include "api/routes/plans/simulation_exports.hpp"

#include <array>
#include <vector>

#include "api/codec/exports/simulation_exports.hpp"
#include "storage/json/json.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

std::vector<json> flights_of(sql::Connection& db, const repository::SimulationRecord& record,
                             std::optional<std::int64_t> run) {
  const repository::SimulationRepository repository{db};
  std::vector<json> flights;
  if (!run) {
    for (const auto& flight : repository.flights(record.id))
      flights.push_back(json::parse(flight.document_json));
  } else if (const auto flight = repository.find_flight(record.id, *run)) {
    flights.push_back(json::parse(flight->document_json));
  }
  return flights;
}

}  // namespace

std::span<const SimulationFormat> simulation_formats() {
  static const std::array<SimulationFormat, 2> formats{
      {{"nc", "application/netcdf"}, {"geojson", "application/geo+json"}}};
  return formats;
}

std::optional<std::string> export_simulation(sql::Connection& db, const repository::SimulationRecord& record,
                                             const SimulationFormat& format,
                                             std::optional<std::int64_t> run) {
  const std::vector<json> flights = flights_of(db, record, run);
  if (flights.empty()) return std::nullopt;
  const json simulation = json::parse(record.document_json);
  if (format.name == "nc") return codec::simulation_netcdf(simulation, flights);
  return codec::simulation_geojson(simulation, flights).dump(2) + "\n";
}

}  // namespace floeplan::routes
