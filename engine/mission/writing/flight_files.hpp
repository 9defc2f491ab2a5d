#pragma once

#include <string>
#include <vector>

#include "engine/mission/writing/mission_file.hpp"
#include "engine/mission/writing/mission_set_options.hpp"

namespace floeplan::mission {

/// A surfacing of the mission: what causes it, and its own argument file.
struct Surfacing {
  int number{};  // NN of surfacNN.ma
  std::string why;
};

/// Whether the mission surfaces at waypoints and after a time: wherever no rules for ice are given, and with them unless ice or
/// an iceberg forbids it somewhere on the route, for a mission knows no places.
[[nodiscard]] bool surfaces_on_the_way(const planning::Plan& plan, const MissionSetOptions& options);

/// The surfacings of a mission, in order of priority.
[[nodiscard]] std::vector<Surfacing> surfacings_of(const planning::Plan& plan,
                                                   const MissionSetOptions& options);

/// The depth that a yo turns at, so far above the rating that an overshoot does not reach it.
[[nodiscard]] core::Metres target_depth(const vehicle::GliderProfile& vehicle);

/// The depth at which the vehicle aborts: below the target by what a turn may overshoot, and no deeper than its rating.
[[nodiscard]] core::Metres overdepth(const vehicle::GliderProfile& vehicle);

/// The depth that a yo climbs to: below everything that the plan passes under, all the way, for a yo knows no places.
[[nodiscard]] core::Metres climb_target(const planning::Plan& plan, const vehicle::GliderProfile& vehicle);

/// How long the vehicle goes without contact before it comes up to seek it.
[[nodiscard]] core::Seconds longest_silence(const planning::Plan& plan, const MissionSetOptions& options);

/// How often a vehicle of this rating comes up in open water, unless a plan was asked to surface at another interval.
[[nodiscard]] core::Seconds usual_surfacing_interval(const vehicle::GliderProfile& vehicle);

/// How often the vehicle comes up in open water, whatever else happens.
[[nodiscard]] core::Seconds time_between_surfacings(const MissionSetOptions& options);

/// The lists of the set, its holds flown by the vehicle and the surfacings of the mission. The plan's route is one with fixes
/// where the vehicle may surface all along it.
[[nodiscard]] GotoListOptions list_options(const planning::Plan& plan, const MissionSetOptions& options);

/// The argument files of yo, surface, sample and prepare_to_dive.
[[nodiscard]] std::vector<MissionFile> flight_files(const planning::Plan& plan,
                                                    const MissionSetOptions& options);

}  // namespace floeplan::mission
