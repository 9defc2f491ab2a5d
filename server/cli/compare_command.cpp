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

std::string shown(const json& value, double factor = 1.0, int decimals = 1) {
  if (value.is_null()) return "-";
  if (!value.is_number_float()) return value.is_string() ? value.get<std::string>() : value.dump();
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, factor * value.get<double>());
  return text.data();
}

void print_row(const std::string& name, const std::string& first, const std::string& second,
               const std::string& difference) {
  std::printf("%-34s %-22s %-22s %s\n", name.c_str(), first.c_str(), second.c_str(), difference.c_str());
}

/// A figure of a plan, with its unit for people.
struct ComparedFigure {
  const char* title;
  const char* member;
  double factor;
  int decimals;
};

constexpr double to_km = 1e-3;
constexpr double to_hours = 1.0 / 3600.0;
constexpr ComparedFigure compared_figures[]{
    {"travel time, h", "travel_time_s", to_hours, 2},
    {"distance, km", "distance_m", to_km, 1},
    {"energy, MJ", "energy_j", 1e-6, 3},
    {"expected iceberg encounters", "iceberg_encounters", 1.0, 3},
    {"below ice, km", "below_ice_m", to_km, 1},
    {"below ice, h", "below_ice_s", to_hours, 2},
    {"longest without surfacing, h", "longest_without_surfacing_s", to_hours, 2}};
constexpr ComparedFigure compared_clearances[]{{"least distance to icebergs, km", "iceberg_m", to_km, 2},
                                               {"least distance to land, km", "land_m", to_km, 2},
                                               {"least distance to the sea bed, m", "bottom_m", 1.0, 0}};

void print_compare_table(const json& comparison) {
  const json& first = comparison.at("first");
  const json& second = comparison.at("second");
  const json& more = comparison.at("difference");
  const auto print_figure = [](const ComparedFigure& figure, const json& a, const json& b, const json& by) {
    const auto value = [&](const json& of) {
      return shown(of.at(figure.member), figure.factor, figure.decimals);
    };
    print_row(figure.title, value(a), value(b), value(by));
  };
  print_row("", shown(first.at("plan_id")), shown(second.at("plan_id")), "second less first");
  print_row("departure (difference in h)", shown(first.at("departure")), shown(second.at("departure")),
            shown(more.at("departure_s"), to_hours, 2));
  print_row("arrival (difference in h)", shown(first.at("arrival")), shown(second.at("arrival")),
            shown(more.at("arrival_s"), to_hours, 2));
  for (const ComparedFigure& figure : compared_figures) print_figure(figure, first, second, more);
  for (const ComparedFigure& figure : compared_clearances)
    print_figure(figure, first.at("clearances"), second.at("clearances"), more.at("clearances"));
  print_row("waypoints", shown(first.at("waypoints")), shown(second.at("waypoints")), "");
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
