#pragma once

#include <string>

#include "engine/core/units.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::mission {

/// Where a mission file comes from, as its comments say it.
struct FileOrigin {
  std::string plan_id{};
  std::string plan_name{};
  core::UtcTime generated{};
  std::string written_by{"floeplan"};  // program and version
};

/// Comment lines that tell whoever finds the file what it is: plan, vehicle, times, data and their hashes. Text of
/// users is made safe and cut, so that every line stays below 100 characters.
[[nodiscard]] std::string origin_comments(const planning::Plan& plan, const FileOrigin& origin);

}  // namespace floeplan::mission
