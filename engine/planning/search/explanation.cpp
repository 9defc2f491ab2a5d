#include "engine/planning/search/explanation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "engine/geo/geodesic.hpp"
#include "engine/messages/refusal_messages.hpp"
#include "engine/planning/search/missing_data.hpp"
#include "engine/planning/search/usable_place.hpp"

namespace floeplan::planning::search {
namespace {

double hours(core::Seconds time) { return time.count() / 3600.0; }

core::UtcTime clock(const PlanRequest& request, core::Seconds since_departure) {
  return request.depart + since_departure;
}

/// What closes a leg, and what would help.
struct Closure {
  Reason reason;
  messages::Message why;
};

/// Text that names the iceberg nearest to the place, the time and the distance that is kept clear of the
/// iceberg.
std::string iceberg_text(const cost::Sea& sea, geo::PlanePoint place, core::Seconds when,
                         const PlanRequest& request) {
  const auto berg = sea.domain().icebergs().nearest(place, when);
  if (!berg) return messages::phrase<"an-iceberg">();
  const std::string name = berg->name.empty() ? "an iceberg without a name" : "iceberg " + berg->name;
  const core::Metres margin = request.icebergs.margin;
  const core::Metres error = berg->kept_off - margin;
  if (error.value < 1.0)
    return messages::phrase<"iceberg-with-margin">(name, clock(request, when), margin.value);
  return messages::phrase<"iceberg-with-margin-and-error">(name, clock(request, when), margin.value,
                                                           error.value);
}

/// The closure of a place that contains the time `when`; empty if there is none.
std::optional<TimeSpan> closure_at(const std::vector<TimeSpan>& times, core::Seconds when) {
  for (const TimeSpan& closed : times)
    if (closed.from <= when && when <= closed.until) return closed;
  return std::nullopt;
}

/// Text that says when a place that is closed at `when` reopens.
std::string opening_text(const std::vector<TimeSpan>& times, core::Seconds when, const PlanRequest& request) {
  const auto closed = closure_at(times, when);
  if (!closed) return "";
  if (!std::isfinite(closed->until.count())) return messages::phrase<"for-good">();
  return messages::phrase<"until">(clock(request, closed->until));
}

Closure closure_of(motion::EdgeClosed closed, const cost::Sea& sea, const PlanRequest& request,
                   bool out_of_time, geo::PlanePoint at, core::Seconds when) {
  switch (closed) {
    case motion::EdgeClosed::current_too_strong: {
      const vehicle::Drive fastest = drives(request.energy, request.vehicle).back();
      return {Reason::current_too_strong,
              messages::refusal<"current-too-strong">(drive_speed(request.vehicle, fastest).value)};
    }
    case motion::EdgeClosed::outside_data: {
      const auto end = sea.domain().currents() ? sea.domain().currents()->end() : std::nullopt;
      if (end && out_of_time)
        return {Reason::outside_data,
                messages::refusal<"currents-end-before-the-route">(clock(request, *end))};
      return {Reason::outside_data, messages::refusal<"way-outside-data">()};
    }
    case motion::EdgeClosed::too_shallow:
      return {Reason::too_shallow, messages::refusal<"way-too-shallow">(request.vehicle.least_water().value)};
    case motion::EdgeClosed::on_land: return {Reason::too_shallow, messages::refusal<"way-on-land">()};
    case motion::EdgeClosed::in_zone: return {Reason::in_zone, messages::refusal<"way-in-zone">()};
    case motion::EdgeClosed::under_ice:
      return {Reason::under_ice,
              messages::refusal<"no-room-below-ice">(request.vehicle.least_water_below_turn().value,
                                                     request.under_ice.margin_below_ice.value)};
    case motion::EdgeClosed::no_surfacing:
      return {Reason::no_surfacing, messages::refusal<"too-long-without-surfacing">(
                                        hours(*request.under_ice.max_time_without_surfacing))};
    case motion::EdgeClosed::too_late:
    case motion::EdgeClosed::obstacle:
      return {Reason::near_iceberg,
              messages::refusal<"way-near-iceberg">(iceberg_text(sea, at, when, request))};
  }
  throw std::logic_error{"EdgeClosed without words"};
}

Constraint constraint_of(motion::EdgeClosed closed, bool out_of_time) {
  switch (closed) {
    case motion::EdgeClosed::current_too_strong: return Constraint::current;
    case motion::EdgeClosed::outside_data:
      return out_of_time ? Constraint::data_period : Constraint::data_area;
    case motion::EdgeClosed::too_shallow: return Constraint::depth;
    case motion::EdgeClosed::on_land: return Constraint::land;
    case motion::EdgeClosed::in_zone: return Constraint::zone;
    case motion::EdgeClosed::under_ice:
    case motion::EdgeClosed::no_surfacing: return Constraint::ice;
    case motion::EdgeClosed::too_late:
    case motion::EdgeClosed::obstacle: return Constraint::iceberg;
  }
  throw std::logic_error{"EdgeClosed without a constraint"};
}

/// The reason that fits the kind of stop: start, via point or goal.
Reason reason_at(Stop stop, Reason at_start, Reason on_the_way, Reason at_goal) {
  switch (stop) {
    case Stop::start: return at_start;
    case Stop::via: return on_the_way;
    case Stop::goal: return at_goal;
  }
  throw std::logic_error{"Stop without a reason"};
}

std::string subject_of(Stop stop) {
  switch (stop) {
    case Stop::start: return "the start";
    case Stop::via: return "a via point";
    case Stop::goal: return "the goal";
  }
  throw std::logic_error{"Stop without a name"};
}

Infeasible unusable_place(motion::EdgeClosed closed, Stop stop, geo::LonLat place, core::Seconds when,
                          const cost::Sea& sea, const PlanRequest& request) {
  const std::string subject = subject_of(stop);
  const geo::PlanePoint point = sea.domain().projection().to_plane(place);
  const auto infeasible = [&](Reason reason, core::UtcTime then, messages::Message why) {
    return Infeasible{.reason = reason,
                      .at = place,
                      .when = then,
                      .why = std::move(why).at(place),
                      .binding = constraint_of(closed, false),
                      .at_a_stop = true};
  };
  switch (closed) {
    case motion::EdgeClosed::on_land:
      return infeasible(reason_at(stop, Reason::start_on_land, Reason::too_shallow, Reason::goal_on_land),
                        request.depart, messages::refusal<"place-on-land">(subject));
    case motion::EdgeClosed::too_shallow:
      return infeasible(
          reason_at(stop, Reason::start_too_shallow, Reason::too_shallow, Reason::goal_too_shallow),
          request.depart,
          messages::refusal<"place-too-shallow">(subject, request.vehicle.least_water().value));
    case motion::EdgeClosed::in_zone:
      return infeasible(
          reason_at(stop, Reason::start_in_zone, Reason::in_zone, Reason::goal_in_zone), clock(request, when),
          messages::refusal<"place-in-zone">(
              subject, opening_text(sea.domain().closures().closed_times_by_zones(point), when, request)));
    case motion::EdgeClosed::obstacle:
      return infeasible(
          reason_at(stop, Reason::start_near_iceberg, Reason::near_iceberg, Reason::goal_near_iceberg),
          clock(request, when),
          messages::refusal<"place-near-iceberg">(
              subject, iceberg_text(sea, point, when, request),
              opening_text(sea.domain().closures().closed_times(point), when, request)));
    case motion::EdgeClosed::outside_data:
    case motion::EdgeClosed::under_ice:
    case motion::EdgeClosed::no_surfacing:
    case motion::EdgeClosed::too_late:
    case motion::EdgeClosed::current_too_strong: break;
  }
  throw std::logic_error{"a place that is not closed in this way"};
}

/// Says what `unusable_place` says, and how long the vehicle must wait until the place reopens.
Infeasible explain_closed_place(motion::EdgeClosed closed, Stop stop, geo::LonLat place, core::Seconds when,
                                const cost::Sea& sea, const PlanRequest& request) {
  Infeasible infeasible = unusable_place(closed, stop, place, when, sea, request);
  const auto closure =
      closure_at(sea.domain().closures().closed_times(sea.domain().projection().to_plane(place)), when);
  if (closure && std::isfinite(closure->until.count())) infeasible.postponed = closure->until - when;
  return infeasible;
}

/// The zone or iceberg that closes the place longest; empty if neither of them stopped the search.
std::optional<motion::EdgeClosed> closed_for_a_while(const cost::Sea& sea, geo::PlanePoint place,
                                                     core::Seconds when, motion::EdgeClosed stopped_by) {
  const auto by_iceberg = closure_at(sea.domain().closures().closed_times_by_icebergs(place), when);
  const auto by_zone = closure_at(sea.domain().closures().closed_times_by_zones(place), when);
  const bool is_among_them = (stopped_by == motion::EdgeClosed::obstacle && by_iceberg) ||
                             (stopped_by == motion::EdgeClosed::in_zone && by_zone);
  if (!is_among_them) return std::nullopt;
  if (!by_iceberg) return motion::EdgeClosed::in_zone;
  return by_zone && by_zone->until > by_iceberg->until ? motion::EdgeClosed::in_zone
                                                       : motion::EdgeClosed::obstacle;
}

/// Says that no route was found, and what closes most edges out of the reached vertex nearest to the goal.
messages::Message no_way(motion::EdgeClosed binding, bool cut_short, const messages::Message& closed) {
  if (cut_short) return messages::refusal<"no-way-within-memory">(closed.text, closed.hint);
  if (binding == motion::EdgeClosed::outside_data)
    return messages::refusal<"no-way-in-data">(closed.text, closed.hint);
  if (binding == motion::EdgeClosed::current_too_strong)
    return messages::refusal<"no-way-through-currents">(closed.text, closed.hint);
  return messages::refusal<"no-way-to-goal">(closed.text, closed.hint);
}

}  // namespace

messages::Message tell_of_nearest_water(Stop stop, geo::LonLat place,
                                        const std::optional<geo::LonLat>& nearest) {
  const std::string subject = subject_of(stop);
  if (!nearest) return messages::refusal<"no-water-near">(farthest_usable_place.value / 1000.0, subject);
  const geo::GeodesicLine line = geo::geodesic_between(place, *nearest);
  return messages::refusal<"nearest-water">(line.length.value / 1000.0,
                                            geo::compass_point(line.course_at_start), subject)
      .at(*nearest);
}

Infeasible explain_place(motion::EdgeClosed closed, Stop stop, geo::LonLat place, const cost::Sea& sea,
                         const ocean::Environment& environment, const PlanRequest& request) {
  if (closed != motion::EdgeClosed::outside_data)
    return unusable_place(closed, stop, place, core::Seconds{0.0}, sea, request);
  return {.reason = Reason::outside_data,
          .at = place,
          .when = request.depart,
          .why = explain_missing_depth(environment, place, subject_of(stop)).at(place),
          .binding = Constraint::data_area,
          .at_a_stop = true};
}

Infeasible explain_start(motion::EdgeClosed closed, geo::LonLat place, core::Seconds after,
                         const cost::Sea& sea, const PlanRequest& request) {
  return explain_closed_place(closed, Stop::start, place, after, sea, request);
}

Infeasible explain_route(const cost::RouteClosed& closed, const cost::Sea& sea, const PlanRequest& request) {
  Closure closure = closure_of(closed.reason, sea, request, closed.out_of_time, closed.at, closed.when);
  const geo::LonLat at = sea.domain().projection().to_lon_lat(closed.at);
  return {.reason = closure.reason,
          .at = at,
          .when = clock(request, closed.when),
          .why = std::move(closure.why).at(at),
          .binding = constraint_of(closed.reason, closed.out_of_time)};
}

Infeasible explain_search(const RouteSearch& search, Stop kind, geo::PlanePoint stop, const cost::Sea& sea,
                          const PlanRequest& request) {
  // The cause is the kind that closes most edges out of the reached vertex nearest to the goal; on a tie the
  // first kind.
  using enum motion::EdgeClosed;
  // If each of them is open, the bound on the time without surfacing ended the search.
  motion::EdgeClosed binding = sea.domain().overhead().bounds_surfacing() ? no_surfacing : on_land;
  std::ptrdiff_t most = 0;
  for (const motion::EdgeClosed kind :
       {outside_data, current_too_strong, no_surfacing, under_ice, too_shallow, on_land, in_zone, obstacle}) {
    const auto count = std::ranges::count(search.closed_at_nearest, kind);
    if (count > most) {
      most = count;
      binding = kind;
    }
  }
  const core::Seconds there = search.nearest_arrival + sea.least_time(search.nearest, stop);
  if (const auto closed = closed_for_a_while(sea, stop, there, binding)) {
    Infeasible why =
        explain_closed_place(*closed, kind, sea.domain().projection().to_lon_lat(stop), there, sea, request);
    if (search.statistics.holds_may_help) why.besides.push_back(messages::refusal<"never-holds">());
    return why;
  }
  // Data with a single time step end at the departure.
  const auto end = sea.domain().currents() ? sea.domain().currents()->end() : std::nullopt;
  const bool out_of_time = search.out_of_time || (end && *end <= core::Seconds{0.0});
  const Closure closure =
      closure_of(binding, sea, request, out_of_time, search.nearest, search.nearest_arrival);
  const bool by_data = binding == outside_data || binding == current_too_strong || binding == under_ice ||
                       binding == no_surfacing;
  const geo::LonLat at = sea.domain().projection().to_lon_lat(search.nearest);
  Infeasible infeasible{.reason = by_data ? closure.reason : Reason::goal_unreachable,
                        .at = at,
                        .when = clock(request, search.nearest_arrival),
                        .why = no_way(binding, search.statistics.cut_short, closure.why).at(at),
                        .binding = constraint_of(binding, out_of_time),
                        .search_cut_short = search.statistics.cut_short};
  if (infeasible.search_cut_short) infeasible.besides.push_back(messages::refusal<"search-without-end">());
  if (search.statistics.holds_may_help) infeasible.besides.push_back(messages::refusal<"never-holds">());
  return infeasible;
}

Infeasible explain_removable(Infeasible why, Constraint constraint) {
  why.reason = Reason::goal_unreachable;
  why.binding = constraint;
  const auto besides = [&]() -> messages::Message {
    switch (constraint) {
      case Constraint::iceberg: return messages::refusal<"way-without-icebergs">();
      case Constraint::zone: return messages::refusal<"way-without-zones">();
      case Constraint::ice: return messages::refusal<"way-without-ice">();
      case Constraint::current: return messages::refusal<"way-without-currents">();
      default: throw std::invalid_argument{"this constraint cannot be taken away"};
    }
  };
  why.besides.push_back(besides());
  return why;
}

Infeasible explain_no_escape(const cost::Sea& sea, const PlanRequest& request, geo::PlanePoint place,
                             core::Seconds when) {
  const auto bound = request.under_ice.max_time_without_surfacing;
  auto why = bound ? messages::refusal<"no-escape-in-time">(hours(*bound)) : messages::refusal<"no-escape">();
  const geo::LonLat at = sea.domain().projection().to_lon_lat(place);
  return {.reason = Reason::no_escape,
          .at = at,
          .when = clock(request, when),
          .why = std::move(why).at(at),
          .binding = Constraint::ice};
}

Infeasible explain_cancelled(const PlanRequest& request) {
  return {.reason = Reason::cancelled,
          .at = request.from,
          .when = request.depart,
          .why = messages::refusal<"cancelled">(),
          .binding = Constraint::caller};
}

Infeasible explain_too_large(double vertices, const PlanRequest& request) {
  return {.reason = Reason::too_large,
          .at = request.from,
          .when = request.depart,
          .why = messages::refusal<"grid-too-large">(vertices / 1e6),
          .binding = Constraint::memory};
}

Infeasible explain_too_many_icebergs(std::size_t icebergs, const PlanRequest& request) {
  return {.reason = Reason::too_large,
          .at = request.from,
          .when = request.depart,
          .why = messages::refusal<"too-many-icebergs">(icebergs),
          .binding = Constraint::memory};
}

Change move_of(const std::string& input, geo::LonLat from, geo::LonLat to) {
  const std::string stop = input == "from" ? "start"
                           : input == "to" ? "goal"
                                           : "via point " + std::to_string(std::stoi(input.substr(4)) + 1);
  const geo::GeodesicLine line = geo::geodesic_between(from, to);
  char text[128];
  std::snprintf(text, sizeof text, "move the %s %.1f km to the %s, to %.4f, %.4f", stop.c_str(),
                1e-3 * line.length.value, geo::compass_point(line.course_at_start).data(), to.lon_deg,
                to.lat_deg);
  return {.input = input, .from = from, .to = to, .text = text};
}

}  // namespace floeplan::planning::search
