#include "storage/repository/datasets/dataset.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "storage/repository/datasets/resampled.hpp"

namespace floeplan::repository {
namespace {

struct KindWords {
  DatasetKind kind;
  const char* name;
  const char* row;
};

constexpr std::array kind_words{KindWords{DatasetKind::bathymetry, "bathymetry", "grid node"},
                                KindWords{DatasetKind::currents, "currents", "grid node"},
                                KindWords{DatasetKind::wind, "wind", "grid node"},
                                KindWords{DatasetKind::ice, "ice", "grid node"},
                                KindWords{DatasetKind::icebergs, "icebergs", "sighting"},
                                KindWords{DatasetKind::coastline, "coastline", "polygon"},
                                KindWords{DatasetKind::tides, "tides", "place"},
                                KindWords{DatasetKind::water_levels, "water-levels", "place"},
                                KindWords{DatasetKind::zones, "zones", "zone"},
                                KindWords{DatasetKind::glider_tracks, "glider-tracks", "point"}};

const KindWords& words_of(DatasetKind kind) {
  const auto found = std::ranges::find(kind_words, kind, &KindWords::kind);
  if (found == kind_words.end()) throw std::logic_error{"DatasetKind without words"};
  return *found;
}

}  // namespace

std::string kind_name(DatasetKind kind) { return words_of(kind).name; }

std::string rows_text(DatasetKind kind, std::int64_t count) {
  return std::to_string(count) + ' ' + words_of(kind).row + (count == 1 ? "" : "s");
}

std::optional<DatasetKind> parse_kind(const std::string& name) {
  const auto found = std::ranges::find(kind_words, name, &KindWords::name);
  if (found == kind_words.end()) return std::nullopt;
  return found->kind;
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
