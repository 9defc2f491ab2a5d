#include "engine/simulation/vehicle/mission_orders.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string_view>

#include "engine/core/letter_case.hpp"
#include "engine/core/violation_list.hpp"
#include "engine/messages/flight_fault_messages.hpp"
#include "engine/messages/flight_messages.hpp"
#include "engine/mission/document/argument_rules.hpp"
#include "engine/mission/document/behavior_table.hpp"
#include "engine/mission/writing/goto_lists.hpp"

namespace floeplan::simulation {
namespace {

using mission::Behavior;
using mission::Document;
using mission::DocumentKind;

constexpr double cm3 = 1e-6;
/// Larger than any code or count in a mission.
constexpr double largest_code = 1e6;

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%g", value);
  return buffer;
}

std::string file_name(std::string_view behavior, int number) {
  char buffer[16];
  std::snprintf(buffer, sizeof buffer, "%02d.ma", number);
  return std::string{mission::file_prefix(behavior)} + buffer;
}

int whole(double value) {
  return static_cast<int>(std::lround(std::clamp(value, -largest_code, largest_code)));
}

/// The arguments of one behavior from all sources: its file, the mission, the dictionary's defaults.
class Arguments {
 public:
  Arguments(const Behavior& own, const Document* file, std::string where)
      : own_{own}, file_{file}, where_{std::move(where)} {}

  [[nodiscard]] std::optional<double> find(std::string_view name) const {
    if (file_ != nullptr && !file_->behaviors.empty()) {
      if (const auto* found = file_->behaviors.front().find(name)) return found->value;
    }
    if (const auto* found = own_.find(name)) return found->value;
    const mission::BehaviorRule* rule = mission::find_behavior(own_.name);
    const mission::ArgumentRule* argument = rule != nullptr ? rule->find(name) : nullptr;
    return argument != nullptr ? argument->by_default : std::nullopt;
  }
  [[nodiscard]] double value(std::string_view name, double otherwise) const {
    return find(name).value_or(otherwise);
  }
  [[nodiscard]] int code(std::string_view name, int otherwise) const { return whole(value(name, otherwise)); }
  /// The value of an argument; empty if it stands for a parameter that another program on board sets.
  [[nodiscard]] std::optional<double> known(std::string_view name) const {
    const auto found = find(name);
    return found && mission::is_mission_parameter(*found) ? std::nullopt : found;
  }
  /// The file, or the place in the mission, that contains the arguments; for messages.
  [[nodiscard]] const std::string& where() const { return where_; }

 private:
  const Behavior& own_;
  const Document* file_;
  std::string where_;
};

class Reader {
 public:
  Reader(std::span<const Document> documents, const vehicle::GliderProfile& vehicle)
      : documents_{documents}, vehicle_{vehicle} {}

  tl::expected<MissionOrders, core::Violations> read() {
    refuse_unusable();
    if (!found_.empty()) return tl::unexpected(std::move(found_));

    const auto mission = std::ranges::find(documents_, DocumentKind::mission, &Document::kind);
    if (mission != documents_.end()) {
      orders_.name = mission->name;
      read_mission(*mission);
    } else {
      read_loose_files();
    }
    if (orders_.lists.empty()) refuse<"no-list-to-fly">("/files");
    if (!has_yo_) take_yo_of_vehicle(mission != documents_.end());
    if (orders_.surfaces.empty()) take_surfacing_at_the_end();
    if (!found_.empty()) return tl::unexpected(std::move(found_));
    return std::move(orders_);
  }

 private:
  template <messages::Code code, class... Given>
  void refuse(std::string field, const Given&... values) {
    core::note(found_, messages::flight_fault<code>(std::move(field), values...));
  }

  void refuse_unusable() {
    if (documents_.empty()) refuse<"no-mission-and-no-list">("/files");
    std::size_t missions = 0;
    for (const Document& document : documents_) {
      if (document.kind == DocumentKind::mission) ++missions;
      if (document.kind != DocumentKind::mission && document.kind != DocumentKind::arguments) {
        refuse<"file-of-seaglider">("/files/" + document.name, vehicle_.title);
      }
      for (const mission::Message& message : document.messages) {
        if (message.severity != mission::Severity::error) continue;
        refuse<"mission-line-refused">("/files/" + document.name, message.line, message.text);
      }
    }
    if (missions > 1) refuse<"several-missions">("/files", missions);
  }

  [[nodiscard]] const Document* document(const std::string& name) const {
    const auto found =
        std::ranges::find_if(documents_, [&](const Document& d) { return core::lower_case(d.name) == name; });
    return found == documents_.end() ? nullptr : &*found;
  }

  void read_mission(const Document& mission) {
    for (const mission::Argument& sensor : mission.sensors) {
      if (sensor.name == "u_use_current_correction") orders_.corrects_for_current = sensor.value != 0.0;
    }
    for (const Behavior& behavior : mission.behaviors) {
      const auto* number = behavior.find("args_from_file");
      const Document* file = nullptr;
      std::string where = mission.name;
      if (number != nullptr && number->value >= 0.0) {
        where = file_name(behavior.name, whole(number->value));
        file = document(where);
        if (file == nullptr && matters(behavior.name)) {
          refuse<"file-asked-for-missing">("/files/" + mission.name, where, behavior.line);
          has_yo_ = has_yo_ || behavior.name == "yo";
          continue;
        }
      }
      read_behavior(behavior, Arguments{behavior, file, where}, file != nullptr ? *file : mission);
      if (file != nullptr && behavior.name == "goto_list") read_lists_after(whole(number->value));
    }
  }

  /// Reads the lists numbered after the one that the mission names: the pilot sends each when the one before
  /// is flown.
  void read_lists_after(int number) {
    for (int next = number + 1; next <= mission::last_free_number; ++next) {
      const std::string where = file_name("goto_list", next);
      const Document* file = document(where);
      if (file == nullptr || file->behaviors.empty()) return;
      read_list(Arguments{file->behaviors.front(), file, where}, *file);
      note(
          "Further goto lists are flown as if each were sent while the vehicle is up at the end of the one "
          "before.");
    }
  }

  void read_loose_files() {
    orders_.name = documents_.front().name;
    for (const Document& document : documents_) {
      for (const Behavior& behavior : document.behaviors)
        read_behavior(behavior, Arguments{behavior, &document, document.name}, document);
    }
  }

  static bool matters(const std::string& behavior) {
    return behavior == "goto_list" || behavior == "yo" || behavior == "surface";
  }

  void read_behavior(const Behavior& behavior, const Arguments& arguments, const Document& rows) {
    if (behavior.name == "goto_list") {
      read_list(arguments, rows);
    } else if (behavior.name == "yo") {
      read_yo(arguments);
    } else if (behavior.name == "surface") {
      read_surface(arguments);
    } else if (behavior.name == "abend") {
      const double overdepth_m = arguments.value("overdepth", -1.0);
      if (overdepth_m >= 0.0) orders_.overdepth = core::Metres{overdepth_m};
      const double same_depth_s = arguments.value("samedepth_for", -1.0);
      if (same_depth_s >= 0.0) orders_.same_depth = core::Seconds{same_depth_s};
      const double farthest_m = arguments.value("max_wpt_distance", -1.0);
      if (farthest_m >= 0.0) orders_.max_waypoint = core::Metres{farthest_m};
    } else if (behavior.name == "sample") {
      note(messages::flight_text<"sampling-not-simulated">());
    } else if (behavior.name != "prepare_to_dive" && behavior.name != "sensors_in") {
      orders_.notes.push_back(
          messages::flight_text<"behavior-not-simulated">(behavior.name, arguments.where()));
    }
  }

  void read_list(const Arguments& arguments, const Document& rows) {
    GotoOrders list;
    for (const mission::WaypointRow& row : rows.waypoints) list.waypoints.push_back(row.place);
    if (list.waypoints.empty()) return;
    list.radius = {arguments.value("list_when_wpt_dist", 10.0)};
    auto flown = mission::list_orders(arguments.known("num_legs_to_run"), arguments.known("initial_wpt"),
                                      list.waypoints.size());
    if (!flown) {
      flown.error().field = "/files/" + arguments.where() + "/" + flown.error().field;
      return core::note(found_, std::move(flown.error()));
    }
    list.rows = *flown;
    list.hold = mission::hold_order(rows);
    if (list.hold && list.hold->planned) note(messages::flight_text<"list-sent-near-end-of-hold">());
    orders_.lists.push_back(std::move(list));
  }

  HalfYo half(const Arguments& arguments, const std::string& prefix, double sign, bool to_surface) {
    const std::string field = "/files/" + arguments.where() + "/" + prefix;
    HalfYo half;
    if (!to_surface) {
      half.depth = {arguments.value(prefix + "target_depth", sign > 0.0 ? 3.0 : 12.0)};
      const double altitude_m = arguments.value(prefix + "target_altitude", -1.0);
      if (altitude_m >= 0.0) half.altitude = core::Metres{altitude_m};
      if (mission::is_mission_parameter(half.depth.value)) {
        refuse<"depth-of-another-program">(field + "target_depth");
      } else if (half.depth > vehicle_.depth_rating) {
        refuse<"deeper-than-rating">(field + "target_depth", text(half.depth.value), vehicle_.title,
                                     text(vehicle_.depth_rating.value));
      }
    }
    // Code 3: held by servo, in radians. Code 2: set once from a curve. Code 1 gives the battery's position
    // in inches, which needs the vehicle's own calibration, so its usual pitch is used.
    const int pitch_code = arguments.code(prefix + "use_pitch", 3);
    half.pitch_rad = sign * std::abs(arguments.value(prefix + "pitch_value", vehicle_.pitch.value));
    if (pitch_code != 2 && pitch_code != 3) {
      half.pitch_rad = sign * vehicle_.pitch.value;
      note(messages::flight_text<"pitch-without-calibration">(
          text(core::radians_to_degrees(vehicle_.pitch.value))));
    } else if (!(std::abs(half.pitch_rad) <= 0.5 * std::numbers::pi)) {
      refuse<"wrong-pitch">(field + "pitch_value");
    }
    const int pump_code = arguments.code(prefix + "use_bpump", 2);
    const double asked_m3 = pump_code == 2 || pump_code == 3
                                ? std::abs(arguments.value(prefix + "bpump_value", 1000.0)) * cm3
                                : vehicle_.buoyancy.value;
    half.buoyancy_m3 = sign * std::min(asked_m3, vehicle_.buoyancy.value);
    half.thruster = arguments.code(prefix + "use_thruster", 0) != 0;
    if (half.thruster && !vehicle_.thruster)
      refuse<"yo-without-thruster">(field + "use_thruster", vehicle_.title);
    return half;
  }

  void read_yo(const Arguments& arguments) {
    if (has_yo_) return note(messages::flight_text<"second-yo-not-simulated">());
    has_yo_ = true;
    orders_.yo.dive = half(arguments, "d_", -1.0, false);
    orders_.yo.climb = half(arguments, "c_", 1.0, false);
    orders_.yo.half_cycles = arguments.code("num_half_cycles_to_do", -1);
    orders_.yo.dives_first = arguments.code("start_diving", 1) != 0;
    if (!(orders_.yo.climb.depth < orders_.yo.dive.depth))
      refuse<"climb-below-dive">("/files/" + arguments.where() + "/c_target_depth");
  }

  void read_surface(const Arguments& arguments) {
    SurfaceOrders surface;
    const int when = arguments.code("start_when", 12);
    using Cause = SurfaceOrders::Cause;
    switch (when) {
      case 1: surface.cause = Cause::any_idle; break;
      case 2:
      case 4: surface.cause = Cause::yo_idle; break;
      case 3: surface.cause = Cause::list_idle; break;
      case 6: surface.cause = Cause::after_end; break;
      case 7: surface.cause = Cause::near_waypoint; break;
      case 8: surface.cause = Cause::waypoint_hit; break;
      case 9:
      case 10: surface.cause = Cause::every; break;
      case 12: surface.cause = Cause::no_contact; break;
      case 16: surface.cause = Cause::inflections; break;
      case 5:
      case 11: return;  // never, or when science asks, which nothing does here
      default: return note(messages::flight_text<"surfacing-not-simulated">(when, arguments.where()));
    }
    const bool timed = surface.cause == Cause::after_end || surface.cause == Cause::every ||
                       surface.cause == Cause::no_contact;
    surface.interval = core::Seconds{arguments.value("when_secs", 1200.0)};
    if (timed && !(surface.interval.count() >= 120.0))
      refuse<"surfacings-too-often">("/files/" + arguments.where() + "/when_secs");
    surface.distance = {arguments.value("when_wpt_dist", 10.0)};
    surface.turns = arguments.code("when_num_inflections", -1);
    surface.ends_mission = arguments.code("end_action", 1) == 0;
    // End actions quit and resume do not wait; the others wait for the pilot's answer, at most this time.
    const int end_action = arguments.code("end_action", 1);
    if (end_action != 0 && end_action != 2)
      surface.wait = core::Seconds{std::max(0.0, arguments.value("keystroke_wait_time", 300.0))};
    surface.climb = half(arguments, "c_", 1.0, true);
    orders_.surfaces.push_back(surface);
  }

  void take_yo_of_vehicle(bool in_mission) {
    if (in_mission) return refuse<"no-yo-to-fly">("/files");
    orders_.yo = {.dive = {.depth = vehicle_.dive_depth,
                           .altitude = vehicle_.altimeter_margin,
                           .pitch_rad = -vehicle_.pitch.value,
                           .buoyancy_m3 = -vehicle_.buoyancy.value},
                  .climb = {.depth = vehicle_.climb_to,
                            .pitch_rad = vehicle_.pitch.value,
                            .buoyancy_m3 = vehicle_.buoyancy.value}};
    note(messages::flight_text<"yo-of-the-vehicle">());
  }

  void take_surfacing_at_the_end() {
    orders_.surfaces.push_back(
        {.cause = SurfaceOrders::Cause::any_idle,
         .ends_mission = true,
         .climb = {.pitch_rad = vehicle_.pitch.value, .buoyancy_m3 = vehicle_.buoyancy.value}});
    note(messages::flight_text<"surfacing-at-the-end">());
  }

  void note(std::string sentence) {
    if (std::ranges::find(orders_.notes, sentence) == orders_.notes.end())
      orders_.notes.push_back(std::move(sentence));
  }

  std::span<const Document> documents_;
  const vehicle::GliderProfile& vehicle_;
  MissionOrders orders_;
  core::Violations found_;
  bool has_yo_{};
};

}  // namespace

tl::expected<MissionOrders, core::Violations> read_orders(std::span<const Document> documents,
                                                          const vehicle::GliderProfile& vehicle) {
  return Reader{documents, vehicle}.read();
}

}  // namespace floeplan::simulation
