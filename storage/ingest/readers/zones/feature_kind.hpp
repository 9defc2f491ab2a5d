#pragma once

#include <optional>

#include "storage/ingest/common/refusal.hpp"
#include "storage/repository/datasets/dataset.hpp"

class GDALDataset;
class OGRFeature;

namespace floeplan::ingest {

/// What a polygon says of itself.
enum class PolygonMeaning {
  unstated,
  zone,         // a rule: read_zone_attributes
  land,         // also islands, and GSHHG's outlines by their level
  ice_shelf,    // also ice tongues and rises: ice of land origin that stays where it is
  fast_ice,     // sea ice that is frozen to the coast
  chart_of_ice  // the codes of SIGRID-3: read_ice_codes
};
[[nodiscard]] PolygonMeaning meaning_of(const OGRFeature& feature);

/// Points are icebergs; polygons are what they say, or what the options say of them.
/// Errors   polygons that do not say what they are, or say different things: whether they are to be kept out of, run
///          aground on or dived under is the pilot's to say; other or mixed geometries
[[nodiscard]] Checked<repository::DatasetKind> kind_of_features(GDALDataset& dataset,
                                                                std::optional<repository::DatasetKind> wanted,
                                                                bool zone_kind_stated);

}  // namespace floeplan::ingest
