#include "api/fields/limits.hpp"
#include "api/fields/request_fields.hpp"

/// Rows for the vehicle. They have no defaults: the profile gives the value of a field that is absent.
namespace floeplan::fields {
namespace {

using vehicle::FlightChoices;
using vehicle::GliderProfile;
using vehicle::Thruster;

template <class Access>
Bound<GliderProfile> build(Field field, Access access) {
  field.object = "vehicle";
  return bound<GliderProfile>(std::move(field), access);
}

}  // namespace

const std::vector<Field>& vehicle_fields() {
  static const std::vector<Field> list{
      {.name = "vehicle",
       .flag = "vehicle",
       .help = "Name of a vehicle profile (default slocum-g3-200)",
       .details = "Also an object with that name as profile and the members to change",
       .form = {"Vehicle"}},
  };
  return list;
}

const std::vector<Field>& profile_fields() {
  static const std::vector<Field> list{
      {.name = "profile",
       .object = "vehicle",
       .kind = Kind::text,
       .help = "Vehicle profile that the other members change"},
  };
  return list;
}

const Table<FlightChoices>& flight_fields() {
  static const Table<FlightChoices> table = in_group<FlightChoices>(
      group::vehicle,
      {
          bound<FlightChoices>({.name = "speed_m_s",
                                .unit = "m/s",
                                .least = 0.05,
                                .most = 5.0,
                                .flag = "speed",
                                .help = "Horizontal speed through the water",
                                .form = {"Water speed", "m/s"}},
                               [](auto& choices) -> auto& { return choices.speed_through_water; }),
          bound<FlightChoices>(
              {.name = "pitch_deg",
               .unit = "deg",
               .least = vehicle::least_pitch_deg,
               .most = vehicle::most_pitch_deg,
               .flag = "pitch",
               .help =
                   "Pitch of dives and climbs; without a speed, it determines the speed of the steady glide",
               .form = {"Pitch", "°"}},
              [](auto& choices) -> auto& { return choices.pitch; }),
          bound<FlightChoices>({.name = "climb_to_m",
                                .unit = "m",
                                .most = deepest_m,
                                .flag = "climb-to",
                                .help = "Upper turn of the dives",
                                .form = {"Climb to", "m"}},
                               [](auto& choices) -> auto& { return choices.climb_to; }),
          bound<FlightChoices>({.name = "dive_depth_m",
                                .unit = "m",
                                .least = 1.0,
                                .most = deepest_m,
                                .flag = "dive-depth",
                                .help = "Lower turn of the dives in deep water",
                                .form = {"Dive depth", "m"}},
                               [](auto& choices) -> auto& { return choices.dive_depth; }),
          bound<FlightChoices>({.name = "altimeter_margin_m",
                                .unit = "m",
                                .most = 1000.0,
                                .flag = "altimeter-margin",
                                .help = "Least altitude above the sea bed",
                                .form = {"Altitude", "m"}},
                               [](auto& choices) -> auto& { return choices.altimeter_margin; }),
          bound<FlightChoices>({.name = "battery_j",
                                .unit = "J",
                                .least = 1.0,
                                .most = 1e10,
                                .flag = "battery",
                                .help = "Energy of the full battery",
                                .form = {"Battery", "MJ"}},
                               [](auto& choices) -> auto& { return choices.battery; }),
          bound<FlightChoices>({.name = "battery_start_share",
                                .unit = "share",
                                .most = 1.0,
                                .flag = "battery-start",
                                .help = "State of charge at the departure, as a share of the full battery",
                                .form = {"State of charge", "%"}},
                               [](auto& choices) -> auto& { return choices.battery_start_share; }),
      });
  return table;
}

const Table<GliderProfile>& build_fields() {
  static const Table<GliderProfile> table = in_group<GliderProfile>(
      group::vehicle, without_usual<GliderProfile>({
                          build({.name = "name"}, [](auto& profile) -> auto& { return profile.name; }),
                          build({.name = "title"}, [](auto& profile) -> auto& { return profile.title; }),
                          build({.name = "buoyancy_cm3",
                                 .unit = "cm3",
                                 .least = 10.0,
                                 .most = 10'000.0,
                                 .help = "Volume pumped to either side of neutral",
                                 .form = {"Buoyancy", "cm³"}},
                                [](auto& profile) -> auto& { return profile.buoyancy; }),
                          build({.name = "parasite_drag", .least = 0.01, .most = 10.0},
                                [](auto& profile) -> auto& { return profile.hydrodynamics.parasite_drag; }),
                          build({.name = "induced_drag", .most = 100.0},
                                [](auto& profile) -> auto& { return profile.hydrodynamics.induced_drag; }),
                          build({.name = "lift_slope", .least = 0.1, .most = 100.0},
                                [](auto& profile) -> auto& { return profile.hydrodynamics.lift_slope; }),
                          build({.name = "drag_area_m2", .unit = "m2", .least = 0.001, .most = 10.0},
                                [](auto& profile) -> auto& { return profile.hydrodynamics.area_m2; }),
                          build({.name = "depth_rating_m",
                                 .unit = "m",
                                 .least = 2.0,
                                 .most = deepest_m,
                                 .help = "Depth rating; limits the dives",
                                 .form = {"Rated to", "m"}},
                                [](auto& profile) -> auto& { return profile.depth_rating; }),
                          build({.name = "minimum_working_depth_m",
                                 .unit = "m",
                                 .most = deepest_m,
                                 .help = "Shallower water is closed to the vehicle",
                                 .form = {"Least depth", "m"}},
                                [](auto& profile) -> auto& { return profile.minimum_working_depth; }),
                          build({.name = "hotel_w",
                                 .unit = "W",
                                 .most = 1000.0,
                                 .help = "Power of all systems under water, sensors included",
                                 .form = {"Hotel load", "W"}},
                                [](auto& profile) -> auto& { return profile.energy.hotel; }),
                          build({.name = "pump_efficiency",
                                 .least = 0.01,
                                 .most = 1.0,
                                 .help = "Work against the pressure, divided by the energy drawn for it"},
                                [](auto& profile) -> auto& { return profile.energy.pump_efficiency; }),
                          build({.name = "pump_loss_j_cm3", .unit = "J/cm3", .most = 1000.0},
                                [](auto& profile) -> auto& { return profile.energy.pump_loss_j_cm3; }),
                          build({.name = "intake_j_cm3", .unit = "J/cm3", .most = 1000.0},
                                [](auto& profile) -> auto& { return profile.energy.intake_j_cm3; }),
                          build({.name = "inflection_j",
                                 .unit = "J",
                                 .most = 1e6,
                                 .help = "Energy of each turn, at top and bottom"},
                                [](auto& profile) -> auto& { return profile.energy.inflection; }),
                          build({.name = "surfacing_j",
                                 .unit = "J",
                                 .most = 1e7,
                                 .help = "Energy of one surfacing: air pump, position and telemetry",
                                 .form = {"A surfacing", "kJ"}},
                                [](auto& profile) -> auto& { return profile.energy.surfacing; }),
                          build({.name = "surfacing_interval_s",
                                 .unit = "s",
                                 .least = 60.0,
                                 .most = 1e7,
                                 .help = "Time between surfacings (default: surfacings draw no energy)",
                                 .form = {"Surfaces every", "h", "not counted"}},
                                [](auto& profile) -> auto& { return profile.energy.surfacing_interval; }),
                          build({.name = "battery_reserve_share",
                                 .unit = "share",
                                 .most = 1.0,
                                 .help = "Share of the full battery to keep in reserve",
                                 .form = {"Reserve", "%"}},
                                [](auto& profile) -> auto& { return profile.energy.battery_reserve_share; }),
                          build({.name = "max_waypoints_per_list",
                                 .least = 1.0,
                                 .most = 10'000.0,
                                 .help = "Waypoints in one goto list",
                                 .form = {"Waypoints per list"}},
                                [](auto& profile) -> auto& { return profile.max_waypoints_per_list; }),
                      }));
  return table;
}

const Table<Thruster>& thruster_fields() {
  static const Table<Thruster> table = without_usual<Thruster>({
      bound<Thruster>(
          {.name = "speed_m_s", .object = "vehicle/thruster", .unit = "m/s", .least = 0.05, .most = 5.0},
          [](auto& thruster) -> auto& { return thruster.speed; }),
      bound<Thruster>({.name = "power_w", .object = "vehicle/thruster", .unit = "W", .most = 10'000.0},
                      [](auto& thruster) -> auto& { return thruster.power; }),
  });
  return table;
}

}  // namespace floeplan::fields
