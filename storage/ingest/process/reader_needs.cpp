#include "storage/ingest/process/reader_needs.hpp"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <dlfcn.h>
#include <hdf5.h>
#include <ogr_srs_api.h>
#include <openssl/crypto.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>

#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/sql/foreign_database.hpp"

namespace floeplan::ingest {
namespace {

namespace fs = std::filesystem;

/// The folder of PROJ's data, such as EPSG's reference systems: the first of its folders that has them, as in
/// PROJ itself.
fs::path folder_of_proj() {
  const CPLStringList folders{OSRGetPROJSearchPaths()};
  std::error_code ignored;
  for (int i = 0; i < folders.size(); ++i)
    if (fs::exists(fs::path{folders[i]} / "proj.db", ignored)) return folders[i];
  return {};
}

/// The folder of GDAL's data, such as the classes and attributes of nautical charts.
fs::path folder_of_gdal() {
  const char* const found = CPLFindFile("gdal", "s57objectclasses.csv");
  return found == nullptr ? fs::path{} : fs::path{found}.parent_path();
}

/// The folder of the C library's character sets, one library file each. Texts of shapefiles need them.
fs::path folder_of_character_sets() {
  Dl_info library{};
  if (dladdr(reinterpret_cast<const void*>(&std::snprintf), &library) == 0) return {};
  return fs::path{library.dli_fname}.parent_path() / "gconv";
}

void add_data_of_libraries(std::vector<fs::path>& paths) {
  paths.insert(paths.end(),
               {folder_of_proj(), folder_of_gdal(), folder_of_character_sets(), "/dev/null", "/dev/urandom"});
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  std::error_code ignored;  // an error means that the file does not exist
  paths.insert(paths.end(), {fs::read_symlink("/proc/self/exe", ignored), "/proc/self/", "/usr/lib"});
#endif
  std::erase(paths, fs::path{});
}

bool is_sensor_cache_name(const fs::path& file) {
  const std::string ending = lower(file.extension().string());
  return ending == ".cac" || ending == ".ccc";
}

/// Names of the files in one folder: lower case, without the ending, with the dot before it.
using Stems = std::vector<std::string>;

void add_what_lies_beside(const fs::path& folder, const Stems& stems, std::vector<fs::path>& paths) {
  std::error_code error;
  for (fs::directory_iterator entry{folder, error}, end; !error && entry != end; entry.increment(error)) {
    const fs::path& file = entry->path();
    const std::string name = lower(file.filename().string());
    const auto belongs = [&](const std::string& stem) { return name.starts_with(stem); };
    std::error_code ignored;
    if ((is_sensor_cache_name(file) || std::ranges::any_of(stems, belongs)) &&
        entry->is_regular_file(ignored))
      paths.push_back(file);
  }
}

}  // namespace

void prepare_libraries() {
  OPENSSL_init_crypto(0, nullptr);
  sql::distrust_schemas();
  H5open();
  H5PLset_loading_state(0);
  register_drivers();
}

sandbox::FileNeeds needs_of_reader(const std::vector<fs::path>& files, const fs::path& staging) {
  sandbox::FileNeeds needs{.read = files, .write = staging};
  std::map<fs::path, Stems> folders;
  for (const fs::path& file : files) {
    Stems& stems = folders[file.parent_path()];
    std::string stem = lower(file.stem().string()) + ".";
    if (stems.empty() || stems.back() != stem) stems.push_back(std::move(stem));
  }
  for (const auto& [folder, stems] : folders) add_what_lies_beside(folder, stems, needs.read);
  add_data_of_libraries(needs.read);
  return needs;
}

}  // namespace floeplan::ingest
