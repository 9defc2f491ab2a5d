#include "api/codec/features/glider_track_feature.hpp"

#include "api/codec/documents/vehicle_axes_document.hpp"
#include "api/codec/features/line_geometry.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

json geometry_of(const std::vector<ocean::TrackPoint>& points) {
  std::vector<geo::LonLat> way;
  way.reserve(points.size());
  for (const ocean::TrackPoint& point : points) way.push_back(point.place);
  std::vector<double> heights_m = ocean::depths_along(points);
  for (double& depth_m : heights_m) depth_m = -depth_m;
  return line_geometry(way, heights_m);
}

json current_of(const ocean::DepthAveragedCurrent& each) {
  return {{"time", core::iso8601(each.time)},
          {"lon", each.place.lon_deg},
          {"lat", each.place.lat_deg},
          {"east_m_s", each.current.east.value},
          {"north_m_s", each.current.north.value}};
}

}  // namespace

json glider_track_feature(const repository::StoredGliderTrack& stored) {
  auto points = ocean::thinned(stored.track.points, most_track_points);
  json properties{{"glider", stored.track.glider},
                  {"start", core::iso8601(points.front().time)},
                  {"end", core::iso8601(points.back().time)},
                  {"points", stored.point_count},
                  {"current_count", stored.current_count},
                  {"deepest_m", nullptr},
                  {"mean_east_m_s", nullptr},
                  {"mean_north_m_s", nullptr},
                  {"current_frame", nullptr},
                  {"currents_turned_from", nullptr},
                  {"times", json::array()},
                  {"depths_m", json::array()},
                  {"currents", json::array()},
                  {"dataset_id", stored.dataset.value}};
  if (stored.deepest) properties["deepest_m"] = stored.deepest->value;
  if (stored.mean_current) {
    properties["mean_east_m_s"] = stored.mean_current->east.value;
    properties["mean_north_m_s"] = stored.mean_current->north.value;
  }
  if (stored.current_count > 0) {
    properties["current_frame"] = ocean::frame_name(stored.track.frame);
    if (const auto& axes = stored.track.turned_from)
      properties["currents_turned_from"] = vehicle_axes_document(*axes);
  }
  if (points.size() == 1) points.push_back(points.front());
  for (const ocean::TrackPoint& point : points) {
    properties["times"].push_back(core::iso8601(point.time));
    properties["depths_m"].push_back(point.depth ? json(point.depth->value) : json());
  }
  for (const ocean::DepthAveragedCurrent& each : stored.track.currents)
    properties["currents"].push_back(current_of(each));
  return {{"type", "Feature"},
          {"id", stored.row},
          {"geometry", geometry_of(points)},
          {"properties", std::move(properties)}};
}

}  // namespace floeplan::codec
