#include "api/fields/request_fields.hpp"

/// Rows for icebergs and sea ice.
namespace floeplan::fields {
namespace {

using planning::IcebergRules;
using planning::UnderIceRules;
using repository::EnvironmentQuery;

constexpr double day_s = 86'400.0;

/// A row of the member `under_ice`.
template <class Access>
Bound<UnderIceRules> under_ice(Field field, Access access) {
  field.object = "under_ice";
  return bound<UnderIceRules>(std::move(field), access);
}

}  // namespace

const Table<IcebergRules>& margin_fields() {
  static const Table<IcebergRules> table{
      bound<IcebergRules>({.name = "margin_m",
                           .unit = "m",
                           .most = 100'000.0,
                           .flag = "margin",
                           .help = "Distance to keep from the edge of an iceberg",
                           .form = {"Iceberg margin", "m"}},
                          [](auto& rules) -> auto& { return rules.margin; }),
  };
  return table;
}

const Table<IcebergRules>& iceberg_fields() {
  static const Table<IcebergRules> table = in_group<IcebergRules>(
      group::ice,
      {
          bound<IcebergRules>({.name = "icebergs_drift",
                               .flag = "no-iceberg-drift",
                               .help = "Let icebergs drift and their position errors grow",
                               .details = "Without it each stays where it was seen",
                               .form = {"Let icebergs drift and positions age"}},
                              [](auto& rules) -> auto& { return rules.drift; }),
          bound<IcebergRules>({.name = "max_inflation_m",
                               .unit = "m",
                               .most = 100'000.0,
                               .flag = "max-inflation",
                               .help = "Largest allowance for the position error of an iceberg",
                               .form = {"Max. position allowance", "m"}},
                              [](auto& rules) -> auto& { return rules.max_inflation; }),
          bound<IcebergRules>(
              {.name = "pass_under_icebergs",
               .flag = "pass-under",
               .help = "Pass under icebergs of known size with keels well above the dive depth",
               .details = "The dives turn keel_clearance_m below the deepest keel across the whole disc. The "
                          "sea must be deep enough below that turn, and the vehicle must not surface there; "
                          "this time counts for under_ice.max_time_without_surfacing_s. The route never "
                          "passes under an iceberg of unknown size, or under one with its disc over the "
                          "start, the goal or a via point. The currents are those of the usual dives",
               .form = {"Pass under icebergs of known draft"}},
              [](auto& rules) -> auto& { return rules.pass_under; }),
          bound<IcebergRules>({.name = "keel_clearance_m",
                               .unit = "m",
                               .most = 1000.0,
                               .flag = "keel-clearance",
                               .help = "Distance to keep below the deepest keel when passing under",
                               .form = {"Clearance below keel", "m"}},
                              [](auto& rules) -> auto& { return rules.keel_clearance; }),
          bound<IcebergRules>({.name = "draft_uncertainty",
                               .unit = "share",
                               .most = 2.0,
                               .flag = "draft-uncertainty",
                               .help = "Share added to every iceberg's draft when passing under",
                               .details = "The draft is the stated one, or the largest for its length",
                               .form = {"Draft error", "%"}},
                              [](auto& rules) -> auto& { return rules.draft_uncertainty; }),
      });
  return table;
}

const Table<IcebergRules>& encounter_fields() {
  static const Table<IcebergRules> table = in_group<IcebergRules>(
      group::ice,
      {
          bound<IcebergRules>(
              {.name = "encounter_weight_s",
               .unit = "s",
               .most = 1e7,
               .flag = "encounter-weight",
               .help = "Travel time that one expected encounter with an iceberg counts as",
               .details = "The fastest plan is made, too. It is replaced only by a plan with no more "
                          "expected encounters and a lower cost; encounter_trade describes both",
               .form = {"An expected encounter counts as",
                        "h",
                        {},
                        "Extra travel time that is worth one encounter less."}},
              [](auto& rules) -> auto& { return rules.encounter_weight; }),
      });
  return table;
}

const Table<EnvironmentQuery>& sighting_fields() {
  static const Table<EnvironmentQuery> table = in_group<EnvironmentQuery>(
      group::ice,
      {
          {.field = {.name = "max_sighting_age_days",
                     .kind = Kind::number,
                     .unit = "days",
                     .most = ocean::largest_sighting_age.count() / day_s,
                     .usual = EnvironmentQuery{}.max_sighting_age.count() / day_s,
                     .flag = "max-sighting-age",
                     .help = "Ignore icebergs last seen longer than this before the departure",
                     .details = "Counted from icebergs_as_of if that is earlier, in whole UTC days",
                     .form = {"Max. sighting age", "days"}},
           .set =
               [](auto& query, const Value& days) {
                 query.max_sighting_age = core::Seconds{std::get<double>(days) * day_s};
               },
           .get = [](const auto& query) { return query.max_sighting_age.count() / day_s; }},
      });
  return table;
}

const Table<UnderIceRules>& passing_under_ice_fields() {
  static const Table<UnderIceRules> table = in_group<UnderIceRules>(
      group::ice,
      {
          under_ice({.name = "max_concentration_to_surface",
                     .unit = "share",
                     .most = 1.0,
                     .flag = "max-concentration-to-surface",
                     .help = "Share of sea ice up to which the vehicle may surface",
                     .form = {"Surface up to", "% ice"}},
                    [](auto& rules) -> auto& { return rules.max_concentration_to_surface; }),
          under_ice({.name = "margin_below_ice_m",
                     .unit = "m",
                     .most = 500.0,
                     .flag = "margin-below-ice",
                     .help = "Distance to keep between the deepest keel and the upper turn of the dives",
                     .form = {"Clearance below ice", "m"}},
                    [](auto& rules) -> auto& { return rules.margin_below_ice; }),
          under_ice({.name = "draft_if_unknown_m",
                     .unit = "m",
                     .most = 500.0,
                     .help = "Assumed deepest keel where the data have no thickness",
                     .form = {"Unknown draft", "m"}},
                    [](auto& rules) -> auto& { return rules.draft_if_unknown; }),
          under_ice({.name = "max_time_without_surfacing_s",
                     .unit = "s",
                     .least = 60.0,
                     .most = 3.2e7,
                     .flag = "max-time-without-surfacing",
                     .help = "Longest time between places where the vehicle may surface",
                     .form = {"Max. time without surfacing", "h", "no limit"}},
                    [](auto& rules) -> auto& { return rules.max_time_without_surfacing; }),
      });
  return table;
}

const Table<UnderIceRules>& surfacing_fields() {
  static const Table<UnderIceRules> table = in_group<UnderIceRules>(
      group::ice,
      {
          under_ice({.name = "surfacing_interval_s",
                     .unit = "s",
                     .least = 60.0,
                     .most = 3.2e7,
                     .flag = "surfacing-interval",
                     .help = "Time between planned surfacings, approximately",
                     .form = {"Surface every", "h", "not planned"}},
                    [](auto& rules) -> auto& { return rules.surfacing_interval; }),
          under_ice({.name = "escape_plan",
                     .flag = "escape-plan",
                     .help = "Find an escape route from every waypoint to where the vehicle may surface",
                     .form = {"Escape route from every waypoint"}},
                    [](auto& rules) -> auto& { return rules.escape_plan; }),
          under_ice({.name = "dead_reckoning_share",
                     .unit = "share",
                     .most = 1.0,
                     .help = "Dead-reckoning error, as a share of the distance through water",
                     .form = {"Dead-reckoning error", "%"}},
                    [](auto& rules) -> auto& { return rules.dead_reckoning_share; }),
          under_ice({.name = "current_uncertainty_m_s",
                     .unit = "m/s",
                     .most = 5.0,
                     .help = "Error of the planned currents between two fixes",
                     .form = {"Current error below", "m/s"}},
                    [](auto& rules) -> auto& { return rules.current_uncertainty; }),
      });
  return table;
}

}  // namespace floeplan::fields
