#include "api/fields/process_fields.hpp"

#include "api/fields/request_fields.hpp"

namespace floeplan::fields {
namespace {

void add(std::vector<Field>& all, const std::vector<Field>& part) {
  all.insert(all.end(), part.begin(), part.end());
}

template <class Values>
void add(std::vector<Field>& all, const Table<Values>& part) {
  for (const Bound<Values>& row : part) all.push_back(row.field);
}

template <class... Parts>
std::vector<Field> joined(const Parts&... parts) {
  std::vector<Field> all;
  (add(all, parts), ...);
  return all;
}

/// Fields that all three processes have.
std::vector<Field> voyage() {
  return joined(departure_fields(), vehicle_fields(), flight_fields(), margin_fields(), iceberg_fields(),
                sighting_fields(), passing_under_ice_fields(), area_fields(), data_fields(), name_fields());
}

/// Fields with further rules for a route.
std::vector<Field> route_rules() {
  return joined(objective_fields(), weight_fields(), energy_fields(), hold_fields(), surfacing_fields(),
                remark_fields());
}

}  // namespace

std::vector<Field> fields_of(Process process) {
  switch (process) {
    case Process::plan_route:
      return joined(way_fields(), order_fields(), voyage(), window_fields(), alternative_fields(),
                    route_rules(), grid_fields(), leg_fields(), search_fields(), encounter_fields(),
                    error_model_fields(), robustness_fields());
    case Process::evaluate_route: return joined(given_route_fields(), conditions_of_route());
    case Process::reach: return joined(isochrone_fields(), isochrone_grid_fields(), voyage());
  }
  return {};
}

std::vector<Field> conditions_of_route() { return joined(voyage(), route_rules()); }

std::vector<Field> fields_of_vehicle() {
  std::vector<Field> all = joined(profile_fields(), flight_fields(), build_fields(), thruster_fields());
  for (Field& field : all)
    if (field.object.empty()) field.object = "vehicle";
  return all;
}

}  // namespace floeplan::fields
