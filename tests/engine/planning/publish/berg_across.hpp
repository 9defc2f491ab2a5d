#pragma once

#include <gtest/gtest.h>

#include "engine/planning/cost/sea.hpp"
#include "tests/engine/planning/drifting_bergs.hpp"

namespace floeplan::planning {

/// A straight route eastwards. A berg drifts across it and lets the vehicle pass after a while.
class BergAcross : public testing::Test {
 protected:
  BergAcross() {
    request_.holds.longest = core::Seconds{48.0 * hour_s};
    request_.icebergs.max_inflation = core::Metres{1000.0};
    environment_.icebergs = {
        drifting_berg(geo::LocalProjection{request_.from}.to_lon_lat({12'000.0, 0.0}), 1000.0, 0.02, 0.0)};
  }
  [[nodiscard]] cost::Sea sea() const {
    return {environment_,
            request_,
            geo::LocalProjection{request_.from},
            {{-5'000.0, -9'000.0}, {25'000.0, 9'000.0}},
            core::Metres{500.0}};
  }

  PlanRequest request_{support::eastward_request()};
  ocean::Environment environment_;
};

}  // namespace floeplan::planning
