#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// The greatest length of a description in a store. Chosen.
inline constexpr std::uint64_t max_zarr_description_bytes = 1'000'000;

/// The files of a Zarr store of version 2 or 3, which is a folder. The store was checked first: a few bytes
/// of description could otherwise make a reader allocate any amount of memory.
struct ZarrStore {
  std::vector<std::filesystem::path> files;  // by name
  std::uint64_t bytes{};
  int version{2};
};

/// Whether a folder is a Zarr store, or a part of one, of any version.
[[nodiscard]] bool is_zarr(const std::filesystem::path& folder);
/// Whether a folder is a store, or a part of one, of version 3.
[[nodiscard]] bool is_zarr3(const std::filesystem::path& folder);

/// Lists and checks the files of a store.
/// Errors   a store of version 3 whose layout version 2 does not have; not a group; links and special files;
///          more than 100,000 files; an array with a damaged description, with chunks that unpack to more
///          than 256 MB, or with less than a tenth of the chunks that its shape needs
[[nodiscard]] Checked<ZarrStore> open_zarr(const std::filesystem::path& folder);

/// The size of all files in bytes; 0 for a folder that is no store.
[[nodiscard]] std::uint64_t bytes_of_zarr(const std::filesystem::path& folder);
/// SHA-256 over the names and the digests of all files.
[[nodiscard]] Checked<std::string> sha256_of_zarr(const std::filesystem::path& folder);

}  // namespace floeplan::ingest
