#include "storage/ingest/readers/zones/feature_kind.hpp"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <set>

#include "engine/core/letter_case.hpp"
#include "engine/messages/ingest_area_messages.hpp"
#include "storage/ingest/formats/vector/feature_texts.hpp"
#include "storage/ingest/formats/vector/sigrid3.hpp"
#include "storage/ingest/readers/zones/zone_attributes.hpp"

namespace floeplan::ingest {
namespace {

using repository::DatasetKind;

/// Names of attributes that tell what a feature is: this program's, Natural Earth's, the Antarctic Digital
/// Database's and common ones.
constexpr auto kind_names = std::to_array<std::string_view>(
    {"kind", "type", "featurecla", "surface", "class", "category", "featuretype", "natural", "icetype"});
constexpr auto level_names = std::to_array<std::string_view>({"level"});

bool contains(std::string_view text, std::string_view word) {
  return text.find(word) != std::string_view::npos;
}

PolygonMeaning meaning_of_word(std::string_view word) {
  for (const std::string_view shelf : {"iceshelf", "iceshelves", "icetongue", "icerise", "rumple"})
    if (contains(word, shelf)) return PolygonMeaning::ice_shelf;
  if (contains(word, "fastice")) return PolygonMeaning::fast_ice;
  for (const std::string_view land :
       {"land", "coast", "island", "minorisland", "mainland", "coastline", "shoreline"})
    if (word == land) return PolygonMeaning::land;
  return PolygonMeaning::unstated;
}

Checked<DatasetKind> kind_of_polygons(const std::set<PolygonMeaning>& meanings) {
  if (meanings.contains(PolygonMeaning::zone))
    return DatasetKind::zones;  // its reader reports each polygon that is no zone
  if (meanings.contains(PolygonMeaning::chart_of_ice)) return DatasetKind::ice;
  if (meanings.contains(PolygonMeaning::unstated))
    return refuse(messages::ingest_area_message<"polygons-do-not-say-what-they-are">());
  if (!meanings.contains(PolygonMeaning::fast_ice)) return DatasetKind::coastline;
  if (meanings.size() == 1) return DatasetKind::ice;
  return refuse(messages::ingest_area_message<"land-and-fast-ice">());
}

/// The kinds of geometry in a file, and what its polygons are.
struct Contents {
  bool points{false};
  bool polygons{false};
  bool others{false};
  std::set<PolygonMeaning> meanings;
};

Contents contents_of(GDALDataset& dataset) {
  Contents contents;
  for (OGRLayer* const layer : dataset.GetLayers()) {
    layer->ResetReading();
    for (const auto& feature : *layer) {
      const OGRGeometry* const geometry = feature->GetGeometryRef();
      if (geometry == nullptr) continue;
      const OGRwkbGeometryType type = wkbFlatten(geometry->getGeometryType());
      const bool polygon =
          OGR_GT_IsSubClassOf(type, wkbSurface) != 0 || OGR_GT_IsSubClassOf(type, wkbMultiSurface) != 0;
      contents.points = contents.points || type == wkbPoint;
      contents.polygons = contents.polygons || polygon;
      contents.others = contents.others || (type != wkbPoint && !polygon);
      contents.meanings.insert(meaning_of(*feature));
    }
    layer->ResetReading();
  }
  return contents;
}

}  // namespace

PolygonMeaning meaning_of(const OGRFeature& feature) {
  if (states_zone_kind(feature)) return PolygonMeaning::zone;
  if (states_ice_codes(feature)) return PolygonMeaning::chart_of_ice;
  for (const std::string_view name : kind_names) {
    const auto text = text_of_feature(feature, std::array{name});
    if (!text) continue;
    const PolygonMeaning meaning = meaning_of_word(core::plain_word(*text));
    if (meaning != PolygonMeaning::unstated) return meaning;
  }
  // GSHHG: 1 land, 5 Antarctica to its ice front, 6 to its grounding line. The other levels are lakes and
  // land in lakes.
  const auto level = text_of_feature(feature, level_names);
  if (level == "1" || level == "5" || level == "6") return PolygonMeaning::land;
  return PolygonMeaning::unstated;
}

Checked<DatasetKind> kind_of_features(GDALDataset& dataset, std::optional<DatasetKind> wanted,
                                      bool zone_kind_stated) {
  if (wanted == DatasetKind::zones)
    return DatasetKind::zones;  // its reader reports each feature that is no zone
  const Contents contents = contents_of(dataset);
  const bool ruled =
      contents.meanings.contains(PolygonMeaning::zone) || (zone_kind_stated && !contents.points);
  if (ruled && (!wanted || wanted == DatasetKind::zones)) return DatasetKind::zones;
  if (contents.points == contents.polygons || contents.others)
    return refuse(messages::ingest_area_message<"points-and-polygons">());
  if (contents.points) return DatasetKind::icebergs;
  if (wanted == DatasetKind::coastline || wanted == DatasetKind::ice || wanted == DatasetKind::icebergs)
    return *wanted;
  return kind_of_polygons(contents.meanings);
}

}  // namespace floeplan::ingest
