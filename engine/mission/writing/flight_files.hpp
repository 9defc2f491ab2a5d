#pragma once

#include <string>
#include <vector>

#include "engine/mission/writing/mission_file.hpp"
#include "engine/mission/writing/mission_set_options.hpp"

namespace floeplan::mission {

/// A surfacing of the mission: its cause, and its own argument file.
struct Surfacing {
  int number{};  // NN of surfacNN.ma
  std::string why;
};

/// Whether the mission surfaces at waypoints and at intervals. Without rules for ice it always does. With
/// them it does not if ice or an iceberg forbids a surfacing anywhere on the route, because a mission knows
/// no places.
[[nodiscard]] bool surfaces_on_the_way(const planning::Plan& plan, const MissionSetOptions& options);

/// The surfacings of a mission, in order of priority.
[[nodiscard]] std::vector<Surfacing> surfacings_of(const planning::Plan& plan,
                                                   const MissionSetOptions& options);

/// Target depth of a yo: above the rating by as much as a dive may overshoot.
[[nodiscard]] core::Metres target_depth(const vehicle::GliderProfile& vehicle);

/// Depth at which the vehicle aborts: below the target by the overshoot of a turn, but at most its rating.
[[nodiscard]] core::Metres overdepth(const vehicle::GliderProfile& vehicle);

/// Upper turn of a yo: below everything that the plan passes under, on the whole route, because a yo is the
/// same everywhere.
[[nodiscard]] core::Metres climb_target(const planning::Plan& plan, const vehicle::GliderProfile& vehicle);

/// The time without contact after which the vehicle surfaces to make contact.
[[nodiscard]] core::Seconds longest_silence(const planning::Plan& plan, const MissionSetOptions& options);

/// Interval of surfacings in open water for a vehicle of this rating, unless the plan has its own interval.
[[nodiscard]] core::Seconds usual_surfacing_interval(const vehicle::GliderProfile& vehicle);

/// Interval of surfacings in open water, whatever other surfacings there are.
[[nodiscard]] core::Seconds time_between_surfacings(const MissionSetOptions& options);

/// Options for the goto lists of the set: `options.lists` with the vehicle and the surfacings of the holds.
/// If the vehicle may surface all along the route, the lists also have fixes on the way.
[[nodiscard]] GotoListOptions list_options(const planning::Plan& plan, const MissionSetOptions& options);

/// The argument files of yo, surface, sample and prepare_to_dive.
[[nodiscard]] std::vector<MissionFile> flight_files(const planning::Plan& plan,
                                                    const MissionSetOptions& options);

}  // namespace floeplan::mission
