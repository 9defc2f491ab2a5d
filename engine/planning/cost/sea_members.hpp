#pragma once

#include <cstddef>

#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::cost {

/// Whether there are several currents to plan for: members of an ensemble or an error model.
[[nodiscard]] bool has_uncertain_currents(const ocean::Environment& environment, const PlanRequest& request);

/// The environments of an ensemble's members, or of draws from an error model. Each is made when it is asked
/// for, so that only those in use take memory.
/// Threads  const members may be called from several threads at once
class SeaMembers {
 public:
  /// `environment` and `rules` are borrowed and must outlive this object. Precondition: the currents are
  /// uncertain.
  SeaMembers(const ocean::Environment& environment, const UncertaintyRules& rules)
      : environment_{environment}, rules_{rules} {}

  [[nodiscard]] std::size_t size() const;
  /// The environment with the currents of one member. Calls with equal `member` give equal environments.
  [[nodiscard]] ocean::Environment environment(std::size_t member) const;

 private:
  const ocean::Environment& environment_;
  const UncertaintyRules& rules_;
};

}  // namespace floeplan::planning::cost
