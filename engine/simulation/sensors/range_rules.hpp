#pragma once

#include <string>
#include <utility>

#include "engine/core/violation.hpp"

namespace floeplan::simulation {

/// Collects violations for settings outside their range. A value that is not finite is outside every range.
class RangeRules {
 public:
  /// Requires `from` <= value <= `to`.
  void require(const std::string& field, double value, double from, double to);
  /// `require` for an angle in radians; the message gives the bounds in degrees.
  void require_degrees(const std::string& field, double angle_rad, double from_deg, double to_deg);
  void refuse(const std::string& field, std::string rule) { found_.push_back({field, std::move(rule)}); }
  [[nodiscard]] const core::Violations& found() const { return found_; }

 private:
  core::Violations found_;
};

}  // namespace floeplan::simulation
