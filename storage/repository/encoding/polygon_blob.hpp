#pragma once

#include <cstddef>
#include <span>

#include "engine/geo/polygon.hpp"
#include "storage/repository/encoding/blob_codec.hpp"

namespace floeplan::repository {

/// A polygon as one blob; every bit of its positions is kept. It holds the number of rings (the outer one
/// first), the number of positions in each, all longitudes, all latitudes.
/// Errors   std::runtime_error from `unpack_polygon` for a damaged blob
/// The packed view is valid until the next call of the codec.
[[nodiscard]] std::span<const std::byte> pack_polygon(BlobCodec& codec, const geo::Polygon& polygon);
[[nodiscard]] geo::Polygon unpack_polygon(BlobCodec& codec, std::span<const std::byte> blob);

}  // namespace floeplan::repository
