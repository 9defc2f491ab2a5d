#pragma once

#include <string>
#include <vector>

#include "engine/messages/message.hpp"
#include "engine/mission/writing/mission_file.hpp"
#include "engine/mission/writing/mission_set_options.hpp"

namespace floeplan::mission {

/// Draft of icebergs that the firmware is told to expect.
/// Precondition  `options.under_ice` is given
[[nodiscard]] core::Metres expected_iceberg_depth(const planning::Plan& plan,
                                                  const MissionSetOptions& options);

/// The sensor lines that tell the firmware to expect ice: its own response to a blocked surface, the place to
/// head for without any fix, and the draft of icebergs.
/// Source   the vendor's stock settings ice.mi of firmware 10.5
/// Precondition  `options.under_ice` is given
[[nodiscard]] std::string ice_settings(const planning::Plan& plan, const MissionSetOptions& options);

/// File name of the mission that holds the settings alone.
[[nodiscard]] std::string ice_settings_name(const MissionSetOptions& options);

/// The list of safe places that the stock recovery mission (recov.mi) flies, and the settings as a mission of
/// their own, to be loaded or copied into autoexec.mi.
[[nodiscard]] std::vector<MissionFile> ice_files(const planning::Plan& plan,
                                                 const MissionSetOptions& options);

/// What is wrong with the safe places and the draft of icebergs.
[[nodiscard]] core::Violations ice_violations(const planning::Plan& plan, const MissionSetOptions& options);

/// What the vehicle must hold besides these files, for the pilot.
[[nodiscard]] std::vector<messages::Message> ice_warnings(const planning::Plan& plan,
                                                          const MissionSetOptions& options);

}  // namespace floeplan::mission
