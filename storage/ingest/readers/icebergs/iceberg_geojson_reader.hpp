#pragma once

#include "storage/ingest/common/prepared_dataset.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Icebergs from features, GeoJSON or another vector file: points, or outlines, whose place is the middle of their box
/// and whose length, where none is stated, is twice the way from there to the farthest corner. Layers in a projection
/// are turned into degrees. Properties: `id` or `name`; `observed`, `time`, `timestamp`, `begin` or `date` (ISO 8601
/// with a zone, a time with a zone as the file keeps it, or a day, which counts from its beginning); optional
/// `length_m`, `draft_m`, `position_uncertainty_m` (or what else PositionErrors understands), `size` (growler, bergy_bit, small, medium, large, very_large,
/// unknown, radar_target), `shape`, `method`. A bad feature is left out and counted.
[[nodiscard]] Checked<PreparedDataset> read_geojson_icebergs(GDALDataset& dataset);

}  // namespace floeplan::ingest
