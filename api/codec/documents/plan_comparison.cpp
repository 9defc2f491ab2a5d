#include "api/codec/documents/plan_comparison.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

constexpr std::array texts{"plan_id", "method", "vehicle", "departure", "arrival"};
constexpr std::array numbers{"travel_time_s", "distance_m", "energy_j", "iceberg_encounters"};
constexpr std::array of_ice{"below_ice_m", "below_ice_s", "longest_without_surfacing_s"};
constexpr std::array clearances{"iceberg_m", "land_m", "bottom_m"};

json clearance_of(const json& document, const char* name) {
  return document.value("clearances", json::object()).value(name, json());
}

/// Null where the plan knows nothing of ice, or not yet that.
json ice_figure_of(const json& document, const char* name) {
  const json surfacing = document.value("surfacing", json());
  return surfacing.is_null() ? json() : surfacing.value(name, json());
}

json figures_of(const repository::PlanRecord& plan, const json& document) {
  json figures{{"name", plan.name},
               {"created", core::iso8601(plan.created)},
               {"waypoints", document.at("waypoints").size()}};
  for (const char* name : texts) figures[name] = document.at(name);
  for (const char* name : numbers) figures[name] = document.value(name, json());
  for (const char* name : of_ice) figures[name] = ice_figure_of(document, name);
  for (const char* name : clearances) figures["clearances"][name] = clearance_of(document, name);
  return figures;
}

/// Second minus first; null if one of them is unknown.
json less(const json& second, const json& first) {
  if (!first.is_number() || !second.is_number()) return {};
  return second.get<double>() - first.get<double>();
}

json difference(const repository::PlanRecord& first_plan, const json& first,
                const repository::PlanRecord& second_plan, const json& second) {
  json result{{"departure_s", (second_plan.departure - first_plan.departure).count()},
              {"arrival_s", (second_plan.arrival - first_plan.arrival).count()}};
  for (const char* name : numbers) result[name] = less(second.at(name), first.at(name));
  for (const char* name : of_ice) result[name] = less(second.at(name), first.at(name));
  for (const char* name : clearances)
    result["clearances"][name] = less(clearance_of(second, name), clearance_of(first, name));
  return result;
}

/// Members of the requests that differ; null if a request does not have the member.
json differing_inputs(const json& first, const json& second) {
  std::set<std::string> names;
  for (const auto& [name, value] : first.items()) names.insert(name);
  for (const auto& [name, value] : second.items()) names.insert(name);
  json result = json::array();
  for (const std::string& name : names) {
    const json in_first = first.value(name, json());
    const json in_second = second.value(name, json());
    if (in_first != in_second)
      result.push_back({{"input", name}, {"first", in_first}, {"second", in_second}});
  }
  return result;
}

/// Adds datasets of `document` that `other` does not have with the same content.
void add_own_data(json& list, const json& document, const json& other, const char* whose) {
  for (const json& dataset : document.at("datasets")) {
    const bool shared = std::ranges::any_of(other.at("datasets"), [&](const json& candidate) {
      return candidate.at("id") == dataset.at("id") && candidate.at("sha256") == dataset.at("sha256");
    });
    if (shared) continue;
    list.push_back({{"id", dataset.at("id")},
                    {"kind", dataset.at("kind")},
                    {"name", dataset.at("name")},
                    {"sha256", dataset.at("sha256")},
                    {"used_by", whose}});
  }
}

}  // namespace

json plan_comparison(const repository::PlanRecord& first, const repository::PlanRecord& second) {
  const json a = json::parse(first.document_json);
  const json b = json::parse(second.document_json);
  const json a_figures = figures_of(first, a);
  const json b_figures = figures_of(second, b);
  json data = json::array();
  add_own_data(data, a, b, "first");
  add_own_data(data, b, a, "second");
  return {{"first", a_figures},
          {"second", b_figures},
          {"difference", difference(first, a_figures, second, b_figures)},
          {"inputs", differing_inputs(json::parse(first.request_json), json::parse(second.request_json))},
          {"data", std::move(data)}};
}

}  // namespace floeplan::codec
