#pragma once

#include <string>

#include "engine/core/units.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::mission {

/// The origin of a mission file, as stated in its comments.
struct FileOrigin {
  std::string plan_id{};
  std::string plan_name{};
  core::UtcTime generated{};
  std::string written_by{"floeplan"};  // program and version
};

/// Comment lines that say what the file is: plan, vehicle, times, data and their hashes. User text is made
/// safe and cut, so that every line stays below 100 characters.
[[nodiscard]] std::string origin_comments(const planning::Plan& plan, const FileOrigin& origin);

}  // namespace floeplan::mission
