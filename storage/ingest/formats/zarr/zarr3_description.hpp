#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// An array of a Zarr store of version 3, in the terms of version 2.
struct Zarr3Array {
  std::vector<std::uint64_t> shape;
  std::vector<std::uint64_t> chunk_shape;
  std::string chunk_prefix;     // "c/" for keys as "c/0/0", "c." for "c.0.0"; empty for keys as in version 2
  std::string array_text;       // text of a .zarray file
  std::string attributes_text;  // text of a .zattrs file
};

/// Translates the description of an array, the text of `zarr.json`. The fill value stands for chunks that
/// were not written. If it is not zero, it also marks missing values, in addition to the attribute
/// _FillValue.
/// Returns  nullopt for a group, and for an array whose values are not numbers
/// Source   Zarr core specification version 3.0 and version 2; _FillValue of floating-point arrays in base64,
///          as xarray writes it
/// Errors   a damaged description; codecs, keys or chunks that version 2 does not have, especially shards
[[nodiscard]] Checked<std::optional<Zarr3Array>> zarr3_array(std::string_view text);

/// The attributes of a group (or an array) as text of a .zattrs file; "{}" if there are none.
[[nodiscard]] std::string zarr3_attributes(std::string_view text);

}  // namespace floeplan::ingest
