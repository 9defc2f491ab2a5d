#pragma once

#include <cstddef>
#include <optional>

#include "engine/core/units.hpp"
#include "storage/repository/environment/environment_draft.hpp"

namespace floeplan::repository {

/// Adds the depths. If the finest dataset covers the area, it alone is used; otherwise several are combined,
/// the finest first (the newest first if equally fine). Named datasets are combined in the order of their
/// names.
/// Errors   are added to the draft's violations
void add_bathymetry(EnvironmentDraft& draft);

/// Distance outside an area from which icebergs may drift into it: 0.4 m/s for three days.
inline constexpr core::Metres reach_of_drift{100'000.0};

/// The region in which the drift of the draft's icebergs needs currents of a dataset: around the area as far
/// as bergs drift, and down to the deepest keel. If this is more than `most_samples` (nodes times levels
/// times steps), the distance is reduced, at most to the area itself. Empty: no iceberg drifts.
/// `steps`  number of time steps that are read
[[nodiscard]] std::optional<CurrentsBox> drift_box(const EnvironmentDraft& draft, const Dataset& dataset,
                                                   std::size_t steps, std::size_t most_samples);
/// An upper estimate of the samples of a box, per time step: nodes times levels.
[[nodiscard]] std::size_t most_samples_a_step(const EnvironmentDraft& draft, const Dataset& dataset,
                                              const CurrentsBox& box);
/// The box that holds the currents of the area and those that carry icebergs; `of_drift` encloses the area. Empty: it
/// would need much more than `of_area`, so each is better read on its own.
[[nodiscard]] std::optional<CurrentsBox> box_of_both(const EnvironmentDraft& draft, const Dataset& dataset,
                                                     const CurrentsBox& of_area, const CurrentsBox& of_drift);

/// Adds messages: how many icebergs were seen before their currents begin, and which icebergs have no known
/// current for all of the time from the begin of the currents, or from their sighting, to the departure.
void tell_of_unknown_drift(EnvironmentDraft& draft);

/// Adds the currents: one dataset or an ensemble, with tides if the query asks for them.
/// Precondition  the icebergs have been added, because currents are needed since their oldest sighting
/// Errors   are added to the draft's violations
void add_water(EnvironmentDraft& draft);

/// Adds the sea ice of the mission, which may begin as late as the query's latest departure and last 30 days.
/// Used are the newest run and, at places and times without its data, other runs, newer ones first; or only
/// the named dataset. Data valid at a time are preferred to newer data that are only held for it. Data that
/// ended up to 30 days before the departure give the last known keels.
/// Errors   are added to the draft's violations
void add_ice(EnvironmentDraft& draft);

}  // namespace floeplan::repository
