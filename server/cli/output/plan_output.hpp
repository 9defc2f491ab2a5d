#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "api/fields/process_fields.hpp"
#include "engine/core/violation.hpp"

namespace floeplan::cli {

/// How a plan is printed.
enum class PlanOutput {
  summary,     // the waypoints and at most 25 lines, dangers first
  everything,  // for a person
  json
};

/// Adds the flags --json and --verbose. The result says, once the command line is read, which of them were given.
[[nodiscard]] std::function<PlanOutput()> add_plan_output(CLI::App& command);

/// Prints a plan or infeasible document. Returns the exit code.
int print_plan(const nlohmann::json& document, PlanOutput output);

/// Prints an array of sentences for the pilot, each behind its rank, the dangers first.
void print_by_rank(const nlohmann::json& sentences);

/// Names every violation on stderr, and for scripts on stdout too. Returns the exit code.
/// `flags_of`: the process whose fields are the command's flags, by which the violations are named on stderr
int print_violations(const core::Violations& violations, bool json_out,
                     std::optional<fields::Process> flags_of = std::nullopt);

}  // namespace floeplan::cli
