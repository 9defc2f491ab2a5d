#include <array>
#include <stdexcept>
#include <utility>

#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/refinement_report.hpp"

namespace floeplan::planning {
namespace {

constexpr std::array<std::pair<Method, const char*>, 5> methods{{{Method::tve, "tve"},
                                                                 {Method::dijkstra, "dijkstra"},
                                                                 {Method::astar, "astar"},
                                                                 {Method::frozen, "frozen"},
                                                                 {Method::direct, "direct"}}};

constexpr std::array<std::pair<RefinementEnd, const char*>, 4> refinement_ends{
    {{RefinementEnd::converged, "converged"},
     {RefinementEnd::evaluations, "evaluations"},
     {RefinementEnd::time, "time"},
     {RefinementEnd::cancelled, "cancelled"}}};

}  // namespace

std::string method_name(Method method) {
  for (const auto& [candidate, name] : methods) {
    if (candidate == method) return name;
  }
  throw std::logic_error{"Method without a name"};
}

std::optional<Method> parse_method(std::string_view name) {
  for (const auto& [method, candidate] : methods) {
    if (name == candidate) return method;
  }
  return std::nullopt;
}

std::string refinement_end_name(RefinementEnd end) {
  for (const auto& [candidate, name] : refinement_ends) {
    if (candidate == end) return name;
  }
  throw std::logic_error{"RefinementEnd without a name"};
}

std::optional<RefinementEnd> parse_refinement_end(std::string_view name) {
  for (const auto& [end, candidate] : refinement_ends) {
    if (name == candidate) return end;
  }
  return std::nullopt;
}

std::string reason_name(Reason reason) {
  switch (reason) {
    case Reason::start_on_land: return "start_on_land";
    case Reason::start_too_shallow: return "start_too_shallow";
    case Reason::start_near_iceberg: return "start_near_iceberg";
    case Reason::start_in_zone: return "start_in_zone";
    case Reason::goal_on_land: return "goal_on_land";
    case Reason::goal_too_shallow: return "goal_too_shallow";
    case Reason::goal_near_iceberg: return "goal_near_iceberg";
    case Reason::goal_in_zone: return "goal_in_zone";
    case Reason::outside_data: return "outside_data";
    case Reason::current_too_strong: return "current_too_strong";
    case Reason::too_shallow: return "too_shallow";
    case Reason::near_iceberg: return "near_iceberg";
    case Reason::in_zone: return "in_zone";
    case Reason::under_ice: return "under_ice";
    case Reason::no_surfacing: return "no_surfacing";
    case Reason::no_escape: return "no_escape";
    case Reason::goal_unreachable: return "goal_unreachable";
    case Reason::arrival_too_early: return "arrival_too_early";
    case Reason::energy_exceeded: return "energy_exceeded";
    case Reason::too_large: return "too_large";
    case Reason::cancelled: return "cancelled";
  }
  throw std::logic_error{"Reason without a name"};
}

std::string constraint_name(Constraint constraint) {
  switch (constraint) {
    case Constraint::current: return "current";
    case Constraint::depth: return "depth";
    case Constraint::land: return "land";
    case Constraint::iceberg: return "iceberg";
    case Constraint::ice: return "ice";
    case Constraint::zone: return "zone";
    case Constraint::data_area: return "data_area";
    case Constraint::data_period: return "data_period";
    case Constraint::battery: return "battery";
    case Constraint::memory: return "memory";
    case Constraint::caller: return "caller";
  }
  throw std::logic_error{"Constraint without a name"};
}

}  // namespace floeplan::planning
