#pragma once

#include <nlohmann/json_fwd.hpp>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "storage/repository/datasets/retention.hpp"

namespace floeplan::codec {

/// Which data are to go, and whether they are only to be named.
struct RetentionInputs {
  repository::RetentionRules rules;
  bool dry_run{false};
};

/// Reads {"older_than": "P30D", "max_bytes": 20000000000, "kind": "currents", "dry_run": true}; one of the first two
/// must be there.
/// Errors   every violation, with its JSON pointer
[[nodiscard]] tl::expected<RetentionInputs, core::Violations> parse_retention_inputs(
    const nlohmann::json& inputs);

/// What went, or would go, as API and command line show it.
[[nodiscard]] nlohmann::json retention_document(const std::vector<repository::StoredSize>& gone,
                                                bool dry_run);

}  // namespace floeplan::codec
