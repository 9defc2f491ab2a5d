#include "api/fields/limits.hpp"
#include "api/fields/request_fields.hpp"

/// Rows for the uncertainty of the currents, and how a plan takes it into account.
namespace floeplan::fields {
namespace {

using planning::RobustObjective;
using planning::UncertaintyRules;

/// A row of the member `uncertainty`.
template <class Access>
Bound<UncertaintyRules> uncertainty(Field field, Access access) {
  field.object = "uncertainty";
  return bound<UncertaintyRules>(std::move(field), access);
}

}  // namespace

const Table<UncertaintyRules>& error_model_fields() {
  static const Table<UncertaintyRules> table = in_group<UncertaintyRules>(
      group::uncertainty,
      without_usual<UncertaintyRules>({
          uncertainty({.name = "members",
                       .least = 2.0,
                       .most = 64.0,
                       .flag = "members",
                       .help = "Number of random errors of the currents to draw; the plan shows the spread",
                       .form = {"Members", "2–64", "none"}},
                      [](auto& rules) -> auto& { return rules.drawn_members; }),
          uncertainty({.name = "current_error_m_s",
                       .unit = "m/s",
                       .least = 1e-3,
                       .most = 2.0,
                       .flag = "current-error",
                       .help = "Standard deviation of each component's error",
                       .example = "0.05",
                       .form = {"Error of each component", "m/s"}},
                      [](auto& rules) -> auto& { return rules.error.standard_deviation; }),
          uncertainty({.name = "length_scale_m",
                       .unit = "m",
                       .least = 1e3,
                       .most = 1e6,
                       .flag = "error-length",
                       .help = "Correlation length of the error",
                       .example = "30000",
                       .form = {"Correlation length", "km"}},
                      [](auto& rules) -> auto& { return rules.error.length_scale; }),
          uncertainty({.name = "time_scale_s",
                       .unit = "s",
                       .least = 600.0,
                       .most = 2'592'000.0,
                       .flag = "error-time",
                       .help = "Correlation time of the error",
                       .example = "43200",
                       .form = {"Correlation time", "h"}},
                      [](auto& rules) -> auto& { return rules.error.time_scale; }),
          uncertainty({.name = "seed",
                       .most = largest_seed,
                       .help = "Seed of the random errors; default 1",
                       .form = {"Seed", {}, "1"}},
                      [](auto& rules) -> auto& { return rules.seed; }),
      }));
  return table;
}

const Table<UncertaintyRules>& robustness_fields() {
  static const Table<UncertaintyRules> table = in_group<UncertaintyRules>(
      group::uncertainty,
      {
          worded<UncertaintyRules>(
              {.name = "objective",
               .object = "uncertainty",
               .flag = "robust",
               .help = "Statistic of the cost over all members that the route minimises; if omitted, the "
                       "first member alone counts",
               .form = {"Plan for"}},
              std::vector<Choice<RobustObjective>>{{{"mean"}, RobustObjective::mean},
                                                   {{"quantile"}, RobustObjective::quantile}},
              [](auto& rules) -> auto& { return rules.objective; }),
          uncertainty(
              {.name = "quantile",
               .unit = "share",
               .least = 0.01,
               .most = 0.99,
               .help =
                   "Share of members that arrive by the planned time; only with the objective \"quantile\"",
               .form = {"Quantile", "%"}},
              [](auto& rules) -> auto& { return rules.quantile; }),
          uncertainty({.name = "arrive_before",
                       .flag = "arrive-before",
                       .help = "Show the chance of arriving by this time",
                       .form = {"Chance to arrive before", "UTC", "not asked"}},
                      [](auto& rules) -> auto& { return rules.arrive_before; }),
      });
  return table;
}

}  // namespace floeplan::fields
