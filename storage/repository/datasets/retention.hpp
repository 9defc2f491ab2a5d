#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Limits for data in the store. Nothing is removed unless somebody asks for it with such rules.
struct RetentionRules {
  std::optional<core::Seconds>
      max_age{};  // time since the end of their period, or since their ingestion if that is later
  std::optional<std::int64_t> max_bytes{};  // total size of all samples and tracks, as stored (compressed)
  std::optional<DatasetKind> kind{};  // if set, the rules apply only to this kind, and only it is counted
};

/// A dataset with the size of its stored samples and tracks.
struct StoredSize {
  Dataset dataset;
  std::int64_t bytes{};
};

/// Selects the datasets to remove: those that are too old, then, while the total is too large, those whose
/// period ended first. Data without time (depths, coasts, tides, zones) do not age and are removed only by
/// name. The dataset whose period ends last is kept for each kind.
/// Returns  in the order of removal
[[nodiscard]] std::vector<StoredSize> beyond_retention(std::vector<StoredSize> stored,
                                                       const RetentionRules& rules, core::UtcTime now);

/// All datasets, each with its size.
[[nodiscard]] std::vector<StoredSize> stored_sizes(sql::Connection& db);

/// Removes the datasets beyond the rules: all of them or, on an error, none.
/// Returns  the removed datasets
std::vector<StoredSize> remove_beyond_retention(sql::Connection& db, const RetentionRules& rules,
                                                core::UtcTime now);

}  // namespace floeplan::repository
