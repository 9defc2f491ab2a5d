#include "engine/avoidance/settings.hpp"

#include <cmath>
#include <string>

namespace floeplan::avoidance {
namespace {

class Rules {
 public:
  void positive(const char* field, double value) {
    if (!(std::isfinite(value) && value > 0.0)) add(field, "must be a finite number above zero");
  }
  void holds(bool rule, const char* field, const char* text) {
    if (!rule) add(field, text);
  }
  [[nodiscard]] const core::Violations& found() const { return found_; }

 private:
  void add(const char* field, const char* text) { found_.push_back({std::string{"/"} + field, text}); }
  core::Violations found_;
};

}  // namespace

core::Violations AvoidanceSettings::violations() const {
  Rules rules;
  rules.positive("sonar/reach", sonar.reach.value);
  rules.positive("sonar/half_height", sonar.half_height.value);
  rules.holds(sonar.beam_half_height.value >= 0.0 && sonar.beam_half_height <= sonar.half_height,
              "sonar/beam_half_height", "must be between zero and `half_height`");
  rules.holds(std::abs(sonar.tilt.value) <= 1.5708, "sonar/tilt", "must be within 90 degrees");
  rules.holds(sonar.edge.value >= 0.0, "sonar/edge", "must be zero or more");
  rules.holds(sonar.edge_half_height.value >= 0.0 && sonar.edge_half_height.value <= 1.5708,
              "sonar/edge_half_height", "must be between zero and 90 degrees");
  rules.positive("sonar/range_sigma", sonar.range_sigma.value);
  rules.positive("sonar/bearing_sigma", sonar.bearing_sigma.value);
  rules.positive("through_water", through_water.value);
  rules.positive("clearance", clearance.value);
  rules.positive("close", close.value);
  rules.positive("watch", watch.count());
  rules.positive("imminent", imminent.count());
  rules.positive("settled", settled.count());
  rules.positive("replan", replan.count());
  rules.positive("forget", forget.count());
  rules.positive("give_up", give_up.count());
  rules.positive("forecast_sigma", forecast_sigma.value);
  rules.positive("drift_sigma", drift_sigma.value);
  rules.positive("waypoint_radius", waypoint_radius.value);
  rules.positive("vertical_margin", vertical_margin.value);
  rules.positive("least_band", least_band.value);
  rules.positive("least_water", least_water.value);
  rules.holds(std::isfinite(shallowest.value) && shallowest.value >= 0.0, "shallowest",
              "must be a finite depth, zero or more");
  rules.holds(std::isfinite(deepest.value) && deepest > shallowest, "deepest", "must lie below `shallowest`");
  rules.holds(close <= clearance, "close", "must be at most `clearance`");
  rules.holds(clearance < sonar.reach, "clearance", "must be less than the sonar's reach");
  rules.holds(imminent < watch, "imminent", "must be less than `watch`");
  rules.holds(most_expansions > 0, "most_expansions", "must be above zero");
  return rules.found();
}

}  // namespace floeplan::avoidance
