#include "engine/mission/checking/ice_check.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "engine/core/letter_case.hpp"
#include "engine/messages/mission_check_messages.hpp"
#include "engine/mission/document/behavior_values.hpp"
#include "engine/mission/document/document_text.hpp"
#include "engine/mission/writing/below_ice.hpp"
#include "engine/mission/writing/list_parts.hpp"
#include "engine/mission/writing/waypoint_ranges.hpp"

namespace floeplan::mission {
namespace {

/// Files store places to a fifth of a metre and depths in whole metres. Smaller differences do not count.
constexpr core::Metres rounding{0.1};

/// The waypoints of the route that come from one document.
struct FlownList {
  std::size_t document{};
  ListPart part;
  core::Metres radius{};
  bool ends{};
};

/// The behavior to which a document's waypoints belong; null for the targets of a Seaglider.
const Behavior* steering_of(const Document& document) {
  const auto found = std::ranges::find_if(document.behaviors, [](const Behavior& behavior) {
    return behavior.name == "goto_list" || behavior.name == "goto_wpt";
  });
  return found == document.behaviors.end() ? nullptr : &*found;
}

FlownList flown_list(const std::vector<Document>& documents, std::size_t document, std::size_t waypoint) {
  FlownList list{.document = document, .part = {waypoint, waypoint}, .radius = {}, .ends = true};
  const Behavior* steering = steering_of(documents[document]);
  if (steering == nullptr) return list;
  const bool is_list = steering->name == "goto_list";
  const auto radius_m = value_of(*steering, is_list ? "list_when_wpt_dist" : "when_wpt_dist");
  list.radius = core::Metres{radius_m.value_or(0.0)};
  list.ends = !is_list || value_of(*steering, "num_legs_to_run") != -1.0;
  return list;
}

std::vector<FlownList> lists_of(const std::vector<Document>& documents, const TimedRoute& route) {
  std::vector<FlownList> lists;
  for (std::size_t i = 1; i < route.rows.size(); ++i) {
    const std::size_t document = route.rows[i]->document;
    if (lists.empty() || lists.back().document != document)
      lists.push_back(flown_list(documents, document, i));
    lists.back().part.last = i;
  }
  return lists;
}

struct SurfaceOrders {
  std::size_t document{};
  const Behavior* behavior{};
  int start_when{};
  core::Seconds interval{};
  core::Metres distance{};
};

/// Codes of `start_when` in the vendor's data dictionary of firmware 10.5.
enum StartWhen : int {
  when_secs = 6,
  when_waypoint_near = 7,
  when_waypoint_hit = 8,
  every_secs = 9,
  science_asks = 11,
  no_comms = 12,
  utc_time = 13,
  inflections = 16
};

std::vector<SurfaceOrders> surfacings_of(const std::vector<Document>& documents) {
  std::set<std::string> asked_for;
  bool has_mission = false;
  for (const Document& document : documents) {
    if (document.kind != DocumentKind::mission || document.verdict() == Verdict::reject) continue;
    has_mission = true;
    for (const std::string& name : files_referenced(document)) asked_for.insert(name);
  }
  std::vector<SurfaceOrders> found;
  for (std::size_t i = 0; i < documents.size(); ++i) {
    const Document& document = documents[i];
    if (document.verdict() == Verdict::reject) continue;
    if (has_mission && document.kind == DocumentKind::arguments &&
        !asked_for.contains(core::lower_case(document.name)))
      continue;
    for (const Behavior& behavior : document.behaviors) {
      if (behavior.name != "surface" || reads_file(behavior)) continue;
      const auto start_when = value_of(behavior, "start_when");
      if (!start_when) continue;
      found.push_back({.document = i,
                       .behavior = &behavior,
                       .start_when = static_cast<int>(*start_when),
                       .interval = core::Seconds{value_of(behavior, "when_secs").value_or(0.0)},
                       .distance = core::Metres{value_of(behavior, "when_wpt_dist").value_or(0.0)}});
    }
  }
  return found;
}

class IceCheck {
 public:
  IceCheck(std::vector<Document>& documents, const TimedRoute& route)
      : documents_{documents},
        route_{route},
        plan_{route.plan},
        lists_{lists_of(documents, route)},
        surfacings_{surfacings_of(documents)} {}

  void yo(const DiveArguments& dive) {
    for (std::size_t i = 1; i < plan_.waypoints.size(); ++i) {
      const core::Metres turn = needed_turn(i);
      if (turn <= dive.climb_to + rounding) continue;
      at_row(i,
             messages::mission_check_message<"ice_above_climb">(dive.climb_to.value, std::ceil(turn.value)));
    }
  }

  void ends_of_lists() {
    for (const FlownList& list : lists_) {
      if (!list.ends || documents_[list.document].kind == DocumentKind::targets) continue;
      const std::size_t last = list.part.last;
      if (overhead(plan_, last) == Overhead::closed) {
        at_row(last, messages::mission_check_message<"list_ends_below_ice">());
      } else if (overhead(plan_, last) == Overhead::unknown) {
        at_row(last, messages::mission_check_message<"list_end_unknown">());
      } else if (const auto end = end_of(plan_, list.part); end && end->sure_room() <= list.radius) {
        const bool is_sure_to = end->room() <= list.radius;
        const std::string room = text_of(*end, list.radius);
        at_row(last, is_sure_to ? messages::mission_check_message<"list_ends_near_ice">(room)
                                : messages::mission_check_message<"list_ends_near_ice/perhaps">(room));
      }
    }
  }

  void surfacings() {
    for (const SurfaceOrders& orders : surfacings_) {
      switch (orders.start_when) {
        case when_waypoint_hit: at_waypoints(orders, std::nullopt); break;
        case when_waypoint_near: at_waypoints(orders, orders.distance); break;
        case when_secs:
        case every_secs: after_a_time(orders); break;
        case no_comms: without_contact(orders); break;
        case science_asks:
        case utc_time:
        case inflections: at_any_time(orders); break;
        default: break;  // end of a list or yo: checked elsewhere
      }
    }
  }

  void targets() {
    for (const FlownList& list : lists_) {
      if (documents_[list.document].kind != DocumentKind::targets || !passes_below(plan_, list.part))
        continue;
      add(list.document, 0,
          messages::mission_check_message<"surfaces_below_ice/dive">(legs_below(list.part)));
    }
  }

  [[nodiscard]] bool is_clear() const { return is_clear_; }

 private:
  void add(std::size_t document, int line, const messages::Message& message) {
    is_clear_ = is_clear_ && !messages::is_grave(message);
    report(documents_[document], line, message);
  }

  void at_row(std::size_t waypoint, const messages::Message& message) {
    const FlightRoute::Stop& row = *route_.rows[waypoint];
    add(row.document, row.line, message);
  }

  void at_orders(const SurfaceOrders& orders, const messages::Message& message) {
    const Argument* start_when = orders.behavior->find("start_when");
    add(orders.document, start_when == nullptr ? orders.behavior->line : start_when->line, message);
  }

  /// The upper turn needed below ice or icebergs on the leg to the waypoint.
  [[nodiscard]] core::Metres needed_turn(std::size_t waypoint) const {
    const planning::SurfacingState& state = plan_.surfacing->waypoints[waypoint];
    core::Metres turn = std::max(state.least_upper_turn, state.leg_upper_turn.value_or(core::Metres{0.0}));
    for (const planning::PassedUnder& under : plan_.passed_under) {
      if (under.from <= plan_.waypoints[waypoint].eta && plan_.waypoints[waypoint - 1].eta <= under.until)
        turn = std::max(turn, under.keel.upper_turn);
    }
    return turn;
  }

  /// Text such as "legs 2 to 4 of the route", counted from 1.
  [[nodiscard]] std::string legs_below(const ListPart& part) const {
    return "legs " +
           waypoint_ranges(part.last + 1,
                           [&](std::size_t i) { return i >= part.first && passes_below(plan_, {i, i}); }) +
           " of the route";
  }

  [[nodiscard]] ListPart whole_way() const { return {1, plan_.waypoints.size() - 1}; }

  void at_waypoints(const SurfaceOrders& orders, std::optional<core::Metres> distance) {
    for (const FlownList& list : lists_) {
      const core::Metres radius = distance.value_or(list.radius);
      for (std::size_t i = list.part.first; i <= list.part.last; ++i) {
        const auto end = end_of(plan_, {i, i});
        const bool is_near = end && end->room() <= radius;
        if (overhead(plan_, i) != Overhead::closed && !is_near) continue;
        const std::string where = is_near && overhead(plan_, i) != Overhead::closed ? text_of(*end, radius)
                                                                                    : "below ice or icebergs";
        at_row(i, messages::mission_check_message<"surfaces_below_ice/waypoint">(
                      documents_[orders.document].name, where));
      }
    }
  }

  void after_a_time(const SurfaceOrders& orders) {
    if (!passes_below(plan_, whole_way())) return;
    at_orders(orders, messages::mission_check_message<"surfaces_below_ice/interval">(
                          orders.interval.count() / 3600.0, legs_below(whole_way())));
  }

  void at_any_time(const SurfaceOrders& orders) {
    if (!passes_below(plan_, whole_way())) return;
    at_orders(orders,
              messages::mission_check_message<"surfaces_below_ice/any-time">(legs_below(whole_way())));
  }

  /// Whether the files make the vehicle surface at the waypoint, and it may surface there.
  [[nodiscard]] bool has_contact_at(std::size_t waypoint) const {
    if (overhead(plan_, waypoint) != Overhead::open) return false;
    const bool hits = std::ranges::find(surfacings_, static_cast<int>(when_waypoint_hit),
                                        &SurfaceOrders::start_when) != surfacings_.end();
    return hits || std::ranges::any_of(lists_, [&](const FlownList& list) {
             return list.ends && list.part.last == waypoint;
           });
  }

  void without_contact(const SurfaceOrders& orders) {
    core::UtcTime contact = plan_.departure;
    core::Seconds longest{0.0};
    for (std::size_t i = 1; i < plan_.waypoints.size(); ++i) {
      const core::UtcTime arrival = plan_.waypoints[i].eta;
      if (passes_below(plan_, {i, i})) longest = std::max(longest, core::Seconds{arrival - contact});
      if (has_contact_at(i)) contact = arrival;
    }
    if (longest <= orders.interval) return;
    at_orders(orders,
              messages::mission_check_message<"surfaces_below_ice/no-contact">(
                  orders.interval.count() / 3600.0, longest.count() / 3600.0, legs_below(whole_way())));
  }

  std::vector<Document>& documents_;
  const TimedRoute& route_;
  const planning::Plan& plan_;
  std::vector<FlownList> lists_;
  std::vector<SurfaceOrders> surfacings_;
  bool is_clear_{true};
};

}  // namespace

bool check_below_ice(std::vector<Document>& documents, const TimedRoute& route,
                     const std::optional<DiveArguments>& dive) {
  if (!route.plan.surfacing) return true;
  IceCheck check{documents, route};
  if (dive) check.yo(*dive);
  check.ends_of_lists();
  check.surfacings();
  check.targets();
  return check.is_clear();
}

}  // namespace floeplan::mission
