#pragma once

#include <nlohmann/json_fwd.hpp>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "storage/repository/datasets/retention.hpp"

namespace floeplan::codec {

/// Which data to remove, and whether only to list them.
struct RetentionInputs {
  repository::RetentionRules rules;
  bool dry_run{false};
};

/// Reads {"older_than": "P30D", "max_bytes": 20000000000, "kind": "currents", "dry_run": true}; at least one
/// of the first two is required.
/// Errors   every violation, with its JSON pointer
[[nodiscard]] tl::expected<RetentionInputs, core::Violations> parse_retention_inputs(
    const nlohmann::json& inputs);

/// The removed data, or those that would be removed, for API and command line.
[[nodiscard]] nlohmann::json retention_document(const std::vector<repository::StoredSize>& gone,
                                                bool dry_run);

}  // namespace floeplan::codec
