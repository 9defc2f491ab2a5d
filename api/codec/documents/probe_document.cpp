#include "api/codec/documents/probe_document.hpp"

#include <cmath>

#include "api/codec/bytes/document_values.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

json optional_text(const std::string& text) { return text.empty() ? json() : json(text); }

json velocity_json(const Probe::Velocity& part) {
  const auto& velocity = part.velocity;
  return {{"u_m_s", velocity ? json(velocity->east.value) : json()},
          {"v_m_s", velocity ? json(velocity->north.value) : json()},
          {"reason", optional_text(part.reason)},
          {"dataset_id", optional_text(part.dataset_id)},
          {"dataset_name", optional_text(part.dataset_name)},
          {"run", optional_time(part.run)},
          {"time_before", optional_time(part.time_before)},
          {"time_after", optional_time(part.time_after)}};
}

json ice_json(const Probe::Ice& ice) {
  const bool thick = ice.state && ice.state->thickness;
  return {{"thickness_m", thick ? json(ice.state->thickness->value) : json()},
          {"dataset_id", optional_text(ice.dataset_id)},
          {"dataset_name", optional_text(ice.dataset_name)},
          {"run", optional_time(ice.run)},
          {"time_before", optional_time(ice.time_before)},
          {"time_after", optional_time(ice.time_after)}};
}

json tide_json(const Probe::Tide& tide) {
  const auto& velocity = tide.velocity;
  return {{"elevation_m", tide.elevation ? json(tide.elevation->value) : json()},
          {"u_m_s", velocity ? json(velocity->east.value) : json()},
          {"v_m_s", velocity ? json(velocity->north.value) : json()},
          {"reason", optional_text(tide.reason)},
          {"station", optional_text(tide.station)},
          {"dataset_ids", tide.dataset_ids},
          {"dataset_names", tide.dataset_names},
          {"constituents", tide.constituents}};
}

json water_level_json(const Probe::WaterLevel& level) {
  return {{"height_m", level.height ? json(level.height->value) : json()},
          {"datum", optional_text(level.datum)},
          {"reason", optional_text(level.reason)},
          {"station", optional_text(level.station)},
          {"dataset_id", optional_text(level.dataset_id)},
          {"dataset_name", optional_text(level.dataset_name)},
          {"time_before", optional_time(level.time_before)},
          {"time_after", optional_time(level.time_after)}};
}

json zone_json(const Probe::HereZone& here) {
  const ocean::Zone& zone = here.zone;
  return {{"name", zone.name},
          {"kind", ocean::zone_kind_name(zone.kind)},
          {"from", optional_time(zone.from)},
          {"until", optional_time(zone.until)},
          {"top_m", zone.top.value},
          {"bottom_m", std::isfinite(zone.bottom.value) ? json(zone.bottom.value) : json()},
          {"in_force", here.in_force},
          {"dataset_id", here.dataset_id},
          {"dataset_name", here.dataset_name}};
}

}  // namespace

json probe_document(const Probe& probe) {
  json icebergs = json::array();
  for (const auto& near : probe.icebergs) {
    icebergs.push_back({{"berg_id", near.iceberg.id},
                        {"distance_m", near.distance.value},
                        {"observed", core::iso8601(near.iceberg.observed)},
                        {"size", ocean::size_name(near.iceberg.size)}});
  }
  json zones = json::array();
  for (const auto& here : probe.zones) zones.push_back(zone_json(here));
  return {{"lon", probe.place.lon_deg},
          {"lat", probe.place.lat_deg},
          {"time", core::iso8601(probe.time)},
          {"depth_m", probe.depth ? json(probe.depth->value) : json()},
          {"shoalest_depth_m", probe.shoalest_depth ? json(probe.shoalest_depth->value) : json()},
          {"depth_reason", optional_text(probe.depth_reason)},
          {"land", probe.land ? json(*probe.land) : json()},
          {"currents", velocity_json(probe.currents)},
          {"wind", velocity_json(probe.wind)},
          {"ice_concentration", probe.ice.state ? json(probe.ice.state->concentration) : json()},
          {"ice_concentration_reason", optional_text(probe.ice.reason)},
          {"ice", ice_json(probe.ice)},
          {"tide", tide_json(probe.tide)},
          {"water_level", water_level_json(probe.water_level)},
          {"icebergs_within", std::move(icebergs)},
          {"zones", std::move(zones)}};
}

}  // namespace floeplan::codec
