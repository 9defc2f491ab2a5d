#include "storage/ingest/files/sidecar.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

/// The name that a sidecar shares with its main file, in lower case; nullopt for files that are no sidecars.
std::optional<std::string> shared_name(const std::filesystem::path& file) {
  constexpr auto endings = std::to_array<std::string_view>(
      {".shp.xml", ".aux.xml", ".dbf", ".shx", ".prj", ".cpg", ".sbn", ".sbx", ".qix", ".qpj", ".tfw"});
  const std::string name = lower(file.filename().string());
  for (const std::string_view ending : endings)
    if (name.ends_with(ending)) return name.substr(0, name.size() - ending.size());
  return std::nullopt;
}

}  // namespace

bool is_sidecar(const std::filesystem::path& file) { return shared_name(file).has_value(); }

bool is_sidecar_of(const std::filesystem::path& sidecar, const std::filesystem::path& file) {
  const auto shared = shared_name(sidecar);
  return shared && !is_sidecar(file) && sidecar.parent_path() == file.parent_path() &&
         (*shared == lower(file.stem().string()) || *shared == lower(file.filename().string()));
}

}  // namespace floeplan::ingest
