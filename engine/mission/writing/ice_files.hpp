#pragma once

#include <string>
#include <vector>

#include "engine/messages/message.hpp"
#include "engine/mission/writing/mission_file.hpp"
#include "engine/mission/writing/mission_set_options.hpp"

namespace floeplan::mission {

/// Draft of icebergs that the firmware must expect.
/// Precondition  `options.under_ice` is given
[[nodiscard]] core::Metres expected_iceberg_depth(const planning::Plan& plan,
                                                  const MissionSetOptions& options);

/// Sensor lines that prepare the firmware for ice: its response to a blocked surface, the place to head for
/// without any fix, and the draft of icebergs.
/// Source   the vendor's stock settings ice.mi of firmware 10.5
/// Precondition  `options.under_ice` is given
[[nodiscard]] std::string ice_settings(const planning::Plan& plan, const MissionSetOptions& options);

/// File name of the mission that contains only these settings.
[[nodiscard]] std::string ice_settings_name(const MissionSetOptions& options);

/// The list of safe places that the stock recovery mission (recov.mi) flies, and a mission with only the
/// settings, to be loaded or copied into autoexec.mi.
[[nodiscard]] std::vector<MissionFile> ice_files(const planning::Plan& plan,
                                                 const MissionSetOptions& options);

/// Violations of the rules for safe places and draft of icebergs.
[[nodiscard]] core::Violations ice_violations(const planning::Plan& plan, const MissionSetOptions& options);

/// Messages for the pilot about files and settings that must be on the vehicle besides these files.
[[nodiscard]] std::vector<messages::Message> ice_warnings(const planning::Plan& plan,
                                                          const MissionSetOptions& options);

}  // namespace floeplan::mission
