#include "storage/ingest/formats/zarr/zarr3_description.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "engine/messages/ingest_zarr_messages.hpp"
#include "storage/json/json.hpp"

namespace floeplan::ingest {
namespace {

using nlohmann::json;

/// Names of the number types in versions 3 and 2. In version 2 the byte order stands before the name.
constexpr std::array number_types{
    std::pair<std::string_view, std::string_view>{"bool", "b1"},
    std::pair<std::string_view, std::string_view>{"int8", "i1"},
    std::pair<std::string_view, std::string_view>{"int16", "i2"},
    std::pair<std::string_view, std::string_view>{"int32", "i4"},
    std::pair<std::string_view, std::string_view>{"int64", "i8"},
    std::pair<std::string_view, std::string_view>{"uint8", "u1"},
    std::pair<std::string_view, std::string_view>{"uint16", "u2"},
    std::pair<std::string_view, std::string_view>{"uint32", "u4"},
    std::pair<std::string_view, std::string_view>{"uint64", "u8"},
    std::pair<std::string_view, std::string_view>{"float32", "f4"},
    std::pair<std::string_view, std::string_view>{"float64", "f8"},
};

/// The member of an object; null if there is none.
const json& member(const json& object, const char* name) {
  static const json nothing;
  if (!object.is_object()) return nothing;
  const auto found = object.find(name);
  return found == object.end() ? nothing : *found;
}

std::string text_or_empty(const json& value) {
  return value.is_string() ? value.get<std::string>() : std::string{};
}

messages::Message unreadable(const std::string& what) {
  return messages::ingest_zarr_message<"zarr-not-read">(what);
}

messages::Message damaged(const std::string& what) {
  return messages::ingest_zarr_message<"zarr-damaged">("the description of an array", what);
}

std::optional<std::vector<std::uint64_t>> counts(const json& numbers) {
  if (!numbers.is_array()) return std::nullopt;
  std::vector<std::uint64_t> result;
  for (const json& number : numbers) {
    if (!number.is_number_unsigned()) return std::nullopt;
    result.push_back(number.get<std::uint64_t>());
  }
  return result;
}

/// The compressor of version 2 for a codec of version 3; null if there is none.
json compressor_of(const std::string& name, const json& configuration) {
  // the level does not matter for reading
  if (name == "gzip" || name == "zstd") return {{"id", name}, {"level", 1}};
  if (name != "blosc") return nullptr;
  const std::string cname = text_or_empty(member(configuration, "cname"));
  if (cname.empty()) return nullptr;
  return {{"id", "blosc"}, {"cname", cname}, {"clevel", 1}, {"shuffle", 0}, {"blocksize", 0}};
}

struct Codecs {
  char order_of_bytes{'<'};
  json compressor;  // null: not compressed
};

/// Reads the list of codecs: first one that turns numbers into bytes, then at most one compressor.
Checked<Codecs> codecs_of(const json& list) {
  if (!list.is_array() || list.empty()) return refuse(damaged("has no codecs"));
  Codecs codecs;
  bool are_bytes = false;
  for (const json& codec : list) {
    const std::string name =
        codec.is_string() ? codec.get<std::string>() : text_or_empty(member(codec, "name"));
    const json& configuration = member(codec, "configuration");
    if (name == "sharding_indexed") return refuse(unreadable("keeps many chunks in one file (shards)"));
    if (name == "bytes" && !are_bytes) {
      are_bytes = true;
      if (text_or_empty(member(configuration, "endian")) == "big") codecs.order_of_bytes = '>';
      continue;
    }
    json compressor = are_bytes ? compressor_of(name, configuration) : json{};
    if (compressor.is_null() || !codecs.compressor.is_null())
      return refuse(
          unreadable("packs its numbers by the codec \"" + name.substr(0, 40) + "\", in this place"));
    codecs.compressor = std::move(compressor);
  }
  if (!are_bytes) return refuse(damaged("does not say how numbers become bytes"));
  return codecs;
}

/// Prefix and separator of the names of chunk files.
std::optional<std::pair<std::string, std::string>> chunk_keys(const json& encoding) {
  const std::string name = text_or_empty(member(encoding, "name"));
  if (name != "default" && name != "v2") return std::nullopt;
  std::string separator = text_or_empty(member(member(encoding, "configuration"), "separator"));
  if (separator.empty()) separator = name == "v2" ? "." : "/";
  if (separator != "." && separator != "/") return std::nullopt;
  return std::pair{name == "v2" ? std::string{} : "c" + separator, separator};
}

/// A number from its eight bytes in base64, lowest byte first.
std::optional<double> number_in_base64(const std::string& text) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  if (text.size() != 12 || text.back() != '=') return std::nullopt;
  std::uint64_t bits = 0;
  std::uint32_t pending = 0;
  int pending_bits = 0;
  int bytes = 0;
  for (const char c : text.substr(0, 11)) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    pending = (pending << 6U) | static_cast<std::uint32_t>(digit);
    pending_bits += 6;
    if (pending_bits < 8) continue;
    pending_bits -= 8;
    bits |= static_cast<std::uint64_t>((pending >> pending_bits) & 0xffU) << (8 * bytes++);
  }
  return std::bit_cast<double>(bits);
}

/// The attributes, with _FillValue as a number instead of base64. A fill value that is not finite is dropped:
/// it needs no mark.
json attributes_of(const json& array) {
  json attributes = member(array, "attributes");
  if (!attributes.is_object()) attributes = json::object();
  const auto fill = attributes.find("_FillValue");
  if (fill == attributes.end() || !fill->is_string()) return attributes;
  const auto number = number_in_base64(fill->get<std::string>());
  if (number && std::isfinite(*number))
    *fill = *number;
  else
    attributes.erase(fill);
  return attributes;
}

bool all_are_texts(const json& names, std::size_t count) {
  return names.is_array() && names.size() == count &&
         std::ranges::all_of(names, [](const json& name) { return name.is_string(); });
}

}  // namespace

Checked<std::optional<Zarr3Array>> zarr3_array(std::string_view text) {
  const json array = json::parse(text, nullptr, false);
  if (!array.is_object() || member(array, "zarr_format") != 3) return refuse(damaged("is none of version 3"));
  if (text_or_empty(member(array, "node_type")) != "array") return std::nullopt;
  const std::string type_name = text_or_empty(member(array, "data_type"));
  const auto* const type =
      std::ranges::find(number_types, type_name, &std::pair<std::string_view, std::string_view>::first);
  if (type == number_types.end()) return std::nullopt;

  const json& grid = member(array, "chunk_grid");
  const auto shape = counts(member(array, "shape"));
  const auto chunk_shape = counts(member(member(grid, "configuration"), "chunk_shape"));
  if (!shape) return refuse(damaged("has no shape"));
  if (text_or_empty(member(grid, "name")) != "regular" || !chunk_shape ||
      chunk_shape->size() != shape->size())
    return refuse(unreadable("has chunks of different sizes"));
  const json& transformers = member(array, "storage_transformers");
  if (!transformers.is_null() && !transformers.empty())
    return refuse(unreadable("stores its chunks by a transformer"));
  const auto keys = chunk_keys(member(array, "chunk_key_encoding"));
  if (!keys) return refuse(unreadable("calls its chunks by names of another kind"));
  auto codecs = codecs_of(member(array, "codecs"));
  if (!codecs) return refuse(codecs.error());

  json fill = member(array, "fill_value");
  const bool is_word = fill == "NaN" || fill == "Infinity" || fill == "-Infinity";
  if (!fill.is_number() && !fill.is_boolean() && !is_word)
    return refuse(
        unreadable("states the value of chunks that are not there as " + fill.dump().substr(0, 40)));
  if (fill == 0 || fill.is_boolean()) fill = nullptr;

  json attributes = attributes_of(array);
  const json& names = member(array, "dimension_names");
  if (all_are_texts(names, shape->size())) attributes["_ARRAY_DIMENSIONS"] = names;
  const bool has_order = type->second.back() != '1';
  const json described{
      {"zarr_format", 2},
      {"shape", *shape},
      {"chunks", *chunk_shape},
      {"dtype", (has_order ? std::string{codecs->order_of_bytes} : "|") + std::string{type->second}},
      {"compressor", codecs->compressor},
      {"fill_value", fill},
      {"filters", nullptr},
      {"order", "C"},
      {"dimension_separator", keys->second}};
  return Zarr3Array{*shape, *chunk_shape, keys->first, described.dump(), attributes.dump()};
}

std::string zarr3_attributes(std::string_view text) {
  const json node = json::parse(text, nullptr, false);
  const json& attributes = member(node, "attributes");
  return attributes.is_object() ? attributes.dump() : "{}";
}

}  // namespace floeplan::ingest
