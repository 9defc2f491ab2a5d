#include <array>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/planning/reproduction.hpp"
#include "server/cli/command.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;
using planning::ReproducedRow;

template <class T>
json or_null(const std::optional<T>& value) {
  return value ? json(*value) : json(nullptr);
}

json table_document(const std::vector<ReproducedRow>& rows) {
  json table = json::array();
  for (const ReproducedRow& row : rows) {
    table.push_back({{"row", row.row},
                     {"paper_s", or_null(row.paper_s)},
                     {"verified_s", or_null(row.verified_s)},
                     {"ours_s", or_null(row.ours_s)},
                     {"ours_at_default_tolerance_s", or_null(row.ours_at_default_tolerance_s)},
                     {"vertices", or_null(row.vertices)},
                     {"edges", or_null(row.edges)},
                     {"saving_pct", or_null(row.saving_pct)},
                     {"deviation_pct", or_null(row.deviation_pct)},
                     {"remark", row.remark}});
  }
  return table;
}

template <class T>
std::string cell(const std::optional<T>& value, const char* format) {
  if (!value) return "-";
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), format, static_cast<double>(*value));
  return text.data();
}

void print_table(const char* title, const std::vector<ReproducedRow>& rows) {
  std::printf("%s\n%-18s %9s %9s %9s %10s %8s %7s %8s %8s\n", title, "method", "paper", "verified", "ours",
              "at 1e-4", "vertices", "edges", "saving %", "dev. %");
  for (const ReproducedRow& row : rows) {
    std::printf("%-18s %9s %9s %9s %10s %8s %7s %8s %8s  %s\n", row.row.c_str(),
                cell(row.paper_s, "%.3f").c_str(), cell(row.verified_s, "%.3f").c_str(),
                cell(row.ours_s, "%.3f").c_str(), cell(row.ours_at_default_tolerance_s, "%.3f").c_str(),
                cell(row.vertices, "%.0f").c_str(), cell(row.edges, "%.0f").c_str(),
                cell(row.saving_pct, "%.2f").c_str(), cell(row.deviation_pct, "%.2f").c_str(),
                row.remark.c_str());
  }
}

int run(bool json_out) {
  const auto table_2 = planning::reproduce_table_2();
  const auto table_3 = planning::reproduce_table_3();
  if (json_out) {
    std::cout << json{{"table_2", table_document(table_2)}, {"table_3", table_document(table_3)}}.dump(2)
              << '\n';
    return done;
  }
  print_table("Table II: crossing a river (Eichhorn 2009), times in seconds", table_2);
  std::printf("\n");
  print_table("Table III: a meandering jet; start and goal are a stand-in, since the paper prints none",
              table_3);
  return done;
}

}  // namespace

void add_reproduce(CLI::App& app, Program& program) {
  auto json_out = std::make_shared<bool>(false);
  auto* command = app.add_subcommand("reproduce", "Print the paper's tables beside our numbers");
  command->add_flag("--json", *json_out, "Answer with one JSON document");
  command->callback([json_out, &program] { program.exit_code = run(*json_out); });
}

}  // namespace floeplan::cli
