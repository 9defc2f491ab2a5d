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

/// What tidal currents are for: the user says it, because no file tells reliably whether it holds the tide already.
enum class TidesMode {
  add,  // to currents without tides
  only  // instead of any other currents
};

/// Which tides a job uses. Nothing is taken unasked.
struct TidesQuery {
  DatasetChoice choice{DatasetChoice::How::none, {}};
  std::optional<TidesMode> mode;

  [[nodiscard]] bool wanted() const { return choice.how != DatasetChoice::How::none; }
};

/// The tide models of a job, and the datasets they come from.
struct Tides {
  std::vector<ocean::TideGrid> models;
  std::vector<Dataset> datasets;
};

/// Reads the models that the query names (or the newest one with currents) around the area.
/// Errors   adds violations for a mode that is missing or given without tides, for datasets that do not exist, are of
///          another kind, share nothing with the area or hold no tidal currents; fields "/tides" and "/tides_mode"
[[nodiscard]] Tides load_tides(sql::Connection& db, const std::vector<Dataset>& stored,
                               const TidesQuery& query, const geo::BoundingBox& area,
                               core::Violations& violations);

/// The same models around another area, as far as they are there.
[[nodiscard]] Tides load_again(sql::Connection& db, const Tides& tides, const geo::BoundingBox& area);

/// Puts the tidal currents into the environment, into every member of an ensemble too, and says in its messages what
/// that implies. `period` counts where the currents have no times of their own.
void lay_tides(ocean::Environment& environment, const Tides& tides, TidesMode mode,
               const ocean::TidePeriod& period);

/// The same for the currents that carry icebergs, by models that reach around them.
void lay_drift_tides(ocean::Environment& environment, const Tides& tides, TidesMode mode,
                     const ocean::TidePeriod& period);

}  // namespace floeplan::repository
