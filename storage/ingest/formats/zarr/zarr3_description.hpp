#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// An array of a Zarr store of version 3, described as version 2 would.
struct Zarr3Array {
  std::vector<std::uint64_t> shape;
  std::vector<std::uint64_t> chunk_shape;
  std::string chunk_prefix;  // "c/" of the key "c/0/0", "c." of "c.0.0"; empty of keys as version 2 has them
  std::string array_text;    // .zarray
  std::string attributes_text;  // .zattrs
};

/// Takes the description of an array apart, `zarr.json` as text. A fill of zero is what chunks hold that were not
/// written; any other also marks missing values, beside the one that the attribute _FillValue states.
/// Returns  nothing of a group, and of an array of texts or other things that are no numbers
/// Source   Zarr core specification version 3.0 and version 2; _FillValue of floating-point arrays in base64 as xarray
///          writes it
/// Errors   a damaged description; codecs, keys or chunks that version 2 does not have, above all shards
[[nodiscard]] Checked<std::optional<Zarr3Array>> zarr3_array(std::string_view text);

/// The attributes of a group (or anything else that has some) as .zattrs; "{}" when there are none.
[[nodiscard]] std::string zarr3_attributes(std::string_view text);

}  // namespace floeplan::ingest
