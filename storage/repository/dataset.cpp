#include "storage/repository/dataset.hpp"

#include <array>
#include <stdexcept>
#include <utility>

namespace floeplan::repository {
namespace {

constexpr std::array names{std::pair{DatasetKind::bathymetry, "bathymetry"},
                           std::pair{DatasetKind::currents, "currents"},
                           std::pair{DatasetKind::wind, "wind"},
                           std::pair{DatasetKind::ice, "ice"},
                           std::pair{DatasetKind::icebergs, "icebergs"},
                           std::pair{DatasetKind::coastline, "coastline"},
                           std::pair{DatasetKind::tides, "tides"},
                           std::pair{DatasetKind::zones, "zones"}};

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

bool has_steps(DatasetKind kind) {
  return kind == DatasetKind::currents || kind == DatasetKind::wind || kind == DatasetKind::ice;
}

}  // namespace floeplan::repository
