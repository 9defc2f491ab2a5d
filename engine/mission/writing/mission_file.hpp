#pragma once

#include <string>
#include <vector>

#include "engine/messages/message.hpp"

namespace floeplan::mission {

/// A text file for the vehicle, in memory. ASCII, LF, ends with a newline.
struct MissionFile {
  std::string name;  // 8.3, lower case: "goto_l10.ma"
  std::string text;

  friend bool operator==(const MissionFile&, const MissionFile&) = default;
};

/// Files for a vehicle, and messages about them for the pilot.
struct MissionFiles {
  std::vector<MissionFile> files;  // in the order in which the vehicle needs them
  std::vector<messages::Message> messages;
};

}  // namespace floeplan::mission
