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

/// Which files of a plan are wanted. One struct for API and command line.
struct MissionRequest {
  int number{10};            // NN of the first list and of all other files
  bool full{false};          // with mission, yo and so on, not the lists alone
  std::string name{"plan"};  // of the mission
  mission::Firmware firmware{};
  std::optional<mission::UnderIce> under_ice{};  // asks for the full set, too
  bool seaglider{false};                         // the files of a Seaglider instead, of which alone is:
  std::vector<mission::ScienceBand> bands{};
};

/// The mission files of a stored plan, within the limits of its vehicle and of the water on its way by the newest data.
/// `generated`: the time that the files' comments name
/// Errors   every fault of plan or options, as mission::write_mission_set, mission::write_seaglider_set,
///          mission::check_safe_places and mission::fly_by_yo
[[nodiscard]] tl::expected<mission::MissionFiles, core::Violations> mission_of(
    sql::Connection& db, const repository::PlanRecord& record, const MissionRequest& request,
    core::UtcTime generated);

/// Where a shore station looks for the files that a glider shall fetch: a dockserver in "gliders/amadeus/to-glider/"
/// below its data, a Seaglider's base station in the home folder of the glider, "sg123/". No glider, no folder.
/// Source   the Slocum vendor's training material, folders of the shore server; iop-apl-uw/basestation3, folder sg000
/// Errors   a violation for a name that is no plain folder
[[nodiscard]] tl::expected<std::string, core::Violation> handover_folder(const std::string& glider,
                                                                         bool seaglider);

/// "10.5". Nothing for any other text.
[[nodiscard]] std::optional<mission::Firmware> parse_firmware(const std::string& text);

}  // namespace floeplan::service
