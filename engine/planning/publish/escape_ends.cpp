#include "engine/planning/publish/escape_ends.hpp"

#include <optional>

#include "engine/messages/plan_messages.hpp"
#include "engine/planning/cost/met_currents.hpp"
#include "engine/planning/ice/nearest_ice.hpp"
#include "engine/planning/problem/position_error.hpp"

namespace floeplan::planning::publish {
namespace {

/// An escape route as the vehicle flies it from its waypoint, which it reaches at `arrives`.
struct Flight {
  CarriedWay carried;  // the drift by errors of the currents
  core::Metres grown;  // the growth of the position error by the rules
  core::Seconds ends;  // when the vehicle surfaces
};

Flight flown(const EscapeWay& escape, const cost::Sea& sea, const UnderIceRules& rules,
             core::Seconds arrives) {
  const core::Metres step = sea.overhead().look();
  Flight flight{.carried = {}, .grown = {}, .ends = arrives};
  geo::PlanePoint from = sea.projection().to_plane(escape.way.front());
  for (std::size_t i = 1; i < escape.way.size(); ++i) {
    const geo::PlanePoint to = sea.projection().to_plane(escape.way[i]);
    const vehicle::Drive drive = escape.drives[i - 1];
    cost::Sea::Passage last{from, flight.ends};
    for (const cost::Sea::Passage& passage : sea.passages(from, to, flight.ends, step, drive)) {
      flight.carried = flight.carried + cost::carried_between(sea, last, passage);
      last = passage;
    }
    flight.grown = flight.grown + grown_error(rules, sea.speed(drive), last.time - flight.ends);
    flight.ends = last.time;
    from = to;
  }
  return flight;
}

}  // namespace

void warn_of_escapes_to_the_edge(Plan& plan, const cost::Sea& sea, const PlanRequest& request) {
  if (!sea.ice()) return;
  struct Near {
    std::size_t waypoint;
    core::Metres ice;
    core::Metres error;
  };
  std::size_t near = 0;
  std::optional<Near> first;
  for (std::size_t i = 0; i < plan.surfacing->escapes.size(); ++i) {
    const EscapeWay& escape = plan.surfacing->escapes[i];
    if (escape.way.size() < 2) continue;
    const core::Seconds arrives = plan.waypoints[i].eta - request.depart;
    const Flight flight = flown(escape, sea, request.under_ice, arrives);
    const auto& [off, with_current] = plan.surfacing->reckoned[i];
    const core::Metres by_rules = plan.surfacing->waypoints[i].position_error - off.length() + flight.grown;
    const CarriedWay off_at_end = off + flight.carried - with_current * (flight.ends - arrives);
    const core::Metres error = by_rules + off_at_end.length();
    const auto ice =
        ice::nearest_ice_within(error, *sea.ice(), sea.projection().to_plane(escape.way.back()), flight.ends);
    if (!ice || near++ > 0) continue;
    first = {i, *ice, error};
  }
  if (!first) return;
  plan.messages.push_back(messages::plan_message<"escapes-end-near-ice">(
                              near, first->waypoint, first->ice.value / 1000.0, first->error.value / 1000.0)
                              .at(plan.waypoints[first->waypoint].place));
}

}  // namespace floeplan::planning::publish
