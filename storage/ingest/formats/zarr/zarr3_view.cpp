#include "storage/ingest/formats/zarr/zarr3_view.hpp"

#include <cpl_vsi.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <mutex>
#include <optional>

#include "storage/ingest/files/first_bytes.hpp"
#include "storage/ingest/formats/zarr/zarr3_description.hpp"
#include "storage/ingest/formats/zarr/zarr_store.hpp"

namespace floeplan::ingest {
namespace {

namespace fs = std::filesystem;

constexpr const char* prefix = "/vsizarr3/";  // GDAL keeps the pointer

/// What GDAL sees under a path: a translated text, or a file or folder of the store.
struct Seen {
  std::optional<std::string> text;
  std::string file;  // path in the store; used if there is no text
};

bool is_there(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(file, ignored);
}

std::string description_in(const fs::path& folder) {
  return first_bytes(folder / "zarr.json", max_zarr_description_bytes);
}

std::optional<Zarr3Array> array_in(const fs::path& folder) {
  auto array = zarr3_array(description_in(folder));
  return array ? std::move(*array) : std::nullopt;
}

/// The file of a chunk. Its array's folder may be several levels up.
std::string file_of_chunk(const fs::path& file) {
  for (fs::path folder = file.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
    if (!is_there(folder / "zarr.json")) continue;
    const auto array = array_in(folder);
    if (!array) return file.string();
    if (array->shape.empty()) return (folder / (array->chunk_prefix.empty() ? "0" : "c")).string();
    return (folder / (array->chunk_prefix + file.lexically_relative(folder).generic_string())).string();
  }
  return file.string();
}

/// Finds what GDAL sees under a path; nullopt if nothing exists. GDAL passes `path` without the prefix.
std::optional<Seen> seen_under(const char* path) {
  const fs::path file = "/" + std::string{path};
  const std::string name = file.filename().string();
  const fs::path folder = file.parent_path();
  if (name.starts_with(".z")) {
    if (!is_there(folder / "zarr.json")) return std::nullopt;
    const auto array = array_in(folder);
    if (name == ".zarray" && array) return Seen{array->array_text, {}};
    if (name == ".zgroup" && !array) return Seen{R"({"zarr_format":2})", {}};
    if (name == ".zattrs")
      return Seen{array ? array->attributes_text : zarr3_attributes(description_in(folder)), {}};
    return std::nullopt;
  }
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) return Seen{std::nullopt, file.string()};
  const std::string chunk = file_of_chunk(file);
  if (name == "zarr.json" || !fs::is_regular_file(chunk, ignored)) return std::nullopt;
  return Seen{std::nullopt, chunk};
}

int stat_seen(void* /*unused*/, const char* path, VSIStatBufL* found, int /*flags*/) {
  const auto seen = seen_under(path);
  if (!seen) return -1;
  if (!seen->text) return VSIStatL(seen->file.c_str(), found);
  *found = {};
  found->st_mode = S_IFREG;
  found->st_size = static_cast<off_t>(seen->text->size());
  return 0;
}

void* open_seen(void* /*unused*/, const char* path, const char* access) {
  const auto seen = seen_under(path);
  if (!seen || std::strchr(access, 'w') != nullptr || std::strchr(access, '+') != nullptr) return nullptr;
  if (!seen->text) return VSIFOpenL(seen->file.c_str(), "rb");
  auto* const bytes = static_cast<GByte*>(VSIMalloc(std::max<std::size_t>(seen->text->size(), 1)));
  if (bytes == nullptr) return nullptr;
  std::ranges::copy(*seen->text, bytes);
  return VSIFileFromMemBuffer(nullptr, bytes, seen->text->size(), TRUE);
}

char** list_seen(void* /*unused*/, const char* path, int most) {
  const auto seen = seen_under(path);
  return seen && !seen->text ? VSIReadDirEx(seen->file.c_str(), most) : nullptr;
}

VSILFILE* handle_of(void* file) { return static_cast<VSILFILE*>(file); }

void install() {
  const std::unique_ptr<VSIFilesystemPluginCallbacksStruct, decltype(&VSIFreeFilesystemPluginCallbacksStruct)>
      calls{VSIAllocFilesystemPluginCallbacksStruct(), &VSIFreeFilesystemPluginCallbacksStruct};
  calls->stat = &stat_seen;
  calls->open = &open_seen;
  calls->read_dir = &list_seen;
  calls->tell = [](void* file) { return VSIFTellL(handle_of(file)); };
  calls->seek = [](void* file, vsi_l_offset offset, int whence) {
    return VSIFSeekL(handle_of(file), offset, whence);
  };
  calls->read = [](void* file, void* bytes, std::size_t size, std::size_t count) {
    return VSIFReadL(bytes, size, count, handle_of(file));
  };
  calls->eof = [](void* file) { return VSIFEofL(handle_of(file)); };
  calls->close = [](void* file) { return VSIFCloseL(handle_of(file)); };
  VSIInstallPluginHandler(prefix, calls.get());
}

}  // namespace

std::string zarr3_view(const fs::path& folder) {
  static std::once_flag once;
  std::call_once(once, &install);
  return std::string{prefix} + fs::absolute(folder).string().substr(1);
}

}  // namespace floeplan::ingest
