#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace floeplan::cli {

/// How a plan is printed.
enum class PlanOutput {
  summary,     // the waypoints and at most 25 lines, dangers first
  everything,  // everything, for people
  json
};

/// Adds the flags --json and --verbose. Call the returned function after parsing; it tells which of them was
/// given.
[[nodiscard]] std::function<PlanOutput()> add_plan_output(CLI::App& command);

/// Prints a plan or infeasible document. Returns the exit code.
int print_plan(const nlohmann::json& document, PlanOutput output);

/// Prints the messages of a document, each after its rank, dangers first.
void print_messages(const nlohmann::json& document);

}  // namespace floeplan::cli
