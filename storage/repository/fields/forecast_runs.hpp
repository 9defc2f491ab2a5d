#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/ocean/currents/current_grid.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Steps of one model run, both ends included, in seconds since 1970.
struct RunSteps {
  std::size_t run{};
  double first_s{};
  double last_s{};

  friend bool operator==(const RunSteps&, const RunSteps&) = default;
};

/// Selects the model run for each time: the newest run that covers it. A new run thus replaces the forecast
/// of earlier runs, but not their data before its begin and after its end.
/// `runs_s`  the steps of each run, ascending; the newest run first
/// Returns   ascending in time, the continuous part around `wanted_s`. If there is none and
///           `may_begin_later`, the first part after it; otherwise empty. A gap between two runs that is
///           longer than the longest step of both ends a part
[[nodiscard]] std::vector<RunSteps> newest_steps(std::span<const std::vector<double>> runs_s, double wanted_s,
                                                 bool may_begin_later);

/// A dataset, and the period of its steps in use.
struct JoinedPart {
  Dataset dataset;
  Period used;
};

/// Joins the model runs of one product: runs with the grid, depths and variables of `runs[which]`.
/// `runs`    datasets of one kind, the newest run first
/// `within`  steps outside this period are not used
/// Returns   as newest_steps
[[nodiscard]] std::vector<JoinedPart> join_runs(sql::Connection& db, const std::vector<Dataset>& runs,
                                                std::size_t which, const Period& within, core::UtcTime wanted,
                                                bool may_begin_later);

/// The currents (or the wind) of joined parts, from the last step before `from` on; nullopt: no node near the
/// area, or no step that late. Stops early if `stop` is requested, as FieldRepository does.
[[nodiscard]] std::optional<ocean::CurrentGrid> load_joined(sql::Connection& db,
                                                            const std::vector<JoinedPart>& parts,
                                                            const geo::BoundingBox& area, core::UtcTime from,
                                                            std::optional<core::Metres> deepest,
                                                            const std::stop_token& stop = {});

}  // namespace floeplan::repository
