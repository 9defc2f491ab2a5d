#pragma once

#include <string>

namespace floeplan::mission {

/// A text file for the vehicle, not yet written anywhere. ASCII, LF, a newline at the end.
struct MissionFile {
  std::string name;  // 8.3, lower case: "goto_l10.ma"
  std::string text;

  friend bool operator==(const MissionFile&, const MissionFile&) = default;
};

}  // namespace floeplan::mission
