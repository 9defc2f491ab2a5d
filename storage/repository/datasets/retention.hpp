#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// What may stay in the store. Nothing is ever removed unless somebody asks for it with such rules.
struct RetentionRules {
  std::optional<core::Seconds>
      max_age{};  // since the end of their period, or their ingestion if that is later
  std::optional<std::int64_t>
      max_bytes{};                    // of all samples and tracks together, compressed as they are stored
  std::optional<DatasetKind> kind{};  // the rules hold for it alone, and count it alone
};

/// A dataset and the room that its samples and tracks take.
struct StoredSize {
  Dataset dataset;
  std::int64_t bytes{};
};

/// Which datasets go: those that are too old, and then, while too much is left, the one whose period ended first.
/// Data without time (depths, coasts, tides, zones) do not age, and go by name only; so does the dataset of each kind
/// whose period ends last.
/// Returns  in the order in which they go
[[nodiscard]] std::vector<StoredSize> beyond_retention(std::vector<StoredSize> stored,
                                                       const RetentionRules& rules, core::UtcTime now);

/// Every dataset of the list with its size.
[[nodiscard]] std::vector<StoredSize> stored_sizes(sql::Connection& db);

/// Removes what is beyond the rules, all or nothing.
/// Returns  what was removed
std::vector<StoredSize> remove_beyond_retention(sql::Connection& db, const RetentionRules& rules,
                                                core::UtcTime now);

}  // namespace floeplan::repository
