#include "storage/ingest/readers/zones/zone_reader.hpp"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/geo/ring_turns.hpp"
#include "engine/messages/ingest_area_messages.hpp"
#include "storage/ingest/common/fault_report.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/formats/vector/polygon_shapes.hpp"
#include "storage/ingest/notation/stated_rule.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/zones/zone_attributes.hpp"
#include "storage/repository/features/zone_repository.hpp"

namespace floeplan::ingest {
namespace {

/// A ring with continuous longitudes, as GEOS needs it.
struct Unrolled {
  OGRLinearRing ring;
  bool jumps{};
};

Unrolled unrolled(const geo::Ring& ring) {
  Unrolled result;
  double lon_deg = ring.front().lon_deg;
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    const geo::LonLat corner = ring[i % ring.size()];
    if (i > 0) {
      const geo::LonLat last = ring[i - 1];
      lon_deg += geo::longitude_difference(last.lon_deg, corner.lon_deg);
      if (std::abs(corner.lon_deg - last.lon_deg) > 180.0) result.jumps = true;
    }
    result.ring.addPoint(lon_deg, corner.lat_deg);
  }
  return result;
}

/// The fault in the outline of a zone; empty if there is none.
std::optional<messages::Message> fault_of(const geo::Polygon& polygon) {
  if (const std::string doubt = geo::doubt_in_turns(polygon); !doubt.empty())
    return messages::ingest_area_message<"zone-outline-doubtful">(doubt);
  std::vector<const geo::Ring*> rings{&polygon.outer};
  for (const geo::Ring& hole : polygon.holes) rings.push_back(&hole);
  OGRPolygon shape;
  for (const geo::Ring* const ring : rings) {
    Unrolled line = unrolled(*ring);
    const double shift_deg =
        shape.IsEmpty() != 0
            ? 0.0
            : 360.0 * std::round((shape.getExteriorRing()->getX(0) - line.ring.getX(0)) / 360.0);
    for (int i = 0; i < line.ring.getNumPoints(); ++i)
      line.ring.setPoint(i, line.ring.getX(i) + shift_deg, line.ring.getY(i));
    shape.addRing(&line.ring);
  }
  const GdalMessages messages;
  if (shape.IsValid() != 0) return std::nullopt;
  return messages::ingest_area_message<"zone-outline-crosses-itself">();
}

bool crosses_antimeridian(const geo::Polygon& polygon) { return unrolled(polygon.outer).jumps; }

std::size_t corners_of(const geo::Polygon& polygon) {
  std::size_t corners = polygon.outer.size();
  for (const geo::Ring& hole : polygon.holes) corners += hole.size();
  return corners;
}

/// The zones collected so far, and all faults found.
struct ZoneGathering {
  std::vector<ocean::Zone> zones;
  Messages faults;
  Messages warnings;
  std::size_t corners{};
  AttributeMeanings meanings;
  struct FirstUnheeded {
    std::string subject;
    messages::Message told;
    int features{};
  };
  std::map<std::string, FirstUnheeded> unheeded;  // by attribute: where it occurs first, and how often

  void note(const Unheeded& attribute, const std::string& subject) {
    ++unheeded.try_emplace(attribute.attribute, FirstUnheeded{subject, attribute.told})
          .first->second.features;
  }
  void warn_of_unheeded() {
    for (const auto& [attribute, first] : unheeded) {
      const std::string others = first.features == 1 ? ""
                                                     : " (one of " + std::to_string(first.features) +
                                                           " features with \"" + attribute + "\")";
      warnings.push_back(about(first.subject + others, first.told));
    }
  }
};

void gather_zones(ZoneGathering& all, const OGRFeature& feature, const std::string& label,
                  const PolygonShapes& shapes, std::optional<ocean::ZoneKind> kind_of_others) {
  ZoneAttributes attributes = read_zone_attributes(feature, all.meanings, kind_of_others);
  const std::string subject =
      label + (attributes.zone.name.empty() ? "" : " \"" + attributes.zone.name + "\"");
  for (messages::Message& fault : attributes.faults) all.faults.push_back(about(subject, std::move(fault)));
  for (const Unheeded& attribute : attributes.unheeded) all.note(attribute, subject);
  auto polygons = shapes.polygons(feature.GetGeometryRef());
  if (!polygons) {
    all.faults.push_back(about(
        subject, messages::ingest_area_message<"zone-outline-not-usable">(reason_of(polygons.error()))));
    return;
  }
  for (geo::Polygon& polygon : *polygons) {
    if (auto fault = fault_of(polygon)) {
      all.faults.push_back(about(subject, std::move(*fault)));
      continue;
    }
    if (crosses_antimeridian(polygon)) {
      const double width = geo::width_deg(geo::bounding_box(polygon));
      all.warnings.push_back(
          about(subject, messages::ingest_area_message<"zone-crosses-antimeridian">(number(width, 4))));
    }
    all.corners += corners_of(polygon);
    attributes.zone.area = std::move(polygon);
    all.zones.push_back(attributes.zone);
  }
}

/// The converter of the layer's coordinates to WGS84.
Checked<PolygonShapes> shapes_of(OGRLayer& layer, const IngestOptions& options) {
  const auto crs = crs_of(layer, options.crs);
  if (!crs) return refuse(crs.error());
  return PolygonShapes::in(*crs);
}

/// Sets the dataset's period: the earliest begin and the latest end of the zones; unset if a zone has no
/// begin or no end.
void set_period(PreparedDataset& data, const std::vector<ocean::Zone>& zones) {
  const bool begin =
      std::ranges::all_of(zones, [](const ocean::Zone& zone) { return zone.from.has_value(); });
  const bool end = std::ranges::all_of(zones, [](const ocean::Zone& zone) { return zone.until.has_value(); });
  for (const ocean::Zone& zone : zones) {
    if (begin) data.time_start = data.time_start ? std::min(*data.time_start, *zone.from) : *zone.from;
    if (end) data.time_end = data.time_end ? std::max(*data.time_end, *zone.until) : *zone.until;
  }
}

}  // namespace

Checked<PreparedDataset> read_zones(GDALDataset& dataset, const IngestOptions& options) {
  std::optional<ocean::ZoneKind> kind_of_others;
  if (options.zone_kind) {
    kind_of_others = zone_kind_of(*options.zone_kind);
    if (!kind_of_others)
      return refuse(messages::ingest_area_message<"zone-kind-unknown">(*options.zone_kind));
  }
  ZoneGathering all;
  for (OGRLayer* const layer : dataset.GetLayers()) {
    if (layer->GetFeatureCount() == 0) continue;
    const auto shapes = shapes_of(*layer, options);
    if (!shapes) return refuse(shapes.error());
    const std::string in_layer =
        dataset.GetLayerCount() > 1 ? std::string{" of layer \""} + layer->GetName() + "\"" : "";
    int number_of_feature = 0;
    layer->ResetReading();
    for (const auto& feature : *layer) {
      ++number_of_feature;
      gather_zones(all, *feature, "feature " + std::to_string(number_of_feature) + in_layer, *shapes,
                   kind_of_others);
    }
  }
  if (all.corners > repository::max_zone_corners)
    all.faults.push_back(
        messages::ingest_area_message<"zones-too-detailed">(all.corners, repository::max_zone_corners));
  if (!all.faults.empty()) return refuse(report_of(std::move(all.faults)));

  std::vector<geo::LonLat> corners;
  for (const ocean::Zone& zone : all.zones)
    corners.insert(corners.end(), zone.area.outer.begin(), zone.area.outer.end());
  PreparedDataset data;
  data.kind = repository::DatasetKind::zones;
  for (const ocean::ZoneKind kind : {ocean::ZoneKind::no_go, ocean::ZoneKind::stay_in})
    if (std::ranges::find(all.zones, kind, &ocean::Zone::kind) != all.zones.end())
      data.variables.push_back(ocean::zone_kind_name(kind));
  data.bounds = geo::bounding_box(corners);
  for (const ocean::Zone& zone : all.zones)
    data.bounds = geo::united(data.bounds, geo::bounding_box(zone.area));
  set_period(data, all.zones);
  data.rows_accepted = static_cast<std::int64_t>(all.zones.size());
  all.warn_of_unheeded();
  data.warnings = std::move(all.warnings);
  data.write = [zones = std::move(all.zones)](sql::Connection& db,
                                              const repository::DatasetId& id) -> Checked<void> {
    repository::ZoneRepository{db}.insert(id, zones);
    return {};
  };
  return data;
}

}  // namespace floeplan::ingest
