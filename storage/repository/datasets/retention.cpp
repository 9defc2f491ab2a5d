#include "storage/repository/datasets/retention.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

core::UtcTime last_use(const Dataset& dataset) {
  return std::max(dataset.time_end.value_or(dataset.provenance.ingested), dataset.provenance.ingested);
}

/// Whether no dataset of the same kind has a period that ends later.
bool is_last_of_kind(const Dataset& dataset, const std::vector<StoredSize>& stored) {
  return std::ranges::none_of(stored, [&](const StoredSize& other) {
    return other.dataset.kind == dataset.kind &&
           std::tuple{other.dataset.time_end, other.dataset.id} > std::tuple{dataset.time_end, dataset.id};
  });
}

}  // namespace

std::vector<StoredSize> beyond_retention(std::vector<StoredSize> stored, const RetentionRules& rules,
                                         core::UtcTime now) {
  if (rules.kind)
    std::erase_if(stored, [&](const StoredSize& each) { return each.dataset.kind != *rules.kind; });
  std::int64_t left = 0;
  std::vector<StoredSize> candidates;
  for (const StoredSize& each : stored) {
    left += each.bytes;
    if (each.dataset.time_end && !is_last_of_kind(each.dataset, stored)) candidates.push_back(each);
  }
  std::ranges::sort(candidates, {}, [](const StoredSize& each) {
    return std::tuple{*each.dataset.time_end, each.dataset.id};
  });

  std::vector<StoredSize> going;
  for (StoredSize& each : candidates) {
    const bool too_old = rules.max_age && now - last_use(each.dataset) > *rules.max_age;
    const bool too_much = rules.max_bytes && left > *rules.max_bytes;
    if (!too_old && !too_much) continue;
    left -= each.bytes;
    going.push_back(std::move(each));
  }
  return going;
}

std::vector<StoredSize> stored_sizes(sql::Connection& db) {
  std::vector<StoredSize> sizes;
  sql::Statement query{
      db,
      "SELECT CAST((SELECT coalesce(sum(length(samples)), 0) FROM field_chunk WHERE dataset_row = "
      "dataset.row) + "
      "(SELECT coalesce(sum(length(lons_deg) + length(lats_deg) + length(corners)), 0) FROM mesh_block WHERE "
      "dataset_row = dataset.row) + "
      "(SELECT coalesce(sum(length(times_s) + length(heights_m)), 0) FROM water_level_station WHERE dataset_row "
      "= dataset.row) + "
      "(SELECT coalesce(sum(length(way)), 0) FROM glider_track WHERE dataset_row = dataset.row) AS BIGINT) "
      "FROM dataset "
      "WHERE id = ?1"};
  for (Dataset& dataset : DatasetRepository{db}.list()) {
    query.bind(1, dataset.id.value);
    const std::int64_t bytes = query.step() ? query.integer(0) : 0;
    query.reset();
    sizes.push_back({std::move(dataset), bytes});
  }
  return sizes;
}

std::vector<StoredSize> remove_beyond_retention(sql::Connection& db, const RetentionRules& rules,
                                                core::UtcTime now) {
  sql::Transaction transaction{db};
  std::vector<StoredSize> going = beyond_retention(stored_sizes(db), rules, now);
  DatasetRepository datasets{db};
  for (const StoredSize& each : going) datasets.remove(each.dataset.id);
  transaction.commit();
  return going;
}

}  // namespace floeplan::repository
