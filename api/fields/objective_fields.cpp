#include "api/fields/request_fields.hpp"

/// Rows of what to minimise, and of the energy that may be used for it.
namespace floeplan::fields {
namespace {

using planning::EnergyRules;
using planning::Objective;
using planning::ThrusterUse;

constexpr double heaviest = 1e6;

}  // namespace

const std::vector<Field>& objective_fields() {
  static const std::vector<Field> list{
      {.name = "objective",
       .usual = std::string{"time"},
       .flag = "objective",
       .group = group::vehicle,
       .help = "What to minimise: time, energy, or weights of a second and of a joule",
       .form = {"Optimise"}},
  };
  return list;
}

const Table<Objective>& weight_fields() {
  static const Table<Objective> table = in_group<Objective>(
      group::vehicle, without_usual<Objective>({
                          bound<Objective>({.name = "time",
                                            .object = "objective",
                                            .most = heaviest,
                                            .help = "Weight of a second",
                                            .form = {"A second weighs"}},
                                           [](auto& objective) -> auto& { return objective.of_time; }),
                          bound<Objective>({.name = "energy",
                                            .object = "objective",
                                            .most = heaviest,
                                            .help = "Weight of a joule",
                                            .form = {"A joule weighs"}},
                                           [](auto& objective) -> auto& { return objective.of_energy; }),
                      }));
  return table;
}

const Table<EnergyRules>& energy_fields() {
  static const Table<EnergyRules> table = in_group<EnergyRules>(
      group::vehicle,
      {
          worded<EnergyRules>(
              {.name = "thruster",
               .flag = "thruster",
               .help = "Use of the thruster (auto: as the objective requires)",
               .form = {"Thruster"}},
              std::vector<Choice<ThrusterUse>>{
                  {{"auto"}, ThrusterUse::automatic}, {{"on"}, ThrusterUse::on}, {{"off"}, ThrusterUse::off}},
              [](auto& rules) -> auto& { return rules.thruster; }),
          bound<EnergyRules>({.name = "require_battery",
                              .flag = "require-battery",
                              .help = "Refuse plans that need more energy than the battery gives",
                              .form = {"Only plans within the battery"}},
                             [](auto& rules) -> auto& { return rules.require_battery; }),
      });
  return table;
}

}  // namespace floeplan::fields
