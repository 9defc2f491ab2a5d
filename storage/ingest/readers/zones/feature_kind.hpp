#pragma once

#include <optional>

#include "storage/ingest/common/refusal.hpp"
#include "storage/repository/datasets/dataset.hpp"

class GDALDataset;
class OGRFeature;

namespace floeplan::ingest {

/// What a polygon is according to its attributes.
enum class PolygonMeaning {
  unstated,
  zone,         // has a rule: read_zone_attributes
  land,         // also islands, and outlines of GSHHG with the level of land
  ice_shelf,    // also ice tongues and ice rises: ice from land that stays in place
  fast_ice,     // sea ice frozen to the coast
  chart_of_ice  // has the codes of SIGRID-3: read_ice_codes
};
[[nodiscard]] PolygonMeaning meaning_of(const OGRFeature& feature);

/// The kind of data in a file of features. Points are icebergs; polygons are what their attributes or the
/// options say.
/// Errors   polygons of unknown or different kinds, because only the pilot can say whether they are zones,
///          land or ice; other or mixed geometries
[[nodiscard]] Checked<repository::DatasetKind> kind_of_features(GDALDataset& dataset,
                                                                std::optional<repository::DatasetKind> wanted,
                                                                bool zone_kind_stated);

}  // namespace floeplan::ingest
