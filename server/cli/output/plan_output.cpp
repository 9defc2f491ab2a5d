#include "server/cli/output/plan_output.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <utility>
#include <vector>

#include "api/codec/bytes/document_values.hpp"
#include "api/codec/documents/alternative_document.hpp"
#include "engine/core/shown_text.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/geo/written_place.hpp"
#include "server/cli/program/command.hpp"
#include "storage/json/json.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;

/// Lines of a summary in addition to the waypoints, so that everything fits on one screen.
constexpr std::size_t most_summary_lines = 25;

std::string cell(const json& value, const char* format, double factor = 1.0) {
  if (!value.is_number()) return "-";
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), format, value.get<double>() * factor);
  return text.data();
}

std::string duration(const json& seconds) {
  return seconds.is_number() ? core::hours_minutes(core::Seconds{seconds.get<double>()}) : "-";
}

std::string label(const json& index) { return codec::waypoint_label(index.get<std::size_t>()); }

void print_table(const json& plan) {
  std::printf("%-4s %-14s %-14s %-20s %9s %8s %8s %7s %8s  %s\n", "no.", "latitude", "longitude", "ETA",
              "leg km", "course", "SOG m/s", "depth m", "kJ", "propulsion");
  for (const json& waypoint : plan.at("waypoints")) {
    std::printf(
        "%-4s %s    %s   %-20s %9s %8s %8s %7s %8s  %s\n", label(waypoint.at("index")).c_str(),
        geo::latitude_text(waypoint.at("lat")).c_str(), geo::longitude_text(waypoint.at("lon")).c_str(),
        waypoint.at("eta").get<std::string>().c_str(), cell(waypoint.at("leg_m"), "%.2f", 1e-3).c_str(),
        cell(waypoint.at("course_deg"), "%.1f").c_str(),
        cell(waypoint.at("speed_over_ground_m_s"), "%.3f").c_str(),
        cell(waypoint.at("depth_m"), "%.0f").c_str(), cell(waypoint.at("energy_j"), "%.1f", 1e-3).c_str(),
        waypoint.at("propulsion").is_string() ? waypoint.at("propulsion").get<std::string>().c_str() : "-");
  }
}

constexpr double worth_a_line_s = 30.0;  // shorter holds are not printed

std::vector<std::string> wait_lines(const json& plan) {
  std::vector<std::string> lines;
  for (const json& waypoint : plan.at("waypoints")) {
    if (waypoint.value("wait_s", 0.0) < worth_a_line_s) continue;
    lines.push_back("hold at waypoint " + label(waypoint.at("index")) + " for " +
                    duration(waypoint.at("wait_s")));
  }
  return lines;
}

/// Prints the savings by refinement, and the travel times with other numbers of legs.
void print_refinement(const json& plan) {
  const json refinement = plan.value("refinement", json());
  if (refinement.is_null()) return;
  const std::string stopped_by = refinement.at("stopped_by");
  const auto with_energy = [&](const char* time, const char* energy) {
    const json joules = refinement.value(energy, json());
    return duration(refinement.at(time)) + (joules.is_null() ? "" : ", " + cell(joules, "%.1f kJ", 1e-3));
  };
  const bool had_to_lose = refinement.at("after_s") > refinement.at("before_s") &&
                           refinement.value("energy_after_j", 1.0) > refinement.value("energy_before_j", 0.0);
  std::printf("%s from %s to %s%s\n", had_to_lose ? "cut to few waypoints and refined," : "refined",
              with_energy("before_s", "energy_before_j").c_str(),
              with_energy("after_s", "energy_after_j").c_str(),
              stopped_by == "converged" ? "" : (" until stopped by its limit of " + stopped_by).c_str());
  if (plan.at("leg_trade").empty()) return;
  std::printf("travel time in hours by number of legs:");
  for (const json& entry : plan.at("leg_trade")) {
    std::printf("  %d: %s", entry.at("legs").get<int>(),
                cell(entry.at("travel_time_s"), "%.2f", 1.0 / 3600.0).c_str());
  }
  std::printf("\n");
}

/// Prints all departures of a window, with a mark at the planned one.
void print_departures(const json& document) {
  if (!document.contains("departures")) return;
  const std::string planned = document.value("departure", "");
  std::printf("%-22s %9s %9s  %s\n", "departure", "hours", "energy_MJ", "");
  for (const json& entry : document.at("departures")) {
    const auto departure = entry.at("departure").get<std::string>();
    const std::string remark = entry.at("status") != "ok" ? entry.at("reason").get<std::string>()
                               : departure == planned     ? "best"
                                                          : "";
    std::printf("%-22s %9s %9s  %s\n", departure.c_str(),
                cell(entry.at("travel_time_s"), "%.2f", 1.0 / 3600.0).c_str(),
                cell(entry.at("energy_j"), "%.3f", 1e-6).c_str(), remark.c_str());
  }
}

/// One line about the best departure of a window.
std::vector<std::string> departure_lines(const json& document) {
  if (!document.contains("departures")) return {};
  const json& all = document.at("departures");
  const auto with_plan =
      std::ranges::count_if(all, [](const json& entry) { return entry.at("status") == "ok"; });
  return {"best of " + std::to_string(all.size()) + " departures, " + std::to_string(with_plan) +
          " with a route"};
}

std::vector<std::string> energy_lines(const json& plan) {
  const json energy = plan.value("energy", json());
  if (energy.is_null()) return {};
  const auto megajoules = [](const json& joules) { return cell(joules, "%.3f", 1e-6); };
  return {"energy " + megajoules(plan.at("energy_j")) + " MJ of " + megajoules(energy.at("usable_j")) +
          " MJ: hotel " + megajoules(energy.at("hotel_j")) + ", pump " + megajoules(energy.at("pump_j")) +
          ", thruster " + megajoules(energy.at("thruster_j")) + "; " +
          cell(energy.at("inflections"), "%.0f") + " turns of dives"};
}

std::string optimality_line(const json& plan) {
  if (plan.at("optimality_gap").is_null()) {
    return "optimality gap not known: " + plan.at("optimality_gap_reason").get<std::string>();
  }
  return "optimality gap " + cell(plan.at("optimality_gap"), "%.2f", 100.0) +
         " %: by so much the plan is slower than the best possible route in open water";
}

/// Lines about the time and the depth below ice; none if there is no ice.
std::vector<std::string> ice_lines(const json& plan) {
  const json& surfacing = plan.at("surfacing");
  if (surfacing.is_null()) return {};
  std::vector<std::string> lines;
  if (const json below_m = surfacing.value("below_ice_m", json()); below_m.is_number() && below_m > 0.0)
    lines.push_back("below ice or icebergs for " + core::distance_text(core::Metres{below_m.get<double>()}) +
                    ", " + duration(surfacing.at("below_ice_s")));
  if (const json& longest_s = surfacing.at("longest_without_surfacing_s"); longest_s > 0.0)
    lines.push_back("longest time between places to surface " + duration(longest_s));
  double deepest_m = 0.0;
  for (const json& waypoint : plan.at("waypoints")) {
    if (const json turn = waypoint.value("leg_upper_turn_m", json()); turn.is_number())
      deepest_m = std::max(deepest_m, turn.get<double>());
  }
  if (deepest_m > 0.0)
    lines.push_back("below ice or icebergs the upper turn is at " + cell(std::ceil(deepest_m), "%.0f m") +
                    " or deeper");
  return lines;
}

/// Prints all planned surfacings and escape routes.
void print_surfacings(const json& plan) {
  const json& surfacing = plan.at("surfacing");
  if (surfacing.is_null()) return;
  for (const json& planned : surfacing.at("planned")) {
    std::printf("surface at %s, %s %s, position known to %s m before the fix\n",
                planned.at("time").get<std::string>().c_str(), geo::latitude_text(planned.at("lat")).c_str(),
                geo::longitude_text(planned.at("lon")).c_str(),
                cell(planned.at("position_error_m"), "%.0f").c_str());
  }
  for (const json& escape : surfacing.at("escapes")) {
    if (escape.at("time_s") == 0.0) continue;
    const json& to = escape.at("to");
    std::printf("escape from waypoint %s: course %s, %s km to %s %s, %s, %s MJ\n",
                label(escape.at("waypoint")).c_str(), cell(escape.at("course_deg"), "%.1f").c_str(),
                cell(escape.at("distance_m"), "%.2f", 1e-3).c_str(), geo::latitude_text(to[1]).c_str(),
                geo::longitude_text(to[0]).c_str(), duration(escape.at("time_s")).c_str(),
                cell(escape.value("energy_j", json()), "%.3f", 1e-6).c_str());
  }
}

/// Prints the cost of a weight on encounters, and the icebergs that the route passes under.
void print_passages(const json& plan) {
  if (const json trade = plan.value("encounter_trade", json()); !trade.is_null()) {
    const json& before = trade.at("before");
    std::printf("without the weight on encounters: %s, %s encounters expected\n",
                duration(before.at("travel_time_s")).c_str(),
                cell(before.at("iceberg_encounters"), "%.2g").c_str());
  }
  for (const json& under : plan.value("passed_under", json::array())) {
    std::printf("under iceberg %s from %s to %s: keel at %s m at most, dives turn at %s m\n",
                under.at("iceberg").get<std::string>().c_str(), under.at("from").get<std::string>().c_str(),
                under.at("until").get<std::string>().c_str(),
                cell(under.at("deepest_keel_m"), "%.0f").c_str(),
                cell(std::ceil(under.at("upper_turn_m").get<double>()), "%.0f").c_str());
  }
}

std::vector<std::string> uncertainty_lines(const json& plan) {
  const json& spread = plan.at("uncertainty");
  if (spread.is_null()) return {};
  std::vector<std::string> lines{cell(spread.at("arrived"), "%.0f") + " of " +
                                 cell(spread.at("members"), "%.0f") + " members arrive: mean " +
                                 duration(spread.at("mean_s")) + ", standard deviation " +
                                 duration(spread.at("standard_deviation_s")) + ", 90 % within " +
                                 duration(spread.at("quantiles_s").at("p90"))};
  if (!spread.at("chance").is_null()) {
    lines.push_back("chance to be there by " + spread.at("arrive_before").get<std::string>() + ": " +
                    cell(spread.at("chance"), "%.0f %%", 100.0));
  }
  return lines;
}

std::vector<std::string> clearance_lines(const json& plan) {
  const json& clearances = plan.at("clearances");
  std::string known;
  for (const auto& [name, to] :
       {std::pair{"iceberg_m", "icebergs"}, {"land_m", "land"}, {"bottom_m", "the sea bed"}}) {
    const json& clearance = clearances.at(name);
    if (!clearance.is_number()) continue;
    known += (known.empty() ? "least distance " : ", ") + std::string{"to "} + to + ' ' +
             core::distance_text(core::Metres{clearance.get<double>()});
  }
  std::vector<std::string> lines;
  if (!known.empty()) lines.push_back(std::move(known));
  if (const json expected = plan.value("iceberg_encounters", json()); expected.is_number())
    lines.push_back("expected encounters with icebergs (closer than the margin): " + cell(expected, "%.2g"));
  return lines;
}

/// The lines of a summary below the waypoints.
std::vector<std::string> figure_lines(const json& plan) {
  std::vector<std::string> lines;
  for (const auto& part :
       {energy_lines(plan), uncertainty_lines(plan), clearance_lines(plan), ice_lines(plan)})
    lines.insert(lines.end(), part.begin(), part.end());
  return lines;
}

/// The messages of a rank as lines: "caution: ...".
std::vector<std::string> message_lines(const json& plan, messages::Rank rank) {
  const std::string name{messages::rank_name(rank)};
  std::vector<std::string> lines;
  for (const json& message : plan.at("messages")) {
    if (message.at("rank") == name) lines.push_back(name + ": " + message.at("text").get<std::string>());
  }
  return lines;
}

void print_each(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) std::printf("%s\n", line.c_str());
}

/// Prints all dangers, and as many cautions as fit in the summary.
void print_gravest(const json& plan, std::size_t other_lines) {
  const std::vector<std::string> dangers = message_lines(plan, messages::Rank::danger);
  std::vector<std::string> cautions = message_lines(plan, messages::Rank::caution);
  print_each(dangers);
  const std::size_t taken = dangers.size() + other_lines;
  const std::size_t room = most_summary_lines > taken ? most_summary_lines - taken : 0;
  if (cautions.size() > room) {
    const std::size_t shown = room > 0 ? room - 1 : 0;
    const std::size_t more = cautions.size() - shown;
    cautions.resize(shown);
    cautions.push_back(std::to_string(more) + (more == 1 ? " more caution" : " more cautions") +
                       ": see --verbose");
  }
  print_each(cautions);
}

std::string headline(const json& plan) {
  const std::string id = plan.at("plan_id").is_string() ? plan.at("plan_id").get<std::string>() : "";
  return (id.empty() ? "route" : id) + "  " + plan.at("departure").get<std::string>() + " to " +
         plan.at("arrival").get<std::string>() + ", " + duration(plan.at("travel_time_s")) + ", " +
         cell(plan.at("distance_m"), "%.1f km", 1e-3);
}

void print_summary(const json& plan) {
  std::vector<std::string> below = figure_lines(plan);
  const std::vector<std::string> departures = departure_lines(plan);
  below.insert(below.end(), departures.begin(), departures.end());
  const std::vector<std::string> alternatives = codec::alternative_lines(plan);
  below.insert(below.end(), alternatives.begin(), alternatives.end());
  below.emplace_back("--verbose adds notes, refinement, surfacings and data");
  const std::vector<std::string> waits = wait_lines(plan);
  std::printf("%s\n", headline(plan).c_str());
  print_gravest(plan, 1 + waits.size() + below.size());
  print_table(plan);
  print_each(waits);
  print_each(below);
}

void print_everything(const json& plan) {
  std::printf("%s\n", headline(plan).c_str());
  for (const messages::Rank rank : {messages::Rank::danger, messages::Rank::caution, messages::Rank::note})
    print_each(message_lines(plan, rank));
  print_table(plan);
  print_each(wait_lines(plan));
  print_each(figure_lines(plan));
  print_each(codec::alternative_lines(plan));
  print_refinement(plan);
  std::printf("%s\n", optimality_line(plan).c_str());
  print_passages(plan);
  print_surfacings(plan);
  for (const json& dataset : plan.at("datasets")) {
    std::printf("data: %s (%s)\n", dataset.at("id").get<std::string>().c_str(),
                dataset.at("name").get<std::string>().c_str());
  }
  print_departures(plan);
}

/// The place and the reason, the advice, and one line for each change of the request that makes a plan possible.
std::string why_no_plan(const json& document) {
  const json& at = document.at("at");
  std::string text = document.at("explanation").get<std::string>() +
                     "\n  where: " + geo::latitude_text(at.at("lat")) + ' ' +
                     geo::longitude_text(at.at("lon"));
  if (const std::string hint = document.at("suggestion"); !hint.empty()) text += "\n  what to do: " + hint;
  for (const json& change : document.at("changes")) {
    text += "\n  would help: " + change.at("text").get<std::string>();
  }
  if (document.at("changes_cut_short") == true) {
    text += document.at("changes").empty()
                ? "\n  The search for changes that would help reached its limit. Other changes may help."
                : "\n  The search for changes reached its limit. Smaller changes may help.";
  }
  return text;
}

}  // namespace

std::function<PlanOutput()> add_plan_output(CLI::App& command) {
  const CLI::Option* json_out = command.add_flag("--json")->description("Answer with one JSON document");
  const CLI::Option* verbose =
      command.add_flag("--verbose")->description("Print all that is known of the plan");
  return [json_out, verbose] {
    if (json_out->count() > 0) return PlanOutput::json;
    return verbose->count() > 0 ? PlanOutput::everything : PlanOutput::summary;
  };
}

int print_plan(const json& document, PlanOutput output) {
  const bool ok = document.at("status") == "ok";
  if (output == PlanOutput::json) {
    std::cout << document.dump(2) << '\n';
  } else if (!ok) {
    print_departures(document);
  } else if (output == PlanOutput::everything) {
    print_everything(document);
  } else {
    print_summary(document);
  }
  if (ok) return done;
  return complain<"no-plan-found">(could_not, why_no_plan(document));
}

void print_messages(const json& document) {
  for (const json& message : document.at("messages")) {
    std::printf("%s: %s\n", message.at("rank").get<std::string>().c_str(),
                message.at("text").get<std::string>().c_str());
  }
}

}  // namespace floeplan::cli
