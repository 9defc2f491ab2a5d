#include <array>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>

#include "api/codec/documents/plan_comparison.hpp"
#include "server/cli/program/command.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/work/plan_repository.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;

struct CompareFlags {
  std::array<std::string, 2> plans;
  bool json_out{false};
};

std::string shown(const json& value) {
  if (value.is_null()) return "-";
  if (!value.is_number_float()) return value.is_string() ? value.get<std::string>() : value.dump();
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f", value.get<double>());
  return text.data();
}

void print_row(const std::string& name, const json& first, const json& second, const json& difference) {
  std::printf("%-28s %-22s %-22s %s\n", name.c_str(), shown(first).c_str(), shown(second).c_str(),
              shown(difference).c_str());
}

void print_compare_table(const json& comparison) {
  const json& first = comparison.at("first");
  const json& second = comparison.at("second");
  const json& more = comparison.at("difference");
  print_row("", first.at("plan_id"), second.at("plan_id"), "second less first");
  print_row("departure", first.at("departure"), second.at("departure"), more.at("departure_s"));
  print_row("arrival", first.at("arrival"), second.at("arrival"), more.at("arrival_s"));
  for (const char* name : {"travel_time_s", "distance_m", "energy_j", "iceberg_encounters", "below_ice_m",
                           "below_ice_s", "longest_without_surfacing_s"})
    print_row(name, first.at(name), second.at(name), more.at(name));
  for (const char* name : {"iceberg_m", "land_m", "bottom_m"})
    print_row(std::string{"clear of "} + name, first.at("clearances").at(name),
              second.at("clearances").at(name), more.at("clearances").at(name));
  print_row("waypoints", first.at("waypoints"), second.at("waypoints"), "");
  for (const json& input : comparison.at("inputs"))
    print_row("input " + input.at("input").get<std::string>(), input.at("first").dump(),
              input.at("second").dump(), "");
  for (const json& dataset : comparison.at("data"))
    std::printf("only the %s was made with %s (%s)\n", dataset.at("used_by").get<std::string>().c_str(),
                dataset.at("name").get<std::string>().c_str(), dataset.at("id").get<std::string>().c_str());
}

int run_compare(const CompareFlags& flags, const Program& program) {
  auto db = open_existing_store(program);
  const repository::PlanRepository plans{db};
  const auto first = plans.find({flags.plans[0]});
  const auto second = plans.find({flags.plans[1]});
  if (!first || !second) return complain_of_no_plan(flags.plans[first ? 1 : 0]);
  const json comparison = codec::plan_comparison(*first, *second);
  if (flags.json_out) {
    std::cout << comparison.dump(2) << '\n';
  } else {
    print_compare_table(comparison);
  }
  return done;
}

}  // namespace

void add_compare(CLI::App& app, Program& program) {
  auto flags = std::make_shared<CompareFlags>();
  auto* command = app.add_subcommand("compare", "Show two stored plans side by side");
  command->add_option("FIRST", flags->plans[0], "A plan's id")->required();
  command->add_option("SECOND", flags->plans[1], "The other plan's id")->required();
  command->add_flag("--json", flags->json_out, "Answer with one JSON document");
  command->callback([flags, &program] { program.exit_code = run_compare(*flags, program); });
}

}  // namespace floeplan::cli
