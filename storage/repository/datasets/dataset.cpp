#include "storage/repository/datasets/dataset.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "storage/repository/datasets/resampled.hpp"

namespace floeplan::repository {
namespace {

constexpr std::array names{std::pair{DatasetKind::bathymetry, "bathymetry"},
                           std::pair{DatasetKind::currents, "currents"},
                           std::pair{DatasetKind::wind, "wind"},
                           std::pair{DatasetKind::ice, "ice"},
                           std::pair{DatasetKind::icebergs, "icebergs"},
                           std::pair{DatasetKind::coastline, "coastline"},
                           std::pair{DatasetKind::tides, "tides"},
                           std::pair{DatasetKind::water_levels, "water-levels"},
                           std::pair{DatasetKind::zones, "zones"},
                           std::pair{DatasetKind::glider_tracks, "glider-tracks"}};

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

void sort_newest_run_first(std::vector<Dataset>& datasets) {
  const auto newness = [](const Dataset& dataset) {
    return std::tuple{dataset.run.value_or(dataset.provenance.ingested), dataset.time_start,
                      dataset.time_end};
  };
  std::ranges::stable_sort(datasets, [&](const Dataset& a, const Dataset& b) {
    return std::tuple{newness(b), was_resampled(a.warnings), b.provenance.ingested, a.id} <
           std::tuple{newness(a), was_resampled(b.warnings), a.provenance.ingested, b.id};
  });
}

std::optional<StaleMark> stale_mark(const Dataset& dataset, std::span<const Dataset> all) {
  if (dataset.outdated) return StaleMark{"outdated: " + dataset.warnings.back(), std::nullopt};
  if (!was_resampled(dataset.warnings)) return std::nullopt;
  const auto better = std::ranges::find_if(all, [&](const Dataset& other) {
    return other.kind == dataset.kind && other.provenance.sha256 == dataset.provenance.sha256 &&
           !was_resampled(other.warnings);
  });
  const std::string by = "resampled by an earlier version: ";
  if (better == all.end())
    return StaleMark{by + "ingest the file again for the values at its own points", {}};
  return StaleMark{by + better->id.value + " has the values at the file's own points", better->id};
}

}  // namespace floeplan::repository
