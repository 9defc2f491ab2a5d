#include "engine/planning/relaxation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "engine/core/utc_text.hpp"
#include "engine/geo/geodesic.hpp"

namespace floeplan::planning {
namespace {

constexpr double fastest_m_s = 5.0;  // the most that a request may ask for

std::string written(const char* format, double from, double to) {
  char text[120];
  std::snprintf(text, sizeof text, format, from, to);
  return text;
}

/// Carries the request and what may be asked of it through the search for changes.
class Relaxation {
 public:
  Relaxation(const ocean::Environment& environment, const PlanRequest& request, const Trial& trial,
             const std::stop_token& stop)
      : environment_{environment}, request_{request}, trials_{trial, stop} {}

  void raise_speed() {
    const double now = request_.vehicle.speed_through_water.value;
    const auto with = [&](double speed) {
      PlanRequest changed = request_;
      changed.vehicle.speed_through_water = {speed};
      return changed;
    };
    const auto needed = trials_.nearest_that_helps(now, std::min(fastest_m_s, 8.0 * now), 0.01, with);
    if (!needed) return;
    add("speed_m_s", now, *needed, *needed / now,
        written("raise the speed through the water from %.2f to %.2f m/s", now, *needed));
  }

  void raise_the_thrusters_speed() {
    if (drives(request_.energy, request_.vehicle).back() != vehicle::Drive::thruster) return;
    const double now = request_.vehicle.thruster->speed.value;
    const auto with = [&](double speed) {
      PlanRequest changed = request_;
      changed.vehicle.thruster =
          vehicle::Thruster{.speed = {speed}, .power = vehicle::thruster_power({speed})};
      return changed;
    };
    const auto needed = trials_.nearest_that_helps(now, std::min(fastest_m_s, 8.0 * now), 0.01, with);
    if (!needed) return;
    add("vehicle/thruster/speed_m_s", now, *needed, *needed / now,
        written("raise the thruster's speed from %.2f to %.2f m/s", now, *needed));
  }

  void shrink_margin() {
    const double now = request_.icebergs.margin.value;
    const auto with = [&](double margin) {
      PlanRequest changed = request_;
      changed.icebergs.margin = {margin};
      return changed;
    };
    const auto needed = trials_.nearest_that_helps(now, 0.0, 10.0, with);
    if (!needed) return;
    add("margin_m", now, *needed, 2.0 - *needed / now,
        written("reduce the margin around icebergs from %.0f to %.0f m", now, *needed));
  }

  void allow_for_less_error() {
    if (!request_.icebergs.drift) return;
    const double now = request_.icebergs.max_inflation.value;
    const auto with = [&](double error) {
      PlanRequest changed = request_;
      changed.icebergs.max_inflation = {error};
      return changed;
    };
    const auto needed = trials_.nearest_that_helps(now, 0.0, 100.0, with);
    if (!needed) return;
    add("max_inflation_m", now, *needed, 2.0 - *needed / now,
        written("reduce what is allowed for the error of icebergs' positions from %.0f to %.0f m", now,
                *needed));
  }

  /// Later departures within the period of the data, closer ones first: half a tide, then whole tides and days.
  /// Returns  by how much, where that helps
  std::optional<core::Seconds> depart_later() {
    trials_.begin_input();
    const bool currents_change = environment_.currents && !environment_.steady_currents;
    if (!currents_change && environment_.icebergs.empty()) return std::nullopt;
    const double end_s = currents_change ? environment_.currents->times_s().back() : INFINITY;
    double too_early = 0.0;
    for (const double hours : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 9.0, 12.0, 18.0, 24.0, 48.0}) {
      const core::UtcTime later = request_.depart + hours * an_hour;
      if (trials_.is_over() || core::unix_seconds(later) >= end_s) return std::nullopt;
      if (!trials_.works(leaving(hours))) {
        too_early = hours;
        continue;
      }
      return add_departure(least_delay(too_early, hours));
    }
    return std::nullopt;
  }

  /// What closes for a while is past for who departs later, and for who waits as long.
  void depart_later_or_wait() {
    if (const auto delay = depart_later()) wait_for(*delay);
  }

  /// The departure after which nothing has to be circled away, and the first one that may be flown.
  void depart_after(core::Seconds circling) {
    const auto delays =
        trials_.shortest_that_helps(circling, [&](core::Seconds later) { return leaving(later / an_hour); });
    if (!delays) return;
    if (delays->least < delays->enough)
      add_departure(delays->least / an_hour, ", and turn in circles for the rest");
    add_departure(delays->enough / an_hour);
  }

  /// How long the vehicle, where a zone stopped the search for its way, is there before a zone ends; empty where none
  /// is known to.
  [[nodiscard]] std::optional<core::Seconds> until_a_zone_ends(const Infeasible& why) const {
    if (why.binding != Constraint::zone) return std::nullopt;
    std::optional<core::Seconds> soonest;
    for (const auto* zones : {&request_.zones, &environment_.zones}) {
      for (const ocean::Zone& zone : *zones) {
        if (!zone.until || *zone.until <= why.when) continue;
        const core::Seconds delay = *zone.until - why.when;
        soonest = std::min(soonest.value_or(delay), delay);
      }
    }
    return soonest;
  }

  void wait_for(core::Seconds circling) {
    const double now = request_.max_loiter.count();
    const auto waits = trials_.shortest_that_helps(circling, [&](core::Seconds longest) {
      PlanRequest changed = request_;
      changed.max_loiter = std::max(longest, request_.max_loiter);
      return changed;
    });
    if (!waits || waits->least <= request_.max_loiter) return;
    add("max_loiter_s", now, waits->least.count(), 1.0 + waits->least / a_day,
        written("let the vehicle wait for up to %.0f h at one place instead of %.4g h",
                waits->least / an_hour, now / an_hour.count()));
  }

  void move_goal(const Change& move) {
    trials_.begin_input();
    PlanRequest changed = request_;
    changed.to = std::get<geo::LonLat>(move.to);
    if (trials_.is_over() || !trials_.works(changed)) return;
    take_move(move);
  }

  /// A move of a stop that helps.
  void take_move(const Change& move) {
    const double way_m = std::max(1.0, geo::geodesic_between(request_.from, request_.to).length.value);
    const double moved_m =
        geo::geodesic_between(std::get<geo::LonLat>(move.from), std::get<geo::LonLat>(move.to)).length.value;
    found_.push_back({move, 1.0 + moved_m / way_m});
  }

  /// All of them at once: the inputs name datasets, not the zones in them.
  void leave_out_stored_zones(const Trial& without) {
    trials_.begin_input();
    if (environment_.zones.empty() || !without || trials_.is_over()) return;
    if (!trials_.works_by(without, request_)) return;
    const std::string& name = environment_.zones.front().name;
    const std::string more = environment_.zones.size() > 1
                                 ? " and " + std::to_string(environment_.zones.size() - 1) + " more"
                                 : std::string{};
    add("zones", name + more, std::string{"none"}, 3.0,
        "leave out the stored areas: \"" + name + "\"" + more);
  }

  void leave_out_a_zone() {
    trials_.begin_input();
    for (std::size_t i = 0; i < request_.zones.size() && i < most_zones; ++i) {
      PlanRequest changed = request_;
      changed.zones.erase(changed.zones.begin() + static_cast<std::ptrdiff_t>(i));
      if (trials_.is_over()) return;
      if (!trials_.works(changed)) continue;
      const std::string& name = request_.zones[i].name;
      add("areas/features/" + std::to_string(i), name, std::string{}, 2.0,
          "leave out the area " + (name.empty() ? "number " + std::to_string(i + 1) : "\"" + name + "\""));
    }
  }

  void stay_longer_under_ice() {
    if (!request_.under_ice.max_time_without_surfacing) return;
    const double now = request_.under_ice.max_time_without_surfacing->count();
    const auto with = [&](double time_s) {
      PlanRequest changed = request_;
      changed.under_ice.max_time_without_surfacing = core::Seconds{time_s};
      return changed;
    };
    const double longest = std::max(8.0 * now, two_days.count());
    const auto needed = trials_.nearest_that_helps(now, longest, 600.0, with);
    if (!needed) return;
    add("under_ice/max_time_without_surfacing_s", now, *needed, *needed / now,
        written("allow %.2f h without a place to surface instead of %.2f h", *needed / 3600.0, now / 3600.0));
  }

  void keep_less_from_ice() {
    const double now = request_.under_ice.margin_below_ice.value;
    const auto with = [&](double margin) {
      PlanRequest changed = request_;
      changed.under_ice.margin_below_ice = {margin};
      return changed;
    };
    const auto needed = trials_.nearest_that_helps(now, 0.0, 1.0, with);
    if (!needed) return;
    add("under_ice/margin_below_ice_m", now, *needed, 2.0 - *needed / now,
        written("reduce what is kept from the ice above from %.0f to %.0f m", now, *needed));
  }

  void dive_deeper() { dive_towards(request_.vehicle.depth_rating.value); }
  /// Above what zones at some depths only close; no other zone minds how deep the dives are.
  void dive_less_deep() {
    const auto has_depths = [](const ocean::Zone& zone) {
      return zone.top.value > 0.0 || std::isfinite(zone.bottom.value);
    };
    if (std::ranges::none_of(request_.zones, has_depths) &&
        std::ranges::none_of(environment_.zones, has_depths))
      return;
    dive_towards(std::ceil(request_.vehicle.climb_to.value + vehicle::lowest_tooth.value));
  }

  void keep_less_above_the_bed() {
    const double now = request_.vehicle.altimeter_margin.value;
    const double usual = standard_margin_m();
    if (now <= usual) return;
    const auto with = [&](double margin) {
      PlanRequest changed = request_;
      changed.vehicle.altimeter_margin = {margin};
      return changed;
    };
    const auto needed = trials_.nearest_that_helps(now, usual, 1.0, with);
    if (!needed) return;
    add("altimeter_margin_m", now, *needed, 2.0 - *needed / now,
        written("keep %.0f m above the sea bed instead of %.0f m", *needed, now));
  }

  void work_in_shallower_water() {
    const double now = request_.vehicle.minimum_working_depth.value;
    const auto profile = vehicle::find_profile(request_.vehicle.name);
    if (!profile || now <= profile->minimum_working_depth.value) return;
    const auto with = [&](double depth) {
      PlanRequest changed = request_;
      changed.vehicle.minimum_working_depth = {depth};
      return changed;
    };
    const auto needed = trials_.nearest_that_helps(now, profile->minimum_working_depth.value, 1.0, with);
    if (!needed) return;
    add("vehicle/minimum_working_depth_m", now, *needed, 2.0 - *needed / now,
        written("let the vehicle work in water of %.0f m instead of %.0f m", *needed, now));
  }

  void charge_the_battery() {
    const double now = request_.vehicle.energy.battery_start_share;
    const auto with = [&](double share) {
      PlanRequest changed = request_;
      changed.vehicle.energy.battery_start_share = share;
      return changed;
    };
    const auto needed = trials_.nearest_that_helps(now, 1.0, 0.01, with);
    if (!needed) return;
    add("battery_start_share", now, *needed, *needed / now,
        written("start with %.3g %% of the battery's charge instead of %.3g %%", 100.0 * *needed,
                100.0 * now));
  }

  void take_a_larger_battery() {
    const double now = request_.vehicle.energy.battery.value;
    const auto with = [&](double battery_j) {
      PlanRequest changed = request_;
      changed.vehicle.energy.battery = {battery_j};
      return changed;
    };
    const double three_digits = std::pow(10.0, std::floor(std::log10(now)) - 2.0);
    const auto needed = trials_.nearest_that_helps(now, 8.0 * now, three_digits, with);
    if (!needed) return;
    add("battery_j", now, *needed, 1.0 + *needed / now,
        written("take a battery of %.4g MJ instead of %.4g MJ", *needed / 1e6, now / 1e6));
  }

  void use_the_thruster() {
    trials_.begin_input();
    if (!request_.vehicle.thruster || request_.energy.thruster != ThrusterUse::off) return;
    PlanRequest changed = request_;
    changed.energy.thruster = ThrusterUse::automatic;
    if (trials_.is_over() || !trials_.works(changed)) return;
    add("thruster", thruster_use_name(ThrusterUse::off), thruster_use_name(ThrusterUse::automatic), 1.5,
        "let the vehicle use its thruster");
  }

  void leave_the_thruster_off() {
    trials_.begin_input();
    if (!request_.vehicle.thruster || request_.energy.thruster == ThrusterUse::off) return;
    PlanRequest changed = request_;
    changed.energy.thruster = ThrusterUse::off;
    if (trials_.is_over() || !trials_.works(changed)) return;
    add("thruster", thruster_use_name(request_.energy.thruster), thruster_use_name(ThrusterUse::off), 2.0,
        "leave the thruster off");
  }

  void refine_the_grid() {
    if (!request_.spacing_along) return;
    const double now = request_.spacing_along->value;
    for (const double share : {0.5, 0.25}) {
      // Of few and very long steps a finer grid, which covers less, may take less work.
      trials_.begin_input();
      PlanRequest changed = request_;
      changed.spacing_along = core::Metres{share * now};
      if (request_.spacing_across)
        changed.spacing_across = core::Metres{share * request_.spacing_across->value};
      if (trials_.is_over() || !changed.violations().empty()) return;
      if (!trials_.works(changed)) continue;
      if (request_.spacing_across) {
        const double across = request_.spacing_across->value;
        add("spacing_m", std::array{now, across}, std::array{share * now, share * across}, 1.0 / share,
            written("search on a grid of %.0f by %.0f m", share * now, share * across) +
                written(" instead of %.0f by %.0f m", now, across));
        return;
      }
      add("spacing_m", now, share * now, 1.0 / share,
          written("search on a grid of %.0f m instead of %.0f m", share * now, now));
      return;
    }
  }

  [[nodiscard]] FoundChanges changes() && {
    std::ranges::stable_sort(found_, {}, &Found::effort);
    FoundChanges result{.changes = {}, .cut_short = trials_.told_too_little()};
    for (Found& found : found_) result.changes.push_back(std::move(found.change));
    return result;
  }

 private:
  [[nodiscard]] PlanRequest leaving(double hours_later) const {
    PlanRequest changed = request_;
    changed.depart = request_.depart + hours_later * an_hour;
    return changed;
  }

  /// In whole hours, above `fails` and up to `helps`.
  double least_delay(double fails, double helps) {
    while (helps - fails > 1.0 && !trials_.is_over()) {
      const double middle = std::floor(0.5 * (fails + helps));
      (trials_.works(leaving(middle)) ? helps : fails) = middle;
    }
    return helps;
  }

  core::Seconds add_departure(double hours, const std::string& note = {}) {
    const core::UtcTime later = request_.depart + hours * an_hour;
    add("depart", request_.depart, later, 1.0 + hours / 24.0,
        "depart " + written("%.0f h later, at ", hours, 0.0) + core::iso8601(later) + note);
    return hours * an_hour;
  }

  static constexpr std::size_t most_zones = 10;
  static constexpr core::Seconds an_hour{3600.0};
  static constexpr core::Seconds a_day{86'400.0};
  static constexpr core::Seconds two_days{172'800.0};  // as far as later departures are tried

  struct Found {
    Change change;
    double effort;  // how much is asked: 1 for nothing, 2 for twice the value or a day
  };

  void dive_towards(double extreme) {
    const double now = request_.vehicle.dive_depth.value;
    const auto with = [&](double depth) {
      PlanRequest changed = request_;
      changed.vehicle.dive_depth = {depth};
      return changed;
    };
    const auto needed = trials_.nearest_that_helps(now, extreme, 1.0, with);
    if (!needed) return;
    add("dive_depth_m", now, *needed, *needed > now ? *needed / now : 2.0 - *needed / now,
        written("dive to %.0f m instead of %.0f m", *needed, now));
  }

  /// What the vehicle's profile keeps: less is nothing to propose.
  [[nodiscard]] double standard_margin_m() const {
    const auto profile = vehicle::find_profile(request_.vehicle.name);
    return profile ? profile->altimeter_margin.value : request_.vehicle.altimeter_margin.value;
  }

  void add(std::string input, Change::Value from, Change::Value to, double effort, std::string text) {
    found_.push_back({{std::move(input), std::move(from), std::move(to), std::move(text)}, effort});
  }

  const ocean::Environment& environment_;
  const PlanRequest& request_;
  InputTrials trials_;
  std::vector<Found> found_;
};

}  // namespace

geo::LonLat& stop_named(PlanRequest& request, const std::string& input) {
  if (input == "from") return request.from;
  if (input == "to") return request.to;
  return request.via.at(std::stoul(input.substr(input.find('/') + 1)));
}

FoundChanges find_changes(const ocean::Environment& environment, const PlanRequest& request,
                          const Infeasible& why, const Trial& trial, const std::stop_token& stop,
                          const Trial& without_stored_zones) {
  Relaxation relaxation{environment, request, trial, stop};
  const auto delay = why.postponed ? std::optional{why.postponed->by} : relaxation.until_a_zone_ends(why);
  if (delay) {
    relaxation.depart_after(*delay);
    relaxation.wait_for(*delay);
  }
  if (why.postponed && why.postponed->move) relaxation.move_goal(*why.postponed->move);
  const bool at_a_stop = !why.moves.empty();
  for (const Change& move : why.changes) relaxation.take_move(move);
  switch (why.binding) {
    case Constraint::current:
      relaxation.use_the_thruster();
      relaxation.raise_speed();
      relaxation.raise_the_thrusters_speed();
      relaxation.depart_later();
      break;
    case Constraint::data_period:
      relaxation.use_the_thruster();
      relaxation.raise_speed();
      relaxation.raise_the_thrusters_speed();
      break;
    case Constraint::iceberg:
      relaxation.shrink_margin();
      relaxation.allow_for_less_error();
      if (request.icebergs.pass_under) relaxation.dive_deeper();
      if (!at_a_stop) relaxation.refine_the_grid();
      if (!why.postponed) relaxation.depart_later_or_wait();
      break;
    case Constraint::ice:
      relaxation.stay_longer_under_ice();
      relaxation.keep_less_from_ice();
      relaxation.dive_deeper();
      relaxation.keep_less_above_the_bed();
      relaxation.depart_later();
      break;
    case Constraint::zone:
      relaxation.leave_out_a_zone();
      relaxation.leave_out_stored_zones(without_stored_zones);
      relaxation.dive_less_deep();
      if (!at_a_stop) relaxation.refine_the_grid();
      break;
    case Constraint::depth:
      relaxation.keep_less_above_the_bed();
      relaxation.work_in_shallower_water();
      if (!at_a_stop) relaxation.refine_the_grid();
      break;
    case Constraint::land:
      if (!at_a_stop) relaxation.refine_the_grid();
      break;
    case Constraint::battery:
      relaxation.charge_the_battery();
      relaxation.leave_the_thruster_off();
      relaxation.take_a_larger_battery();
      break;
    case Constraint::data_area:
      if (!at_a_stop) relaxation.depart_later();
      break;
    case Constraint::memory:
    case Constraint::caller: break;
  }
  return std::move(relaxation).changes();
}

}  // namespace floeplan::planning
