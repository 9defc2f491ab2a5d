#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// How long a description in a store may be.
inline constexpr std::uint64_t max_zarr_description_bytes = 1'000'000;

/// The files of a Zarr store of version 2 or 3, a folder, after checks that cost nothing: what a few bytes of
/// description make a reader allocate is bounded here.
struct ZarrStore {
  std::vector<std::filesystem::path> files;  // by name
  std::uint64_t bytes{};
  int version{2};
};

/// Whether a folder is a Zarr store, or a part of one, of any version.
[[nodiscard]] bool is_zarr(const std::filesystem::path& folder);
/// Whether it is one of version 3.
[[nodiscard]] bool is_zarr3(const std::filesystem::path& folder);

/// Errors   a store of version 3 of another layout than version 2 has; one that is no group; links and other things
///          that are no files; more than a hundred thousand files; an array whose description is damaged, whose chunks
///          unpack to more than 256 MB or that has fewer chunks than a tenth of those that its shape needs
[[nodiscard]] Checked<ZarrStore> open_zarr(const std::filesystem::path& folder);

/// The size of all files; 0 of what is no store.
[[nodiscard]] std::uint64_t bytes_of_zarr(const std::filesystem::path& folder);
/// SHA-256 over the names and the digests of all files.
[[nodiscard]] Checked<std::string> sha256_of_zarr(const std::filesystem::path& folder);

}  // namespace floeplan::ingest
