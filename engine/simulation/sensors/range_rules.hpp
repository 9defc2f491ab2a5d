#pragma once

#include <string>
#include <utility>

#include "engine/core/violation.hpp"

namespace floeplan::simulation {

/// Collects the settings that lie outside their range; one that is not finite lies outside every range.
class RangeRules {
 public:
  /// Both ends included.
  void require(const std::string& field, double value, double from, double to);
  /// Does what `require` does, for an angle in radians; the message states the bounds in degrees.
  void require_degrees(const std::string& field, double angle_rad, double from_deg, double to_deg);
  void refuse(const std::string& field, std::string rule) { found_.push_back({field, std::move(rule)}); }
  [[nodiscard]] const core::Violations& found() const { return found_; }

 private:
  core::Violations found_;
};

}  // namespace floeplan::simulation
