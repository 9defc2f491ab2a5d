#include "storage/repository/environment_draft.hpp"

#include <algorithm>

#include "engine/core/utc_text.hpp"

namespace floeplan::repository {

std::optional<Period> period_of(const Dataset& dataset) {
  if (!dataset.time_start || !dataset.time_end) return std::nullopt;
  return Period{*dataset.time_start, *dataset.time_end};
}

std::string period_text(const Period& period) {
  return core::iso8601(period.from) + " to " + core::iso8601(period.to);
}

bool covers(const Period& period, core::UtcTime time) { return period.from <= time && time <= period.to; }

void warn_of_gap(EnvironmentDraft& draft, DatasetKind kind, const DatasetChoice& choice,
                 const std::string& consequence) {
  if (choice.how == DatasetChoice::How::none) {
    draft.warn(kind_name(kind) + " left out as requested: " + consequence);
  } else {
    draft.warn("no stored " + kind_name(kind) + " for " + bounds_text(draft.query.area) + ": " + consequence);
  }
}

bool covers_begin(const Period& period, const EnvironmentQuery& query) {
  return covers(period, query.depart) || (query.may_begin_later && query.depart <= period.to);
}

core::UtcTime drift_start(const EnvironmentDraft& draft) {
  core::UtcTime start = draft.query.depart;
  if (!draft.query.iceberg_drift) return start;
  for (const ocean::Iceberg& iceberg : draft.environment.icebergs) start = std::min(start, iceberg.observed);
  return start;
}

}  // namespace floeplan::repository
