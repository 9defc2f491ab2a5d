#include "storage/repository/dataset.hpp"

#include <array>
#include <stdexcept>
#include <utility>

namespace floeplan::repository {
namespace {

constexpr std::array<std::pair<DatasetKind, const char*>, 4> names{{{DatasetKind::bathymetry, "bathymetry"},
                                                                    {DatasetKind::currents, "currents"},
                                                                    {DatasetKind::icebergs, "icebergs"},
                                                                    {DatasetKind::coastline, "coastline"}}};

}  // namespace

std::string kind_name(DatasetKind kind) {
  for (const auto& [candidate, name] : names) {
    if (candidate == kind) return name;
  }
  throw std::logic_error{"DatasetKind without a name"};
}

std::optional<DatasetKind> parse_kind(const std::string& name) {
  for (const auto& [kind, candidate] : names) {
    if (name == candidate) return kind;
  }
  return std::nullopt;
}

}  // namespace floeplan::repository
