#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "api/codec/inputs/plan_inputs.hpp"
#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/mission/writing/mission_set.hpp"
#include "engine/mission/writing/seaglider_files.hpp"
#include "storage/repository/work/plan_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::service {

/// Which files of a plan to write. Common to API and command line.
struct MissionRequest {
  int number{10};            // number NN in the names of the first list and of all other files
  bool full{false};          // also mission, yo and other files, not only the lists
  std::string name{"plan"};  // name of the mission
  mission::Firmware firmware{};
  std::optional<mission::UnderIce> under_ice{};  // also requires the full set
  bool seaglider{false};                         // write the files of a Seaglider; only for these is:
  std::vector<mission::ScienceBand> bands{};
};

/// The mission files of a stored plan, within the limits of its vehicle and of the water depth along its
/// route in the newest data. `generated`: time for the comments in the files
/// Errors   all faults of plan or options, as in mission::write_mission_set, mission::write_seaglider_set,
///          mission::check_safe_places and mission::fly_by_yo
[[nodiscard]] tl::expected<mission::MissionFiles, core::Violations> mission_of(
    sql::Connection& db, const repository::PlanRecord& record, const MissionRequest& request,
    core::UtcTime generated);

/// The folder in which a shore station looks for files that a glider shall fetch: for a dockserver
/// "gliders/amadeus/to-glider/" below its data, for a Seaglider's base station the glider's home folder
/// "sg123/". Empty without a glider.
/// Source   the Slocum vendor's training material, folders of the shore server; iop-apl-uw/basestation3, folder sg000
/// Errors   a violation for a name that is not a plain folder name
[[nodiscard]] tl::expected<std::string, core::Violation> handover_folder(const std::string& glider,
                                                                         bool seaglider);

/// The version "10.5"; nullopt for any other text.
[[nodiscard]] std::optional<mission::Firmware> parse_firmware(const std::string& text);

}  // namespace floeplan::service
