#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/ocean/currents/tide_overlay.hpp"
#include "engine/ocean/environment.hpp"
#include "storage/repository/datasets/dataset_choice.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// The use of tidal currents. The user states it, because no file reliably says whether its currents include
/// the tide.
enum class TidesMode {
  add,  // add them to currents without tides
  only  // use them instead of other currents
};

/// The tides that a job uses; by default none.
struct TidesQuery {
  DatasetChoice choice{DatasetChoice::How::none, {}};
  std::optional<TidesMode> mode;

  [[nodiscard]] bool wanted() const { return choice.how != DatasetChoice::How::none; }
};

/// The tide models of a job, and their datasets.
struct Tides {
  std::vector<ocean::TideGrid> models;
  std::vector<Dataset> datasets;
};

/// Reads the named models (or the newest with currents) around the area.
/// Errors   adds violations for a mode that is missing or given without tides, and for datasets that do not
///          exist, are of another kind, do not intersect the area or have no tidal currents; fields "/tides"
///          and "/tides_mode"
[[nodiscard]] Tides load_tides(sql::Connection& db, const std::vector<Dataset>& stored,
                               const TidesQuery& query, const geo::BoundingBox& area,
                               core::Violations& violations);

/// Reads the same models around another area; models without data there are omitted.
[[nodiscard]] Tides load_again(sql::Connection& db, const Tides& tides, const geo::BoundingBox& area);

/// Adds the tidal currents to the environment, also to every member of an ensemble, and messages about the
/// consequences. `period` is used if the currents have no times.
void lay_tides(ocean::Environment& environment, const Tides& tides, TidesMode mode,
               const ocean::TidePeriod& period);

/// Adds the tides to the currents that carry icebergs. The models must cover the area of these currents.
void lay_drift_tides(ocean::Environment& environment, const Tides& tides, TidesMode mode,
                     const ocean::TidePeriod& period);

}  // namespace floeplan::repository
