#pragma once

#include <cstddef>
#include <optional>

#include "engine/core/units.hpp"
#include "storage/repository/environment/environment_draft.hpp"

namespace floeplan::repository {

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

}  // namespace floeplan::repository
