#include "storage/ingest/formats/zarr/zarr_store.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "engine/messages/ingest_zarr_messages.hpp"
#include "storage/ingest/files/file_digest.hpp"
#include "storage/ingest/files/first_bytes.hpp"
#include "storage/ingest/formats/zarr/zarr3_description.hpp"
#include "storage/json/json.hpp"

namespace floeplan::ingest {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t max_files = 100'000;
constexpr std::uint64_t max_chunk_bytes = 256'000'000;
constexpr std::uint64_t most_bytes_a_value = 16;

messages::Message damaged_store(const fs::path& file, const std::string& why) {
  const std::string array = file.parent_path().filename().string();
  return messages::ingest_zarr_message<"zarr-damaged">(
      "the description " + array + "/" + file.filename().string(), why);
}

/// The product of the numbers; nullopt if one is not a positive whole number or the product exceeds `most`.
std::optional<std::uint64_t> product_of_counts(const json& numbers, std::uint64_t most) {
  if (!numbers.is_array()) return std::nullopt;
  std::uint64_t result = 1;
  for (const json& number : numbers) {
    if (!number.is_number_unsigned()) return std::nullopt;
    const auto count = number.get<std::uint64_t>();
    if (count == 0 || count > most / result) return std::nullopt;
    result *= count;
  }
  return result;
}

/// The description of an array in the form of version 2; null if the description is not of an array.
Checked<json> array_of(const fs::path& description, int version) {
  if (fs::file_size(description) > max_zarr_description_bytes)
    return refuse(damaged_store(description, "is over 1 MB long"));
  const std::string text = first_bytes(description, max_zarr_description_bytes);
  if (version == 2) return json::parse(text, nullptr, false);
  const auto array = zarr3_array(text);
  if (!array) return refuse(array.error());
  const std::optional<Zarr3Array>& numbers = *array;
  return numbers ? json::parse(numbers->array_text) : json{};
}

Checked<bool> check_array(const fs::path& description, int version, std::size_t chunk_files) {
  const auto described = array_of(description, version);
  if (!described) return refuse(described.error());
  const json& array = *described;
  if (version == 3 && array.is_null()) return true;
  if (!array.is_object() || !array.contains("shape") || !array.contains("chunks"))
    return refuse(damaged_store(description, "has no shape or no chunks"));
  const json& shape = array["shape"];
  const json& chunks = array["chunks"];
  constexpr std::uint64_t max_values = 4'000'000'000'000;
  if (!product_of_counts(shape, max_values) ||
      !product_of_counts(chunks, max_chunk_bytes / most_bytes_a_value) || shape.size() != chunks.size())
    return refuse(damaged_store(
        description,
        "gives a shape or chunks that are none, or chunks over 256 MB, more than this program unpacks"));
  std::uint64_t needed = 1;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const auto length = shape[i].get<std::uint64_t>();
    const auto chunk = chunks[i].get<std::uint64_t>();
    needed *= (length + chunk - 1) / chunk;
    if (needed > 10 * max_files) break;
  }
  if (needed > 10 * (chunk_files + 1))
    return refuse(damaged_store(
        description,
        "needs " + std::to_string(needed) + " chunks, but there are only " + std::to_string(chunk_files)));
  return true;
}

}  // namespace

bool is_zarr(const std::filesystem::path& folder) {
  return std::ranges::any_of(std::array{"zarr.json", ".zgroup", ".zmetadata", ".zarray"},
                             [&](const char* name) { return std::filesystem::exists(folder / name); });
}

bool is_zarr3(const fs::path& folder) { return fs::exists(folder / "zarr.json"); }

Checked<ZarrStore> open_zarr(const fs::path& folder) {
  ZarrStore store;
  store.version = is_zarr3(folder) ? 3 : 2;
  const std::string description = store.version == 3 ? "zarr.json" : ".zarray";
  if (store.version == 3) {
    const auto top = zarr3_array(first_bytes(folder / description, max_zarr_description_bytes));
    if (!top) return refuse(top.error());
    if (*top) return refuse(messages::ingest_zarr_message<"zarr-array-alone">());
  }
  if (store.version == 2 && !fs::exists(folder / ".zgroup"))
    return refuse(messages::ingest_zarr_message<"zarr-without-group">());
  std::error_code error;
  for (auto entry = fs::recursive_directory_iterator{folder, error};
       entry != fs::recursive_directory_iterator{}; entry.increment(error)) {
    if (error) return refuse(messages::ingest_zarr_message<"zarr-unreadable">());
    if (entry->is_symlink() || (!entry->is_directory() && !entry->is_regular_file()))
      return refuse(messages::ingest_zarr_message<"zarr-with-links">(entry->path().filename().string()));
    if (entry->is_directory()) continue;
    store.files.push_back(entry->path());
    store.bytes += entry->file_size();
    if (store.files.size() > max_files)
      return refuse(messages::ingest_zarr_message<"zarr-with-too-many-files">());
  }
  if (error) return refuse(messages::ingest_zarr_message<"zarr-unreadable">());
  std::ranges::sort(store.files);
  for (const fs::path& file : store.files) {
    if (file.filename() != description) continue;
    const auto beside = std::ranges::count_if(store.files, [&](const fs::path& other) {
      return other.string().starts_with(file.parent_path().string() + "/") &&
             other.filename().string()[0] != '.' && other.filename() != description;
    });
    if (const auto checked = check_array(file, store.version, static_cast<std::size_t>(beside)); !checked)
      return refuse(checked.error());
  }
  return store;
}

std::uint64_t bytes_of_zarr(const fs::path& folder) {
  const auto store = open_zarr(folder);
  return store ? store->bytes : 0;
}

Checked<std::string> sha256_of_zarr(const fs::path& folder) {
  const auto store = open_zarr(folder);
  if (!store) return refuse(store.error());
  std::string digests;
  for (const fs::path& file : store->files) {
    const auto digest = sha256_of_file(file);
    if (!digest) return refuse(digest.error());
    digests += file.lexically_relative(folder).generic_string() + " " + *digest + "\n";
  }
  return sha256_of_text(digests);
}

}  // namespace floeplan::ingest
