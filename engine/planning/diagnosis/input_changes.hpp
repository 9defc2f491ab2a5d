#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/ocean/environment.hpp"
#include "engine/planning/diagnosis/input_trials.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::diagnosis {

/// The highest speed that is tried instead of `now`, for the vehicle or its thruster.
[[nodiscard]] core::MetresPerSecond fastest_tried(core::MetresPerSecond now);

struct FoundChanges {
  std::vector<Change> changes;  // the smallest change first
  bool cut_short{false};        // a trial gave no answer, so smaller or other changes may help, too
  std::optional<PlanRequest>
      changed{};  // the request with the first change; empty if a request cannot state it
};

/// Changes one input of a request at a time. Trials find the smallest change that makes the request possible.
/// Each function tries one input and keeps the change; it keeps nothing if no value helps or the input does
/// not apply.
/// Threads  one at a time
class InputChanges {
 public:
  /// All are borrowed and must outlive this object.
  InputChanges(const ocean::Environment& environment, const PlanRequest& request, const Trial& trial,
               const std::stop_token& stop)
      : environment_{environment}, request_{request}, trials_{trial, stop} {}

  void raise_speed();
  void raise_the_thrusters_speed();
  void use_the_thruster();
  void leave_the_thruster_off();

  void shrink_margin();
  /// Tries a lower limit on the position errors of icebergs (`max_inflation`).
  void allow_for_less_error();

  void stay_longer_under_ice();
  void keep_less_from_ice();

  void dive_deeper();
  /// Tries dives above zones that close only some depths. Other zones close all depths.
  void dive_less_deep();
  void keep_less_above_the_bed();
  void work_in_shallower_water();
  void climb_higher();
  /// Tries the profile of the same make for shallower water, with the values that the request states itself.
  void take_another_vehicle();

  void charge_the_battery();
  void take_a_larger_battery();

  /// Tries without one of the request's zones; if no single one helps, without all of them.
  void leave_out_zones();
  /// Tries without all stored zones at once: a request can name datasets, but not single zones in them.
  /// `without`  trial without the stored zones, on the same data; empty: not tried
  void leave_out_stored_zones(const Trial& without);

  void refine_the_grid();

  /// Tries later departures within the period of the data. Nearer ones come first: half a tide, then whole
  /// tides and days.
  void depart_later();
  /// Tries a departure at the first whole hour after a closure that ends `delay` later.
  void depart_after(core::Seconds delay);
  /// Tries holds of any length, if the request allows none or only short ones.
  void allow_holds();

  /// Takes over a move of a stop that is known to help.
  void take_move(const Change& move);

  [[nodiscard]] FoundChanges found() &&;

 private:
  struct Found {
    Change change;
    double effort;  // size of the change: 1 for none, 2 for twice the value or a day
    std::optional<PlanRequest> changed{};
  };

  /// The value nearest to `now` that helps, between `now` and `extreme`; `set(request, value)` writes it.
  template <class Set>
  std::optional<double> nearest(double now, double extreme, double unit, const Set& set);
  void dive_towards(double extreme);
  /// Whether the request is possible with this use of the thruster.
  bool helps_to_use_it(ThrusterUse use);
  /// The limit that the vehicle's profile sets: values below it are not proposed.
  [[nodiscard]] double standard_margin_m() const;
  [[nodiscard]] PlanRequest leaving(double hours_later) const;
  /// The least delay that helps, in whole hours: above `fails` and at most `helps`.
  double least_delay(double fails, double helps);
  /// Returns  whether leaving out one of the zones helps
  bool leave_out_a_zone();
  void leave_out_all_zones();
  void add_departure(double hours);
  /// The change of the last trial that found a route.
  void add(std::string input, Change::Value from, Change::Value to, double effort, std::string text);

  const ocean::Environment& environment_;
  const PlanRequest& request_;
  InputTrials trials_;
  std::vector<Found> found_{};
};

}  // namespace floeplan::planning::diagnosis
