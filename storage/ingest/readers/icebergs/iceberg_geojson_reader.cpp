#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <chrono>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <optional>
#include <vector>

#include "engine/core/utc_text.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/messages/ingest_iceberg_messages.hpp"
#include "storage/ingest/formats/vector/feature_texts.hpp"
#include "storage/ingest/notation/grid_frame_of_crs.hpp"
#include "storage/ingest/notation/stated_place.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/icebergs/detection.hpp"
#include "storage/ingest/readers/icebergs/iceberg_readers.hpp"
#include "storage/ingest/readers/icebergs/iceberg_rows.hpp"
#include "storage/ingest/readers/icebergs/position_errors.hpp"

namespace floeplan::ingest {
namespace {

/// Text of the first of these properties that has a value; empty if none has.
std::string property(const OGRFeature& feature, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    const int index = feature.GetFieldIndex(name);
    if (index >= 0 && feature.IsFieldSetAndNotNull(index)) return text_of_field(feature, index);
  }
  return {};
}

/// Confidence of a detection; empty if the file has no such attribute.
std::optional<std::string> confidence_of(const OGRFeature& feature) {
  for (const std::string_view name : confidence_names)
    if (const int index = feature.GetFieldIndex(std::string{name}.c_str()); index >= 0)
      return text_of_field(feature, index);
  return std::nullopt;
}

/// A length property in metres, empty if not stated; or why it is not a length.
Checked<std::optional<core::Metres>> length_property(const OGRFeature& feature, const char* name,
                                                     double most_m) {
  const std::string text = property(feature, {name});
  return metres_of(name, text, parse_number(text), most_m);
}

std::vector<std::string> names_of_fields(OGRLayer& layer) {
  std::vector<std::string> names;
  for (int i = 0; i < layer.GetLayerDefn()->GetFieldCount(); ++i)
    names.emplace_back(layer.GetLayerDefn()->GetFieldDefn(i)->GetNameRef());
  return names;
}

/// The time of a field of type time or date: with its zone, or a day, which counts from its beginning.
std::optional<core::UtcTime> time_of_field(const OGRFeature& feature, int index) {
  const OGRFieldType type = feature.GetFieldDefnRef(index)->GetType();
  if (type != OFTDateTime && type != OFTDate) return std::nullopt;
  int year = 0;
  int month = 0;
  int day = 0;
  int hour = 0;
  int minute = 0;
  float second = 0.0F;
  int zone = 0;  // 1: unspecified local time; 100: UTC; plus 1 for every quarter of an hour east
  if (!feature.GetFieldAsDateTime(index, &year, &month, &day, &hour, &minute, &second, &zone))
    return std::nullopt;
  if (type == OFTDateTime && zone < 2) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year{year},
                                         std::chrono::month{static_cast<unsigned>(month)},
                                         std::chrono::day{static_cast<unsigned>(day)}};
  if (!date.ok()) return std::nullopt;
  const double quarters_east = type == OFTDateTime ? zone - 100 : 0;
  return core::UtcTime{std::chrono::sys_days{date}.time_since_epoch()} +
         core::Seconds{3600.0 * hour + 60.0 * minute + static_cast<double>(second) - 900.0 * quarters_east};
}

Checked<core::UtcTime> observed_of(const OGRFeature& feature) {
  for (const char* name :
       {"observed", "time", "timestamp", "begin", "date", "acquired", "acquisition_time", "image_time"}) {
    const int index = feature.GetFieldIndex(name);
    if (index < 0 || !feature.IsFieldSetAndNotNull(index)) continue;
    if (const auto time = time_of_field(feature, index)) return *time;
    const std::string text = text_of_field(feature, index);
    if (const auto time = core::parse_iso8601(text)) return *time;
    return refuse(messages::ingest_iceberg_message<"iceberg-time-unusable">("observed", text, ""));
  }
  return refuse(messages::ingest_iceberg_message<"iceberg-time-unusable">("observed", "", ""));
}

/// Position of an iceberg, and its length if it follows from an outline.
struct PlaceAndLength {
  geo::LonLat place;
  std::optional<core::Metres> length;
};

/// The middle of an outline's box, and twice the distance to its farthest corner: a circle around all of it.
Checked<PlaceAndLength> extent_of(const std::vector<geo::LonLat>& corners) {
  for (const geo::LonLat corner : corners)
    if (auto fault = fault_of_place(corner)) return refuse(std::move(*fault));
  // relative to the first corner, so that an outline across the date line stays in one piece
  double west = 0.0;
  double east = 0.0;
  double south = corners.front().lat_deg;
  double north = south;
  for (const geo::LonLat corner : corners) {
    const double offset = geo::longitude_difference(corners.front().lon_deg, corner.lon_deg);
    west = std::min(west, offset);
    east = std::max(east, offset);
    south = std::min(south, corner.lat_deg);
    north = std::max(north, corner.lat_deg);
  }
  PlaceAndLength extent{{corners.front().lon_deg + 0.5 * (west + east), 0.5 * (south + north)},
                        core::Metres{0.0}};
  for (const geo::LonLat corner : corners)
    extent.length = std::max(*extent.length, 2.0 * geo::geodesic_between(extent.place, corner).length);
  if (extent.length->value > longest_iceberg_m)
    return refuse(
        messages::ingest_iceberg_message<"iceberg-outline-too-large">(number(extent.length->value / 1000.0)));
  return extent;
}

Checked<PlaceAndLength> extent_of(const OGRGeometry* geometry) {
  if (geometry == nullptr || geometry->IsEmpty())
    return refuse(messages::ingest_iceberg_message<"iceberg-position-missing">());
  const OGRwkbGeometryType type = wkbFlatten(geometry->getGeometryType());
  if (type == wkbPoint) {
    const geo::LonLat place{geometry->toPoint()->getX(), geometry->toPoint()->getY()};
    if (auto fault = fault_of_place(place)) return refuse(std::move(*fault));
    return PlaceAndLength{place, std::nullopt};
  }
  std::vector<geo::LonLat> corners;
  const auto add = [&](const OGRPolygon& part) {
    if (part.getExteriorRing() == nullptr) return;
    for (const OGRPoint& corner : *part.getExteriorRing()) corners.push_back({corner.getX(), corner.getY()});
  };
  if (type == wkbPolygon) add(*geometry->toPolygon());
  if (type == wkbMultiPolygon)
    for (const OGRPolygon* part : geometry->toMultiPolygon()) add(*part);
  if (corners.empty()) return refuse(messages::ingest_iceberg_message<"iceberg-position-missing">());
  return extent_of(corners);
}

Checked<ocean::Iceberg> iceberg_of(const OGRFeature& feature, const PositionErrors& position_errors) {
  const auto extent = extent_of(feature.GetGeometryRef());
  if (!extent) return refuse(extent.error());
  ocean::Iceberg iceberg;
  iceberg.place = extent->place;
  iceberg.id = property(feature, {"id", "name"});
  const auto confidence = confidence_of(feature);
  if (iceberg.id.empty() && !confidence)
    return refuse(messages::ingest_iceberg_message<"iceberg-without-id">());
  const auto observed = observed_of(feature);
  if (!observed) return refuse(observed.error());
  iceberg.observed = *observed;

  const auto length = length_property(feature, "length_m", longest_iceberg_m);
  if (!length) return refuse(length.error());
  iceberg.length = *length ? *length : extent->length;
  const auto draft = length_property(feature, "draft_m", deepest_iceberg_m);
  if (!draft) return refuse(draft.error());
  iceberg.draft = *draft;
  const auto error = position_errors.of(
      [&](std::size_t column) {
        const int index = static_cast<int>(column);
        return feature.IsFieldSetAndNotNull(index) ? text_of_field(feature, index) : std::string{};
      },
      parse_number);
  if (!error) return refuse(error.error());
  iceberg.position_uncertainty = *error;
  if (const std::string size = property(feature, {"size"}); !size.empty()) {
    const auto known = ocean::parse_size(lower(size));
    if (!known) return refuse(messages::ingest_iceberg_message<"iceberg-size-unknown">(size));
    iceberg.size = *known;
  }
  iceberg.shape = property(feature, {"shape"});
  iceberg.method = property(feature, {"method"});
  return confidence ? as_detection(std::move(iceberg), *confidence) : iceberg;
}

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

/// The transformation of a layer to degrees; null if it is in degrees already or states no reference system.
Checked<Transformation> transformation_to_degrees(OGRLayer& layer) {
  const OGRSpatialReference* stated = layer.GetSpatialRef();
  if (stated == nullptr) return Transformation{};
  OGRSpatialReference from{*stated};
  from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const auto frame = grid_frame_of(from);
  if (frame && std::holds_alternative<geo::GeographicFrame>(*frame)) return Transformation{};
  OGRSpatialReference to;
  to.SetWellKnownGeogCS("WGS84");
  to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  Transformation transformation{OGRCreateCoordinateTransformation(&from, &to)};
  if (!transformation) return refuse(messages::ingest_iceberg_message<"icebergs-in-unknown-crs">());
  return transformation;
}

}  // namespace

Checked<PreparedDataset> read_geojson_icebergs(GDALDataset& dataset) {
  std::vector<std::string> variables;
  Messages warnings;
  IcebergRows rows;
  int number_of_feature = 0;
  for (OGRLayer* const layer : dataset.GetLayers()) {
    const std::vector<std::string> names = names_of_fields(*layer);
    variables.insert(variables.end(), names.begin(), names.end());
    const PositionErrors position_errors{names};
    std::ranges::move(position_errors.warnings(), std::back_inserter(warnings));
    const auto to_degrees = transformation_to_degrees(*layer);
    if (!to_degrees) return refuse(to_degrees.error());
    const bool detected = std::ranges::any_of(names, [](const std::string& name) {
      return std::ranges::find(confidence_names, lower(name)) != confidence_names.end();
    });
    if (detected) warnings.push_back(messages::ingest_iceberg_message<"detections-all-count">());
    layer->ResetReading();
    for (const auto& feature : *layer) {
      ++number_of_feature;
      OGRGeometry* geometry = feature->GetGeometryRef();
      const bool moved = *to_degrees == nullptr || geometry == nullptr ||
                         geometry->transform(to_degrees->get()) == OGRERR_NONE;
      auto iceberg = moved ? iceberg_of(*feature, position_errors)
                           : Checked<ocean::Iceberg>{refuse(
                                 messages::ingest_iceberg_message<"iceberg-position-not-convertible">())};
      if (iceberg) {
        rows.accept(std::move(*iceberg));
      } else {
        rows.reject("feature " + std::to_string(number_of_feature), iceberg.error().front());
      }
    }
  }
  return std::move(rows).prepared(std::move(variables), std::move(warnings));
}

}  // namespace floeplan::ingest
