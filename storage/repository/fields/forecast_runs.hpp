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

/// Steps of one run, both ends included, in seconds since 1970.
struct RunSteps {
  std::size_t run{};
  double first_s{};
  double last_s{};

  friend bool operator==(const RunSteps&, const RunSteps&) = default;
};

/// Which run to take for which time: at each time the newest that covers it, so that a new run replaces the forecast of
/// the runs before it and keeps what they say of the past and of what lies beyond its own end.
/// `runs_s`  the steps of each run, ascending; the newest run first
/// Returns   ascending in time, the unbroken part around `wanted_s`, or the first one after it where there is none and
///           `may_begin_later`; empty: there is none. The part is broken where the time between two runs is longer than
///           the longest step of both
[[nodiscard]] std::vector<RunSteps> newest_steps(std::span<const std::vector<double>> runs_s, double wanted_s,
                                                 bool may_begin_later);

/// A dataset and the steps of it that are used.
struct JoinedPart {
  Dataset dataset;
  Period used;
};

/// Joins the runs of the product that `runs[which]` is one of: same grid, depths and variables.
/// `runs`    of one kind, the newest run first
/// `within`  steps outside are not followed
/// Returns   as newest_steps
[[nodiscard]] std::vector<JoinedPart> join_runs(sql::Connection& db, const std::vector<Dataset>& runs,
                                                std::size_t which, const Period& within, core::UtcTime wanted,
                                                bool may_begin_later);

/// The currents (or the wind) of parts that were joined, from the last step before `from` on; nullopt: no node near the
/// area, or no step that late. Stops early as a FieldRepository does.
[[nodiscard]] std::optional<ocean::CurrentGrid> load_joined(sql::Connection& db,
                                                            const std::vector<JoinedPart>& parts,
                                                            const geo::BoundingBox& area, core::UtcTime from,
                                                            std::optional<core::Metres> deepest,
                                                            const std::stop_token& stop = {});

}  // namespace floeplan::repository
