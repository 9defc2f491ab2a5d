#include "storage/repository/features/known_icebergs.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "storage/repository/datasets/dataset.hpp"
#include "storage/repository/features/joined_sightings.hpp"

namespace floeplan::repository {
namespace {

bool by_hand(const Dataset& dataset) { return dataset.id == hand_made_id(DatasetKind::icebergs); }

std::vector<Dataset> datasets_of_sightings(const std::vector<Dataset>& stored, const KnownIcebergs& known,
                                           const SightingQuery& query) {
  const auto begun = [&](const Dataset& dataset) {
    return !dataset.time_start || *dataset.time_start <= query.as_of;
  };
  const auto recent = [&](const Dataset& dataset) {
    return !dataset.time_end || *dataset.time_end >= known.oldest ||
           (query.also_left_out && query.as_of - *dataset.time_end < ocean::left_out_are_told);
  };
  std::vector<Dataset> chosen;
  std::ranges::copy_if(stored, std::back_inserter(chosen), [&](const Dataset& dataset) {
    return dataset.kind == DatasetKind::icebergs && !by_hand(dataset) && begun(dataset) && recent(dataset);
  });
  if (std::ranges::none_of(chosen, [&](const Dataset& dataset) { return known.speaks_here(dataset.id); }))
    if (const auto newest = std::ranges::find_if(
            known.here, [&](const Dataset& dataset) { return begun(dataset) && !by_hand(dataset); });
        newest != known.here.end())
      chosen.insert(chosen.begin(), *newest);
  std::ranges::copy_if(stored, std::back_inserter(chosen), by_hand);
  return chosen;
}

std::vector<Dataset> datasets_of_later_sightings(const std::vector<Dataset>& stored,
                                                 const KnownIcebergs& known, const SightingQuery& query) {
  if (query.choice.how != DatasetChoice::How::newest) return known.here;
  std::vector<Dataset> chosen;
  std::ranges::copy_if(stored, std::back_inserter(chosen), [&](const Dataset& dataset) {
    if (dataset.kind != DatasetKind::icebergs) return false;
    return by_hand(dataset) || !dataset.time_start || !dataset.time_end ||
           (*dataset.time_end > query.as_of && *dataset.time_start - query.as_of <= ocean::left_out_are_told);
  });
  return chosen;
}

}  // namespace

bool KnownIcebergs::speaks_here(const DatasetId& dataset) const {
  return std::ranges::find(here, dataset, &Dataset::id) != here.end();
}

KnownIcebergs known_icebergs(sql::Connection& db, const std::vector<Dataset>& stored,
                             const SightingQuery& query, core::Violations& violations) {
  KnownIcebergs known;
  known.oldest = ocean::oldest_that_counts(query.as_of, query.depart, query.max_age);
  const geo::BoundingBox reached = geo::grown(query.area, query.reach);
  const bool named = query.choice.how == DatasetChoice::How::named;
  known.here =
      candidates(stored, DatasetKind::icebergs, query.choice, named ? reached : query.area, violations);
  known.consulted = query.choice.how == DatasetChoice::How::newest
                        ? datasets_of_sightings(stored, known, query)
                        : known.here;

  constexpr core::Seconds any_age{std::numeric_limits<double>::infinity()};
  auto all = joined_sightings(db, known.consulted, reached, query.as_of,
                              query.also_left_out ? any_age : query.as_of - known.oldest, query.track_age);
  for (StoredSighting& sighting : all)
    (sighting.iceberg.observed >= known.oldest ? known.sightings : known.too_old)
        .push_back(std::move(sighting));
  if (query.also_left_out) {
    known.later = first_seen_after(db, datasets_of_later_sightings(stored, known, query), reached,
                                   query.as_of, query.as_of + ocean::left_out_are_told, known.sightings);
    known.too_old = without_bergs_of(db, std::move(known.too_old), known.later);
  }
  return known;
}

}  // namespace floeplan::repository
