#include "api/routes/plans/plan_exports.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include "api/codec/documents/alternative_document.hpp"
#include "api/codec/documents/plan_document.hpp"
#include "api/codec/exports/plan_brief.hpp"
#include "api/codec/exports/plan_files.hpp"
#include "api/service/export_sea.hpp"
#include "api/service/mission_service.hpp"
#include "api/service/probe_service.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/core/version.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/messages/export_messages.hpp"
#include "engine/messages/mission_fault_messages.hpp"
#include "engine/mission/writing/below_ice.hpp"
#include "engine/mission/writing/goto_lists.hpp"
#include "engine/mission/writing/nmea_route.hpp"
#include "engine/mission/writing/seaglider_files.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/environment/environment_loader.hpp"
#include "storage/repository/features/coastline_repository.hpp"
#include "storage/repository/features/known_icebergs.hpp"

namespace floeplan::routes {
namespace {

using repository::PlanRecord;

constexpr double map_width = 720.0;
constexpr double map_height = 420.0;
constexpr double section_height = 150.0;

/// The iceberg sightings that the plan obeyed: from its datasets, selected by the rules of its request.
std::vector<repository::StoredSighting> obeyed_sightings(sql::Connection& db, const PlanRecord& record,
                                                         const planning::Plan& plan,
                                                         const repository::DatasetChoice& of_icebergs) {
  if (of_icebergs.ids.empty()) return {};
  constexpr geo::BoundingBox whole_world{-180.0, -90.0, 180.0, 90.0};
  repository::SightingQuery query{
      .choice = of_icebergs, .area = whole_world, .as_of = plan.departure, .depart = plan.departure};
  if (const auto inputs = service::inputs_of(record)) {
    query.as_of = repository::sightings_as_of(inputs->data);
    query.max_age = inputs->data.max_sighting_age;
  }
  core::Violations none;  // stays empty: the datasets exist, and all intersect the whole world
  return repository::known_icebergs(db, repository::DatasetRepository{db}.list(), query, none).sightings;
}

/// The map, with land, icebergs and sea ice from the plan's data, as far as these are still stored.
codec::MapPicture picture_of(sql::Connection& db, const PlanRecord& record, const planning::Plan& plan) {
  const geo::BoundingBox area = codec::map_area(plan, map_width, map_height);
  std::vector<geo::Polygon> land;
  std::vector<ocean::Iceberg> icebergs;
  repository::DatasetChoice of_icebergs{repository::DatasetChoice::How::named, {}};
  for (const auto& used : plan.datasets) {
    const auto dataset = repository::DatasetRepository{db}.find({used.id});
    if (!dataset) continue;
    if (used.kind == "coastline")
      std::ranges::move(repository::CoastlineRepository{db}.load(dataset->id, area),
                        std::back_inserter(land));
    if (used.kind == "icebergs") of_icebergs.ids.push_back(dataset->id);
  }
  for (const auto& sighting : obeyed_sightings(db, record, plan, of_icebergs))
    if (geo::contains(area, sighting.iceberg.place)) icebergs.push_back(sighting.iceberg);
  return codec::draw_map(plan, land, icebergs, map_width, map_height,
                         service::sea_ice_of(db, record, plan, area));
}

/// The ice dataset of the plan, if it has exactly one and it is still stored; otherwise none, so that the
/// probe chooses.
std::vector<std::string> ice_dataset_of(sql::Connection& db, const planning::Plan& plan) {
  std::vector<std::string> ids;
  for (const auto& used : plan.datasets) {
    if (used.kind == "ice") ids.push_back(used.id);
  }
  if (ids.size() != 1 || !repository::DatasetRepository{db}.find({ids.front()})) return {};
  return ids;
}

/// The sea ice at about sixty times along the route, sampled as for the map's profile.
std::vector<codec::IceAbove> ice_above(sql::Connection& db, const planning::Plan& plan) {
  constexpr double moments = 60.0;
  std::vector<codec::IceAbove> ice;
  service::ProbeQuery query{};
  query.dataset_ids = ice_dataset_of(db, plan);
  core::Metres before{0.0};
  for (std::size_t i = 1; i < plan.waypoints.size(); ++i) {
    const planning::Waypoint& from = plan.waypoints[i - 1];
    const planning::Waypoint& to = plan.waypoints[i];
    const geo::GeodesicLine leg = geo::geodesic_between(from.place, to.place);
    const core::Seconds taken = to.eta - from.eta;
    const int pieces = std::max(1, static_cast<int>(std::lround(moments * (taken / plan.travel_time()))));
    for (int k = i == 1 ? 0 : 1; k <= pieces; ++k) {
      const double share = static_cast<double>(k) / pieces;
      const core::Metres gone{share * leg.length.value};
      query.place = geo::geodesic_destination(from.place, leg.course_at_start, gone);
      query.time = from.eta + share * taken;
      const auto told = service::probe(db, query);
      const auto state = told ? told->ice.state : std::nullopt;
      ice.push_back({before + gone, state ? state->thickness : std::nullopt});
    }
    before = before + leg.length;
  }
  return ice;
}

codec::BriefPictures pictures_of(sql::Connection& db, const PlanRecord& record, const planning::Plan& plan) {
  codec::BriefPictures pictures{.map = picture_of(db, record, plan)};
  if (mission::least_upper_turn(plan).value > 0.0)
    pictures.ice = codec::draw_ice_section(plan, ice_above(db, plan), map_width, section_height);
  return pictures;
}

/// The plan in a format that can represent it.
std::string bytes_of(sql::Connection& db, const PlanRecord& record, const planning::Plan& plan,
                     const ExportFormat& format, const std::vector<messages::Message>& told,
                     const std::vector<geo::LonLat>& safe_places, core::UtcTime now) {
  const std::string& id = record.id.value;
  if (format.name == "gpx") return codec::plan_gpx(plan, id, record.name);
  if (format.name == "kml") return codec::plan_kml(plan, id, record.name);
  if (format.name == "geojson") return codec::plan_geojson(record).dump(2) + "\n";
  if (format.name == "csv") return codec::plan_csv(plan);
  if (format.name == "nmea") return mission::write_nmea_route(plan, id).text;
  const mission::FileOrigin origin{id, record.name, now, std::string{core::program_version()}};
  if (format.name == "targets")
    return mission::write_targets(plan, mission::default_waypoint_radius(plan), origin).text;
  if (format.name == "imc")
    return codec::plan_imc(plan, service::vehicle_of(record, plan), service::shoals_of(db, record, plan),
                           service::holds_of(db, record, plan).radius, id, record.name, now);
  const codec::BriefNotes notes{id,
                                record.name,
                                now,
                                told,
                                codec::alternative_lines(nlohmann::json::parse(record.document_json)),
                                safe_places};
  if (format.name == "html") return codec::plan_brief_html(plan, pictures_of(db, record, plan), notes);
  if (format.name == "pdf") return codec::plan_brief_pdf(plan, pictures_of(db, record, plan), notes);
  throw std::invalid_argument{"export_plan: no format " + format.name};
}

/// Whether a format is for flying but cannot state the depths at which dives turn. GeoJSON has them for each
/// waypoint, and the printed page states them.
bool lacks_upper_turns(const ExportFormat& format) {
  constexpr std::array<std::string_view, 5> lacking{"gpx", "kml", "csv", "nmea", "imc"};
  return std::ranges::find(lacking, format.name) != lacking.end();
}

/// Whether a format cannot represent holds. The other formats state the time of each hold, or make the
/// vehicle hold.
bool lacks_holds(const ExportFormat& format) {
  constexpr std::array<std::string_view, 4> lacking{"gpx", "kml", "nmea", "targets"};
  return std::ranges::find(lacking, format.name) != lacking.end();
}

std::vector<messages::Message> messages_of(const planning::Plan& plan, const ExportFormat& format) {
  std::vector<messages::Message> told;
  if (lacks_holds(format)) told = mission::messages_without_holds(plan, format.name);
  const double turn_m = std::ceil(mission::least_upper_turn(plan).value);
  if (!lacks_upper_turns(format) || (turn_m <= 0.0 && mission::tells_upper_turns(plan))) return told;
  const std::string turn = mission::tells_upper_turns(plan) ? std::to_string(std::lround(turn_m)) + " m"
                                                            : std::string{"their keels"};
  told.push_back(messages::export_message<"format-without-turns">(format.name, turn));
  return told;
}

core::Violations violations_of(const planning::Plan& plan, const ExportFormat& format) {
  if (format.name == "nmea" && plan.waypoints.size() > mission::most_nmea_waypoints)
    return {
        messages::mission_fault<"too-many-waypoints-for-nmea">("/waypoints", mission::most_nmea_waypoints)};
  if (format.name == "targets")
    if (const auto closed = mission::closed_to_seagliders(plan)) return {*closed};
  return {};
}

}  // namespace

std::span<const ExportFormat> export_formats() {
  static const std::vector<ExportFormat> formats{{"gpx", "application/gpx+xml", ""},
                                                 {"kml", "application/vnd.google-earth.kml+xml", ""},
                                                 {"geojson", "application/geo+json", ""},
                                                 {"csv", "text/csv; charset=utf-8", ""},
                                                 {"nmea", "text/plain; charset=us-ascii", ""},
                                                 {"targets", "text/plain; charset=us-ascii", "targets"},
                                                 {"imc", "application/json", ""},
                                                 {"html", "text/html; charset=utf-8", "", true},
                                                 {"pdf", "application/pdf", "", true}};
  return formats;
}

std::string export_file_name(const ExportFormat& format, const std::string& stem) {
  if (!format.file_name.empty()) return format.file_name;
  return stem + "." + format.name + (format.name == "imc" ? ".json" : "");
}

std::string download_stem(const PlanRecord& record) {
  constexpr std::size_t longest_name = 40;
  std::string name;
  for (const char c : record.name.substr(0, longest_name)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (plain) name += c;
    if (!plain && !name.empty() && name.back() != '_') name += '_';
  }
  if (name.ends_with('_')) name.pop_back();
  std::string minute = core::iso8601(record.departure).substr(0, std::size("2026-11-20T06:00") - 1);
  std::erase_if(minute, [](char c) { return c == '-' || c == ':'; });
  return (name.empty() ? "plan" : name) + "-" + minute + "Z-" + record.id.value;
}

tl::expected<ExportedPlan, core::Violations> export_plan(sql::Connection& db, const PlanRecord& record,
                                                         const ExportFormat& format,
                                                         const std::vector<messages::Message>& told,
                                                         const std::vector<geo::LonLat>& safe_places,
                                                         core::UtcTime now) {
  const planning::Plan plan = codec::parse_plan_document(nlohmann::json::parse(record.document_json));
  if (core::Violations found = violations_of(plan, format); !found.empty())
    return tl::unexpected(std::move(found));
  return ExportedPlan{bytes_of(db, record, plan, format, told, safe_places, now), messages_of(plan, format)};
}

}  // namespace floeplan::routes
