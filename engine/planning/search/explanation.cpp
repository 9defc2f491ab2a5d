#include "engine/planning/search/explanation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "engine/core/utc_text.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/planning/cost/usable_place.hpp"
#include "engine/planning/search/waiting/late_openings.hpp"

namespace floeplan::planning::search {
namespace {

std::string speed_text(const PlanRequest& request) {
  char text[32];
  const vehicle::Drive fastest = drives(request.energy, request.vehicle).back();
  std::snprintf(text, sizeof text, "%.2f m/s", drive_speed(request.vehicle, fastest).value);
  return text;
}

std::string metres_text(core::Metres length) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f m", length.value);
  return text;
}

std::string hours_text(core::Seconds time) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g h", time.count() / 3600.0);
  return text;
}

core::UtcTime clock(const PlanRequest& request, core::Seconds since_departure) {
  return request.depart + since_departure;
}

/// Words for a closed leg: what is the matter and what would help.
struct Words {
  Reason reason;
  std::string explanation;
  std::string suggestion;
};

/// "iceberg 57 at 2026-11-21T05:12:00Z (800 m from its hull, where 500 m of margin and ... are kept)".
std::string iceberg_text(const cost::Sea& sea, geo::PlanePoint place, core::Seconds when,
                         const PlanRequest& request) {
  const auto berg = sea.icebergs().nearest(place, when);
  if (!berg) return "an iceberg";
  const core::Metres error = berg->kept_off - request.icebergs.margin;
  std::string text = berg->name.empty() ? "an iceberg without a name" : "iceberg " + berg->name;
  text += " at " + core::iso8601(clock(request, when)) + ", from whose hull " +
          metres_text(request.icebergs.margin) + " of margin";
  if (error.value >= 1.0) text += " and " + metres_text(error) + " for the error of its position";
  return text + " are kept";
}

/// Of the times when a place is closed, the one that holds then.
std::optional<TimeSpan> closure_at(const std::vector<TimeSpan>& times, core::Seconds when) {
  for (const TimeSpan& closed : times)
    if (closed.from <= when && when <= closed.until) return closed;
  return std::nullopt;
}

/// Until when a place is closed that is closed then.
std::string opening_text(const std::vector<TimeSpan>& times, core::Seconds when, const PlanRequest& request) {
  const auto closed = closure_at(times, when);
  if (!closed) return "";
  if (!std::isfinite(closed->until.count())) return ", as far as is forecast for good";
  return ", until " + core::iso8601(clock(request, closed->until));
}

Words words_for(motion::EdgeClosed closed, const cost::Sea& sea, const PlanRequest& request, bool out_of_time,
                geo::PlanePoint at, core::Seconds when) {
  switch (closed) {
    case motion::EdgeClosed::current_too_strong:
      return {Reason::current_too_strong,
              "the current here is too strong for " + speed_text(request) + " through the water",
              "depart at another time, raise the speed, or choose a way with weaker current"};
    case motion::EdgeClosed::outside_data: {
      const auto end = sea.currents() ? sea.currents()->end() : std::nullopt;
      if (end && out_of_time) {
        return {
            Reason::outside_data,
            "the stored currents end at " + core::iso8601(clock(request, *end)) + ", before the route does",
            "depart earlier, ingest a longer forecast, or hold the currents steady (--steady)"};
      }
      return {Reason::outside_data, "the stored data do not cover this place, or not at this time",
              "ingest data that cover it, or leave the kind of data out (for example --currents none)"};
    }
    case motion::EdgeClosed::too_shallow:
      return {Reason::too_shallow,
              "the water is shallower than the vehicle's minimum of " +
                  metres_text(request.vehicle.least_water()),
              "go round it, or choose a vehicle for shallower water"};
    case motion::EdgeClosed::on_land: return {Reason::too_shallow, "the way crosses land", "go round it"};
    case motion::EdgeClosed::in_zone:
      return {Reason::in_zone, "the way breaks the rule of a zone",
              "go round it, or change the zone or its times"};
    case motion::EdgeClosed::under_ice:
      return {Reason::under_ice,
              "the vehicle cannot pass below the ice: there is no room of " +
                  metres_text(request.vehicle.least_water_below_turn()) +
                  " between the sea bed and the turn it must make " +
                  metres_text(request.under_ice.margin_below_ice) +
                  " below the deepest keel, or its dives do not reach that deep",
              "dive deeper (--dive-depth), go round it, or change what is kept from the ice (under_ice)"};
    case motion::EdgeClosed::no_surfacing:
      return {Reason::no_surfacing,
              "the vehicle would be longer than " +
                  hours_text(*request.under_ice.max_time_without_surfacing) +
                  " without a place where it may surface",
              "allow more time (--max-time-without-surfacing) or denser ice to surface in "
              "(--max-concentration-to-surface), or depart at another time"};
    case motion::EdgeClosed::too_late:
    case motion::EdgeClosed::obstacle:
      return {
          Reason::near_iceberg, "the way comes too close to " + iceberg_text(sea, at, when, request),
          "go round it, depart at another time, or reduce the margin (--margin) or the error that is allowed "
          "for (--max-inflation)"};
  }
  return {Reason::goal_unreachable, "", ""};
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

/// The reason by the kind of stop: start, via, goal.
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
    case Stop::via: return "a place to visit on the way";
    case Stop::goal: return "the goal";
  }
  throw std::logic_error{"Stop without a name"};
}

Infeasible words_for_place(motion::EdgeClosed closed, Stop stop, geo::LonLat place, core::Seconds when,
                           const cost::Sea& sea, const PlanRequest& request) {
  const std::string subject = subject_of(stop);
  const geo::PlanePoint point = sea.projection().to_plane(place);
  switch (closed) {
    case motion::EdgeClosed::on_land:
      return {reason_at(stop, Reason::start_on_land, Reason::too_shallow, Reason::goal_on_land), place,
              request.depart, subject + " lies on land in the stored bathymetry or coastline",
              "move it into the water; longitude comes first"};
    case motion::EdgeClosed::too_shallow:
      return {reason_at(stop, Reason::start_too_shallow, Reason::too_shallow, Reason::goal_too_shallow),
              place, request.depart,
              subject + " lies in water shallower than the vehicle's minimum of " +
                  metres_text(request.vehicle.least_water()),
              "move it into deeper water, or choose a vehicle for shallower water"};
    case motion::EdgeClosed::in_zone:
      return {reason_at(stop, Reason::start_in_zone, Reason::in_zone, Reason::goal_in_zone), place,
              clock(request, when),
              subject + " lies where a zone does not allow the vehicle to be" +
                  opening_text(sea.closed_times_by_zones(point), when, request),
              "move it, change the zone or its times, or depart when it allows the vehicle to be there"};
    case motion::EdgeClosed::obstacle:
      return {
          reason_at(stop, Reason::start_near_iceberg, Reason::near_iceberg, Reason::goal_near_iceberg), place,
          clock(request, when),
          subject + " lies too close to " + iceberg_text(sea, point, when, request) +
              opening_text(sea.closed_times(point), when, request),
          "move it, depart at another time, or reduce the margin (--margin) or the error that is allowed for "
          "(--max-inflation)"};
    case motion::EdgeClosed::outside_data:
    case motion::EdgeClosed::under_ice:
    case motion::EdgeClosed::no_surfacing:
    case motion::EdgeClosed::too_late:
    case motion::EdgeClosed::current_too_strong: break;
  }
  return {Reason::outside_data, place, request.depart, subject + " lies outside the stored data",
          "ingest data that cover it, or leave the kind of data out (for example --bathymetry none)"};
}

/// How a search that found no way may be made to find one, as the end of a sentence.
const char* what_helps_a_search(motion::EdgeClosed binding, bool cut_short) {
  if (cut_short) return "; a coarser grid (--spacing) needs less memory";
  if (binding == motion::EdgeClosed::current_too_strong)
    return "; a place to pass (--via) has ways looked for further round";
  return "; a finer grid (--spacing) finds narrower passages";
}

}  // namespace

Infeasible explain_place(motion::EdgeClosed closed, Stop stop, geo::LonLat place, const cost::Sea& sea,
                         const PlanRequest& request) {
  Infeasible infeasible = words_for_place(closed, stop, place, core::Seconds{0.0}, sea, request);
  infeasible.binding = constraint_of(closed, false);
  return infeasible;
}

Infeasible explain_start(motion::EdgeClosed closed, geo::LonLat place, core::Seconds after,
                         const cost::Sea& sea, const PlanRequest& request) {
  Infeasible infeasible = words_for_place(closed, Stop::start, place, after, sea, request);
  infeasible.binding = constraint_of(closed, false);
  const auto closure = closure_at(sea.closed_times(sea.projection().to_plane(place)), after);
  if (closure && std::isfinite(closure->until.count()))
    infeasible.postponed = Postponed{closure->until - after};
  return infeasible;
}

Infeasible explain_route(const cost::RouteClosed& closed, const cost::Sea& sea, const PlanRequest& request) {
  Words words = words_for(closed.reason, sea, request, closed.out_of_time, closed.at, closed.when);
  return {words.reason,
          sea.projection().to_lon_lat(closed.at),
          clock(request, closed.when),
          std::move(words.explanation),
          std::move(words.suggestion),
          constraint_of(closed.reason, closed.out_of_time)};
}

Infeasible explain_search(const RouteSearch& search, const cost::Sea& sea, const PlanRequest& request) {
  if (const auto& opening = search.statistics.worst_fifo_violation; opening && !opening->gain) {
    return {Reason::current_too_strong,
            opening->place,
            opening->refused,
            "no way was found to the goal: " + message_of(*opening).text,
            std::string{"depart later, "} +
                (sea.longest_wait().count() > 0.0 ? "let the vehicle wait longer" : "let the vehicle wait") +
                " (--max-loiter), or have the departure searched in a window (--depart-until)",
            Constraint::current};
  }
  // What closes most of the ways onward from the place nearest to the goal binds there; equal counts: the
  // first kind.
  using enum motion::EdgeClosed;
  // Where each of them is open by itself, it is the time without a surfacing that ran out before their ends.
  motion::EdgeClosed binding = sea.overhead().bounds_surfacing() ? no_surfacing : on_land;
  std::ptrdiff_t most = 0;
  for (const motion::EdgeClosed kind :
       {outside_data, current_too_strong, no_surfacing, under_ice, too_shallow, on_land, in_zone, obstacle}) {
    const auto count = std::ranges::count(search.closed_at_nearest, kind);
    if (count > most) {
      most = count;
      binding = kind;
    }
  }
  Words words = words_for(binding, sea, request, search.out_of_time, search.nearest, search.nearest_arrival);
  if (search.statistics.cut_short) words.explanation += cut_short_note;
  const bool by_data = binding == outside_data || binding == current_too_strong || binding == under_ice ||
                       binding == no_surfacing;
  return {.reason = by_data ? words.reason : Reason::goal_unreachable,
          .at = sea.projection().to_lon_lat(search.nearest),
          .when = clock(request, search.nearest_arrival),
          .explanation =
              "no way was found to the goal; the nearest place reached is marked, where " + words.explanation,
          .suggestion = words.suggestion + what_helps_a_search(binding, search.statistics.cut_short),
          .binding = constraint_of(binding, search.out_of_time),
          .search_cut_short = search.statistics.cut_short};
}

Infeasible explain_removable(Infeasible why, Constraint constraint) {
  why.reason = Reason::goal_unreachable;
  why.binding = constraint;
  const auto say = [&](const char* without, const char* suggestion) {
    why.explanation += std::string{"; without "} + without + " there would be a way";
    why.suggestion = suggestion;
    return std::move(why);
  };
  switch (constraint) {
    case Constraint::iceberg:
      return say("icebergs",
                 "depart at another time, or reduce the margin (--margin) or the error that is allowed for "
                 "(--max-inflation)");
    case Constraint::zone: return say("zones", "change the zones or their times");
    case Constraint::ice:
      return say("ice", "dive deeper (--dive-depth), or change what is kept from the ice (under_ice)");
    case Constraint::current: return say("currents", "depart at another time, or raise the speed");
    default: throw std::invalid_argument{"this constraint cannot be taken away"};
  }
}

Infeasible explain_circling(const OpensLater& opens_later, Stop kind, geo::PlanePoint stop,
                            const cost::Sea& sea, const PlanRequest& request) {
  const cost::RouteClosed& closed = opens_later.closed;
  const bool in_zone = closed.reason == motion::EdgeClosed::in_zone || sea.icebergs().empty();
  const std::vector<TimeSpan> closures =
      in_zone ? sea.closed_times_by_zones(stop) : sea.closed_times_by_icebergs(stop);
  const auto at_stop = std::ranges::find_if(closures, [&](const TimeSpan& span) {
    return span.from <= closed.when + sea.least_time(closed.at, stop) && closed.when <= span.until;
  });
  const bool is_at_stop = at_stop != closures.end();
  const std::string what =
      in_zone
          ? "where a zone does not allow the vehicle to be at " + core::iso8601(clock(request, closed.when))
          : "too close to " + iceberg_text(sea, is_at_stop ? stop : closed.at, closed.when, request);
  std::string text = is_at_stop ? subject_of(kind) + " lies " + what : "the way leads " + what;
  if (is_at_stop && std::isfinite(at_stop->until.count()))
    text += ", until " + core::iso8601(clock(request, at_stop->until));
  text += "; the vehicle, which is there earlier, would have to turn in circles for " +
          hours_text(opens_later.circling);
  const Reason stop_reason =
      in_zone ? reason_at(kind, Reason::in_zone, Reason::in_zone, Reason::goal_in_zone)
              : reason_at(kind, Reason::near_iceberg, Reason::near_iceberg, Reason::goal_near_iceberg);
  Infeasible infeasible{
      is_at_stop ? stop_reason : Reason::goal_unreachable,
      sea.projection().to_lon_lat(is_at_stop ? stop : closed.at),
      clock(request, closed.when),
      std::move(text),
      std::string{"depart later, let the vehicle wait (--max-loiter), move the "} +
          (kind == Stop::goal ? "goal" : "place") +
          (in_zone ? ", or change the zone or its times"
                   : ", or reduce the margin (--margin) or the error that is allowed for (--max-inflation)"),
      constraint_of(closed.reason, closed.out_of_time)};
  infeasible.postponed = Postponed{.by = opens_later.circling};
  if (!is_at_stop || kind != Stop::goal) return infeasible;
  if (const auto place = cost::nearest_usable_place(sea, stop, closed.when))
    infeasible.postponed->move = move_of("to", request.to, *place);
  return infeasible;
}

Infeasible explain_no_escape(const cost::Sea& sea, const PlanRequest& request, geo::PlanePoint place,
                             core::Seconds when) {
  const auto bound = request.under_ice.max_time_without_surfacing;
  return {Reason::no_escape,
          sea.projection().to_lon_lat(place),
          clock(request, when),
          "from this waypoint no way leads to a place where the vehicle may surface" +
              (bound ? " before it has been " + hours_text(*bound) + " without one" : std::string{}) +
              ", within 200 steps of the grid",
          std::string{"allow "} + (bound ? "more time (--max-time-without-surfacing) or " : "") +
              "denser ice to surface in (--max-concentration-to-surface), choose a wider spacing, or plan "
              "without --escape-plan",
          Constraint::ice};
}

Infeasible explain_cancelled(const PlanRequest& request) {
  return {Reason::cancelled,          request.from,     request.depart,
          "the search was cancelled", "start it again", Constraint::caller};
}

Infeasible explain_too_large(double vertices, const PlanRequest& request) {
  char text[96];
  std::snprintf(text, sizeof text,
                "the grid would have %.0f million vertices, more than memory is set aside for",
                vertices / 1e6);
  return {Reason::too_large, request.from, request.depart, text, "choose a wider spacing or plan in parts",
          Constraint::memory};
}

Infeasible explain_too_many_icebergs(std::size_t icebergs, const PlanRequest& request) {
  return {Reason::too_large,
          request.from,
          request.depart,
          "the area holds " + std::to_string(icebergs) + " icebergs, more than are forecast at once",
          "plan in parts, or use younger sightings only (--max-sighting-age)",
          Constraint::memory};
}

Change move_of(const std::string& input, geo::LonLat from, geo::LonLat to) {
  char text[64];
  std::snprintf(text, sizeof text, "move it by %.1f km", 1e-3 * geo::geodesic_between(from, to).length.value);
  return {.input = input, .from = from, .to = to, .text = text};
}

}  // namespace floeplan::planning::search
