#include "storage/repository/features/joined_sightings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "engine/geo/geodesic.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"

namespace floeplan::repository {
namespace {

constexpr geo::BoundingBox whole_world{-180.0, -90.0, 180.0, 90.0};

/// Bergs usually drift at 0.2 m/s, and at 1 m/s in the strongest currents; 1.5 m/s is no drift.
constexpr double fastest_drift_m_s = 1.5;
/// How far apart two sightings of one berg may be at the same time: weekly lists round to minutes of arc, and
/// bergs are tens of kilometres long.
constexpr double position_error_m = 20'000.0;

/// A key that is equal for datasets that use the same names of bergs.
std::string source_of(const Dataset& dataset) {
  std::string source = dataset.id == hand_made_id(DatasetKind::icebergs) ? dataset.id.value : "";
  for (const std::string& variable : dataset.variables) source += '\n' + variable;
  return source;
}

bool may_be_one_berg(geo::LonLat a, core::UtcTime at_a, geo::LonLat b, core::UtcTime at_b) {
  const double between_s = std::abs((at_b - at_a).count());
  return geo::geodesic_between(a, b).length.value <= position_error_m + fastest_drift_m_s * between_s;
}

/// Identifies sightings of one berg: by its name, or without one by its position.
using BergKey = std::tuple<std::string, double, double>;

BergKey key_of(const ocean::Iceberg& berg) {
  return berg.id.empty() ? BergKey{"", berg.place.lon_deg, berg.place.lat_deg} : BergKey{berg.id, 0.0, 0.0};
}

/// One dataset's newest sighting of each of its bergs.
struct Part {
  const Dataset* dataset;
  std::string source;
  std::vector<StoredSighting> sightings;
  std::multimap<BergKey, std::size_t> by_berg;
};

Part part_of(const Dataset& dataset, std::vector<StoredSighting> sightings) {
  Part part{&dataset, source_of(dataset), std::move(sightings), {}};
  for (std::size_t i = 0; i < part.sightings.size(); ++i)
    part.by_berg.emplace(key_of(part.sightings[i].iceberg), i);
  return part;
}

/// Whether `newer`, with the same key, replaces `older`, because it is the same berg seen later or at the
/// same time. `comes_first`: its dataset comes first, which decides between equal times.
bool replaces(const ocean::Iceberg& newer, const ocean::Iceberg& older, bool comes_first) {
  if (newer.observed == older.observed && newer.place == older.place) return comes_first;
  if (newer.id.empty() || newer.observed < older.observed) return false;
  if (newer.observed == older.observed && !comes_first) return false;
  return may_be_one_berg(newer.place, newer.observed, older.place, older.observed);
}

bool is_replaced(const ocean::Iceberg& berg, const std::vector<Part>& parts, std::size_t own) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i == own || parts[i].source != parts[own].source) continue;
    const auto [first, last] = parts[i].by_berg.equal_range(key_of(berg));
    for (auto other = first; other != last; ++other)
      if (replaces(parts[i].sightings[other->second].iceberg, berg, i < own)) return true;
  }
  return false;
}

/// Earlier fixes of the berg in all datasets of its source: oldest first, one for each time.
std::vector<ocean::IcebergFix> track_of(const IcebergRepository& repository, const StoredSighting& sighting,
                                        const std::vector<Part>& parts, const std::string& source,
                                        core::Seconds track_age) {
  std::map<core::UtcTime, geo::LonLat> fixes;
  for (const Part& part : parts) {
    if (part.source != source) continue;
    StoredSighting there = sighting;
    there.dataset = part.dataset->id;
    for (const ocean::IcebergFix& fix : repository.earlier(there, track_age))
      if (may_be_one_berg(fix.place, fix.time, sighting.iceberg.place, sighting.iceberg.observed))
        fixes.try_emplace(fix.time, fix.place);
  }
  std::vector<ocean::IcebergFix> track;
  track.reserve(fixes.size());
  for (const auto& [time, place] : fixes) track.push_back({place, time});
  return track;
}

/// Whether two stored sightings may be of one berg. Never true without a name, or for different sources.
class SameBerg {
 public:
  explicit SameBerg(sql::Connection& db) {
    for (const Dataset& dataset : DatasetRepository{db}.list()) sources_[dataset.id] = source_of(dataset);
  }
  [[nodiscard]] bool operator()(const StoredSighting& a, const StoredSighting& b) const {
    return !a.iceberg.id.empty() && a.iceberg.id == b.iceberg.id &&
           sources_.at(a.dataset) == sources_.at(b.dataset) &&
           may_be_one_berg(a.iceberg.place, a.iceberg.observed, b.iceberg.place, b.iceberg.observed);
  }

 private:
  std::map<DatasetId, std::string> sources_;
};

}  // namespace

std::vector<StoredSighting> joined_sightings(sql::Connection& db, const std::vector<Dataset>& datasets,
                                             const geo::BoundingBox& area, core::UtcTime as_of,
                                             core::Seconds max_age, core::Seconds track_age) {
  const IcebergRepository repository{db};
  // A berg that one dataset has in the area may later have been seen elsewhere by another.
  const geo::BoundingBox& searched = datasets.size() == 1 ? area : whole_world;
  std::vector<Part> parts;
  parts.reserve(datasets.size());
  for (const Dataset& dataset : datasets)
    parts.push_back(part_of(dataset, repository.latest(dataset.id, searched, as_of, max_age)));

  std::vector<StoredSighting> joined;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (const StoredSighting& sighting : parts[i].sightings) {
      if (!geo::contains(area, sighting.iceberg.place) || is_replaced(sighting.iceberg, parts, i)) continue;
      joined.push_back(sighting);
      if (track_age.count() > 0.0)
        joined.back().iceberg.earlier = track_of(repository, sighting, parts, parts[i].source, track_age);
    }
  }
  return joined;
}

std::vector<StoredSighting> first_seen_after(sql::Connection& db, const std::vector<Dataset>& datasets,
                                             const geo::BoundingBox& area, core::UtcTime as_of,
                                             core::UtcTime until,
                                             const std::vector<StoredSighting>& counted) {
  const SameBerg are_one{db};
  std::vector<StoredSighting> first;
  for (const Dataset& dataset : datasets) {
    const SightingFilter filter{.area = area, .from = as_of, .to = until, .dataset = dataset.id};
    for (StoredSighting& sighting : IcebergRepository{db}.list(filter, 0, std::numeric_limits<int>::max())) {
      const auto is_same = [&](const StoredSighting& other) { return are_one(sighting, other); };
      if (sighting.iceberg.observed <= as_of || std::ranges::any_of(counted, is_same)) continue;
      const auto known = std::ranges::find_if(first, is_same);
      if (known == first.end()) {
        first.push_back(std::move(sighting));
      } else if (sighting.iceberg.observed < known->iceberg.observed) {
        *known = std::move(sighting);
      }
    }
  }
  return first;
}

std::vector<StoredSighting> without_bergs_of(sql::Connection& db, std::vector<StoredSighting> sightings,
                                             const std::vector<StoredSighting>& others) {
  const SameBerg are_one{db};
  std::erase_if(sightings, [&](const StoredSighting& sighting) {
    return std::ranges::any_of(others, [&](const StoredSighting& other) { return are_one(sighting, other); });
  });
  return sightings;
}

}  // namespace floeplan::repository
