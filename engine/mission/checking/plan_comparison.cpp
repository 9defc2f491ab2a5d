#include "engine/mission/checking/plan_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/core/utc_text.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/messages/mission_check_messages.hpp"
#include "engine/mission/checking/flight_route.hpp"
#include "engine/mission/document/hold_order.hpp"
#include "engine/mission/document/printed_text.hpp"

namespace floeplan::mission {
namespace {

constexpr core::Seconds same_time{60.0};

double hours(core::Seconds time) { return time.count() / 3600.0; }

core::Metres apart(geo::LonLat a, geo::LonLat b) { return geo::geodesic_between(a, b).length; }

std::string span_of_waypoints(std::size_t first, std::size_t last) {
  return first == last ? print("waypoint %zu", first) : print("waypoints %zu to %zu", first, last);
}

/// Compares the lists with the plan, row by row.
class Comparison {
 public:
  Comparison(const planning::Plan& plan, const HoldOptions& holds)
      : plan_{plan}, holds_{holds}, is_held_(plan.waypoints.size(), false) {}

  void compare(Document& list) {
    if (const auto hold = hold_order(list)) return compare_hold(list, *hold);
    const geo::LonLat from = plan_.waypoints[next_ - 1].place;
    for (const WaypointRow& row : flown_waypoints(list, from).rows) compare_row(list, row);
  }

  /// Reports the plan's remaining waypoints as left out. `last`: the last of the lists.
  void finish(Document& last) {
    leave_out(last, 0, plan_.waypoints.size());
    for (std::size_t i = 0; i < plan_.waypoints.size(); ++i) {
      if (!is_held_at(plan_, i) || is_held_[i] || !hold_legs(hold_flight(plan_, i, holds_))) continue;
      differ(last, 0,
             messages::mission_check_message<"hold_missing">(hours(plan_.waypoints[i].wait), i, until(i)));
    }
    if (is_same_) report(last, 0, messages::mission_check_message<"as_planned">());
  }

 private:
  void differ(Document& list, int line, const messages::Message& difference) {
    is_same_ = false;
    report(list, line, difference);
  }

  /// Reports the plan's waypoints from the next one up to `end` as left out.
  void leave_out(Document& list, int line, std::size_t end) {
    if (next_ < end)
      differ(list, line,
             messages::mission_check_message<"waypoint_left_out">(span_of_waypoints(next_, end - 1)));
    next_ = std::max(next_, end);
  }

  void compare_row(Document& list, const WaypointRow& row) {
    for (std::size_t i = next_; i < plan_.waypoints.size(); ++i) {
      if (apart(plan_.waypoints[i].place, row.place) > same_waypoint) continue;
      leave_out(list, row.line, i);
      next_ = i + 1;
      return;
    }
    differ(list, row.line, messages::mission_check_message<"waypoint_not_in_plan">());
  }

  [[nodiscard]] std::string until(std::size_t waypoint) const {
    return core::iso8601(plan_.waypoints[waypoint].eta + plan_.waypoints[waypoint].wait);
  }

  void compare_hold(Document& list, const HoldOrder& hold) {
    const std::size_t at = next_ - 1;
    const planning::Waypoint& waypoint = plan_.waypoints[at];
    if (!is_held_at(plan_, at))
      return differ(list, 0, messages::mission_check_message<"hold_not_in_plan">(at));
    is_held_[at] = true;
    const core::Metres off = apart(waypoint.place, hold.place);
    const core::Metres farthest = off + 0.5 * hold.apart;
    if (farthest > holds_.radius + same_waypoint) {
      differ(list, 0,
             messages::mission_check_message<"hold_beyond_circle">(farthest.value, at, holds_.radius.value));
    }
    compare_times(list, hold, at);
  }

  void compare_times(Document& list, const HoldOrder& hold, std::size_t at) {
    const core::Seconds wait = plan_.waypoints[at].wait;
    if (hold.planned &&
        std::abs((hold.planned->until - (plan_.waypoints[at].eta + wait)).count()) > same_time.count()) {
      differ(list, 0,
             messages::mission_check_message<"hold_of_other_time">(core::iso8601(hold.planned->until),
                                                                   until(at)));
    }
    if (hold.legs < 0) return;
    const auto time =
        hold_time(hold_flight(plan_, at, holds_),
                  {.axis = hold.axis, .apart = hold.apart, .radius = hold.radius, .legs = hold.legs});
    if (time && std::abs(*time / wait - 1.0) <= same_hold) return;
    const std::string takes = time ? "about " + core::hours_minutes(*time) : std::string{"hours longer"};
    differ(list, 0, messages::mission_check_message<"hold_of_other_length">(hold.legs, takes, hours(wait)));
  }

  const planning::Plan& plan_;
  const HoldOptions& holds_;
  std::vector<bool> is_held_;
  std::size_t next_{1};  // next waypoint that no list has reached yet
  bool is_same_{true};
};

bool is_goto_list(const Document& document) {
  return document.kind == DocumentKind::arguments && document.verdict() != Verdict::reject &&
         document.behaviors.size() == 1 && document.behaviors.front().name == "goto_list" &&
         !is_recovery_list(document);
}

}  // namespace

void compare_with_plan(std::vector<Document>& documents, const planning::Plan& plan,
                       const HoldOptions& holds) {
  Comparison comparison{plan, holds};
  Document* last = nullptr;
  for (Document& document : documents) {
    if (!is_goto_list(document)) continue;
    comparison.compare(document);
    last = &document;
  }
  if (last == nullptr) return;
  comparison.finish(*last);
  for (Document& document : documents) std::ranges::stable_sort(document.messages, {}, &Message::line);
}

}  // namespace floeplan::mission
