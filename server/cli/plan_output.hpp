#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/core/violation.hpp"

namespace floeplan::cli {

/// Prints a plan or infeasible document, as JSON or as a table for a person. Returns the exit code.
int print_plan(const nlohmann::json& document, bool json_out);

/// Prints an array of sentences for the pilot, each behind its rank, the dangers first.
void print_by_rank(const nlohmann::json& sentences);

/// Names every violation on stderr, and for scripts on stdout too. Returns the exit code.
int print_violations(const core::Violations& violations, bool json_out);

}  // namespace floeplan::cli
