#include "engine/mission/writing/ice_files.hpp"

#include <algorithm>
#include <cmath>

#include "engine/messages/export_messages.hpp"
#include "engine/messages/mission_fault_messages.hpp"
#include "engine/mission/document/packed_degrees.hpp"
#include "engine/mission/writing/argument_lines.hpp"
#include "engine/mission/writing/below_ice.hpp"
#include "engine/mission/writing/flight_files.hpp"
#include "engine/mission/writing/goto_lists.hpp"

namespace floeplan::mission {
namespace {

constexpr int recovery_list = 98;            // flown by the stock mission recov.mi
constexpr std::size_t most_safe_places = 8;  // slots of a goto list in the vendor's data dictionary
constexpr const char* recovery_radius_m = "500";
constexpr double max_latitude_deg = 89.0;
constexpr double watchdog_s = 48'600.0;            // no_cop_tickle_for, default in the dictionary
constexpr core::Metres stock_iceberg_depth{20.0};  // the vendor's stock settings
constexpr Firmware first_with_ice{10, 0};          // the stock ice missions date from 2018

bool knows_of_ice(const planning::Plan& plan) {
  return std::ranges::find(plan.datasets, "ice", &ocean::DatasetRef::kind) != plan.datasets.end();
}

}  // namespace

std::string ice_settings_name(const MissionSetOptions& options) {
  return "ice_" + argument_file_name("yo", options.lists.first_number).substr(2, 2) + ".mi";
}

core::Metres expected_iceberg_depth(const planning::Plan& plan, const MissionSetOptions& options) {
  const UnderIce& ice = *options.under_ice;
  return ice.deepest_expected_iceberg.value_or(
      std::max(stock_iceberg_depth, deepest_keel(plan, ice.margin_below_ice)));
}

std::string ice_settings(const planning::Plan& plan, const MissionSetOptions& options) {
  const geo::LonLat refuge = options.under_ice->safe_places.front();
  return "sensor: u_expect_ice_near_surface(bool) 1\n"
         "sensor: u_always_cop_tickle_hardware(bool) 1\n"
         "sensor: u_lat_goto_l99(lat) " +
         packed_degrees(refuge.lat_deg) + "\nsensor: u_lon_goto_l99(lon) " +
         packed_degrees(geo::wrap_longitude(refuge.lon_deg)) + "\nsensor: u_max_expected_iceberg_depth(m) " +
         whole(std::ceil(expected_iceberg_depth(plan, options).value)) + "\n";
}

std::vector<MissionFile> ice_files(const planning::Plan& plan, const MissionSetOptions& options) {
  const UnderIce& ice = *options.under_ice;
  const std::string origin = origin_comments(plan, options.lists.origin);
  const std::string name = argument_file_name("goto_list", recovery_list);
  const auto rows = static_cast<double>(ice.safe_places.size());
  return {{name, argument_file("goto_list",
                               "# " + name + ": open water to recover to, flown by recov.mi\n" + origin,
                               {{"num_legs_to_run", "-1"},
                                {"start_when", "0"},
                                {"list_stop_when", "7"},
                                {"list_when_wpt_dist", recovery_radius_m},
                                {"initial_wpt", "-2"},
                                {"num_waypoints", whole(rows)}}) +
                     waypoint_section(ice.safe_places)},
          {ice_settings_name(options),
           "# " + ice_settings_name(options) +
               ": settings for ice; load with loadmission, or copy into autoexec.mi so "
               "that\n# they survive a reset under water\n" +
               origin + ice_settings(plan, options)}};
}

core::Violations ice_violations(const planning::Plan& plan, const MissionSetOptions& options) {
  core::Violations found;
  if (!options.under_ice) return found;
  const UnderIce& ice = *options.under_ice;
  if (options.firmware < first_with_ice)
    found.push_back(messages::mission_fault<"firmware-without-ice">("/firmware"));
  if (ice.safe_places.empty() || ice.safe_places.size() > most_safe_places) {
    found.push_back(messages::mission_fault<"wrong-number-of-safe-places">("/safe"));
  }
  for (std::size_t i = 0; i < ice.safe_places.size(); ++i) {
    if (!geo::is_valid(ice.safe_places[i]) || std::abs(ice.safe_places[i].lat_deg) > max_latitude_deg)
      found.push_back(messages::mission_fault<"safe-place-near-pole">("/safe/" + std::to_string(i)));
  }
  const double draft_m = expected_iceberg_depth(plan, options).value;
  if (!(draft_m > 0.0 && draft_m < target_depth(options.vehicle).value))
    found.push_back(messages::mission_fault<"wrong-iceberg-depth">("/iceberg_depth_m"));
  const double keel_m = std::ceil(deepest_keel(plan, ice.margin_below_ice).value);
  if (std::ceil(draft_m) < keel_m) {
    found.push_back(messages::mission_fault<"iceberg-depth-too-small">("/iceberg_depth_m", keel_m));
  }
  return found;
}

std::vector<messages::Message> ice_warnings(const planning::Plan& plan, const MissionSetOptions& options) {
  std::vector<messages::Message> told{messages::export_message<"stock-missions-needed">(),
                                      messages::export_message<"safe-list-replaced">()};
  if (surfaces_on_the_way(plan, options)) {
    const double interval_h = time_between_surfacings(options).count() / 3600.0;
    told.push_back(knows_of_ice(plan) ? messages::export_message<"no-ice-on-route">(interval_h)
                                      : messages::export_message<"safe-places-without-ice-data">(interval_h));
    return told;
  }
  const double silent_s = longest_list_time(plan, options.lists).count();
  if (silent_s > watchdog_s)
    told.push_back(messages::export_message<"watchdog-not-held-off">(silent_s / 3600.0));
  if (plan.surfacing && !plan.surfacing->surfacings.empty())
    told.push_back(messages::export_message<"surfacings-not-in-files">(plan.surfacing->surfacings.size()));
  return told;
}

}  // namespace floeplan::mission
