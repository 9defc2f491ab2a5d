#pragma once

#include "storage/repository/environment/environment_draft.hpp"
#include <cstddef>
#include <optional>
#include "engine/core/units.hpp"

namespace floeplan::repository {

/// Adds the depths: of the finest dataset where it covers the area, else of several put together, the finest first (the
/// newest of those alike), or of those that are named, in that order.
/// Errors   are among the draft's violations
void add_bathymetry(EnvironmentDraft& draft);

/// How far a berg drifts at 0.4 m/s in three days: from that far outside it may come into the area.
inline constexpr core::Metres reach_of_drift{100'000.0};

/// Where and how deep the draft's icebergs need to know the currents of a dataset: as far around the area as
/// the drift reaches, and down to the deepest keel, whatever the vehicle. Where that is more than
/// `most_samples` nodes, levels and steps, a smaller reach; no less than the area. Empty: no iceberg drifts.
/// `steps`  of time that are read
[[nodiscard]] std::optional<CurrentsBox> drift_box(const EnvironmentDraft& draft, const Dataset& dataset,
                                                   std::size_t steps, std::size_t most_samples);

/// Counts the icebergs that were seen before their currents begin, and names those whose currents are not known all the
/// way from then, or from the sighting, to the departure.
void tell_of_unknown_drift(EnvironmentDraft& draft);

/// Adds the currents, one dataset or an ensemble, with tides if they are asked for.
/// Precondition  the icebergs have been added: currents are needed from their oldest sighting on
/// Errors   are among the draft's violations
void add_water(EnvironmentDraft& draft);

/// Adds the sea ice of the mission, which may begin at the latest departure that the query knows of and last for 30
/// days: of the newest run, and of others where or when it tells nothing, the newer first; or of the one that is named.
/// Data of a time itself go before newer ones that are only held for it. What ended before the departure, by 30 days at
/// most, tells what keels were known last.
/// Errors   are among the draft's violations
void add_ice(EnvironmentDraft& draft);

}  // namespace floeplan::repository
