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

/// As far as a higher speed than `now` is tried, of the vehicle or of its thruster.
[[nodiscard]] core::MetresPerSecond fastest_tried(core::MetresPerSecond now);

struct FoundChanges {
  std::vector<Change> changes;           // the one that asks least first
  bool cut_short{false};                 // some trial told nothing: smaller changes, or others, may help, too
  std::optional<PlanRequest> changed{};  // by the first of them; empty where no request says it
};

/// Changes one input of a request at a time and keeps the least change of it, by trials, that makes the request
/// possible. Each function tries one input, and keeps nothing where no value of it helps or it does not apply.
/// Threads  one at a time
class InputChanges {
 public:
  /// All are borrowed and outlive this.
  InputChanges(const ocean::Environment& environment, const PlanRequest& request, const Trial& trial,
               const std::stop_token& stop)
      : environment_{environment}, request_{request}, trials_{trial, stop} {}

  void raise_speed();
  void raise_the_thrusters_speed();
  void use_the_thruster();
  void leave_the_thruster_off();

  void shrink_margin();
  /// Of icebergs' positions.
  void allow_for_less_error();

  void stay_longer_under_ice();
  void keep_less_from_ice();

  void dive_deeper();
  /// Above what zones at some depths only close; no other zone minds how deep the dives are.
  void dive_less_deep();
  void keep_less_above_the_bed();
  void work_in_shallower_water();
  void climb_higher();
  /// For shallower water, of the same make, with what was asked for whatever the vehicle.
  void take_another_vehicle();

  void charge_the_battery();
  void take_a_larger_battery();

  /// One of the request's; where none of them helps alone, all of them.
  void leave_out_zones();
  /// All of them at once: the inputs name datasets, not the zones in them.
  /// `without`  tells of the request in the same sea without the environment's zones; empty: not tried
  void leave_out_stored_zones(const Trial& without);

  void refine_the_grid();

  /// Within the period of the data, closer ones first: half a tide, then whole tides and days.
  void depart_later();
  /// The first whole hour after what closes the way for so long.
  void depart_after(core::Seconds delay);
  /// Of any length, where the request allows none or short ones only.
  void allow_holds();

  /// A move of a stop that helps, as was tried before.
  void take_move(const Change& move);

  [[nodiscard]] FoundChanges found() &&;

 private:
  struct Found {
    Change change;
    double effort;  // how much is asked: 1 for nothing, 2 for twice the value or a day
    std::optional<PlanRequest> changed{};
  };

  /// The value nearest to `now` that helps, on the way to `extreme`; `set(request, value)` writes it.
  template <class Set>
  std::optional<double> nearest(double now, double extreme, double unit, const Set& set);
  void dive_towards(double extreme);
  /// Whether the thruster so used makes the request possible.
  bool helps_to_use_it(ThrusterUse use);
  /// What the vehicle's profile keeps: less is nothing to propose.
  [[nodiscard]] double standard_margin_m() const;
  [[nodiscard]] PlanRequest leaving(double hours_later) const;
  /// In whole hours, above `fails` and up to `helps`.
  double least_delay(double fails, double helps);
  /// Returns  whether that helps with any of them
  bool leave_out_a_zone();
  void leave_out_all_zones();
  void add_departure(double hours);
  /// A change by which the last trial that found a way was made.
  void add(std::string input, Change::Value from, Change::Value to, double effort, std::string text);

  const ocean::Environment& environment_;
  const PlanRequest& request_;
  InputTrials trials_;
  std::vector<Found> found_{};
};

}  // namespace floeplan::planning::diagnosis
