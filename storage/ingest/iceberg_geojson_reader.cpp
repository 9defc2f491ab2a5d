#include "storage/ingest/iceberg_geojson_reader.hpp"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <initializer_list>
#include <optional>

#include "engine/core/utc_text.hpp"
#include "storage/ingest/iceberg_rows.hpp"
#include "storage/ingest/text.hpp"

namespace floeplan::ingest {
namespace {

/// Text of the first of the properties that is there; empty when none is.
std::string property(const OGRFeature& feature, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    const int index = feature.GetFieldIndex(name);
    if (index >= 0 && feature.IsFieldSetAndNotNull(index)) return trimmed(feature.GetFieldAsString(index));
  }
  return {};
}

/// A length property in metres, or why it is none.
Checked<std::optional<core::Metres>> length_property(const OGRFeature& feature, const char* name,
                                                     double max_m) {
  const std::string text = property(feature, {name});
  if (text.empty()) return std::nullopt;
  const auto value = parse_number(text);
  if (!value || *value <= 0.0 || *value > max_m)
    return refuse(std::string{name} + " is \"" + text + "\", not a number of metres between 0 and " +
                  number(max_m));
  return core::Metres{*value};
}

Checked<ocean::Iceberg> iceberg_of(const OGRFeature& feature) {
  constexpr double longest_m = 400'000.0;  // B-15 was 295 km long
  constexpr double deepest_m = 1'000.0;
  const OGRGeometry* geometry = feature.GetGeometryRef();
  if (geometry == nullptr || geometry->IsEmpty() || wkbFlatten(geometry->getGeometryType()) != wkbPoint)
    return refuse("it has no position");

  ocean::Iceberg iceberg;
  iceberg.place = {geometry->toPoint()->getX(), geometry->toPoint()->getY()};
  if (auto fault = fault_of_place(iceberg.place); !fault.empty()) return refuse(std::move(fault));
  iceberg.id = property(feature, {"id", "name"});
  if (iceberg.id.empty()) return refuse("it has no id and no name");

  const std::string observed = property(feature, {"observed", "time"});
  const auto time = core::parse_iso8601(observed);
  if (!time) return refuse("observed is \"" + observed + "\", not a time like 2026-11-20T06:00:00Z");
  iceberg.observed = *time;

  const auto length = length_property(feature, "length_m", longest_m);
  if (!length) return refuse(length.error());
  iceberg.length = *length;
  const auto draft = length_property(feature, "draft_m", deepest_m);
  if (!draft) return refuse(draft.error());
  iceberg.draft = *draft;
  if (const std::string size = property(feature, {"size"}); !size.empty()) {
    const auto known = ocean::parse_size(lower(size));
    if (!known)
      return refuse("the size \"" + size + "\" is not one of the classes (growler to very_large, unknown)");
    iceberg.size = *known;
  }
  iceberg.shape = property(feature, {"shape"});
  iceberg.method = property(feature, {"method"});
  return iceberg;
}

}  // namespace

Checked<PreparedDataset> read_geojson_icebergs(GDALDataset& dataset) {
  OGRLayer& layer = *dataset.GetLayer(0);
  std::vector<std::string> variables;
  for (int i = 0; i < layer.GetLayerDefn()->GetFieldCount(); ++i)
    variables.emplace_back(layer.GetLayerDefn()->GetFieldDefn(i)->GetNameRef());

  IcebergRows rows;
  int number_of_feature = 0;
  layer.ResetReading();
  for (const auto& feature : layer) {
    auto iceberg = iceberg_of(*feature);
    ++number_of_feature;
    if (iceberg) {
      rows.accept(std::move(*iceberg));
    } else {
      rows.reject("feature " + std::to_string(number_of_feature), iceberg.error());
    }
  }
  return std::move(rows).prepared(std::move(variables));
}

}  // namespace floeplan::ingest
