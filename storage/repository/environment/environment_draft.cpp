#include "storage/repository/environment/environment_draft.hpp"

#include <algorithm>
#include <utility>

#include "engine/core/utc_text.hpp"
#include "engine/messages/data_messages.hpp"
#include "engine/ocean/iceberg_drift.hpp"
#include "storage/repository/datasets/dataset_row.hpp"

namespace floeplan::repository {
namespace {

CurrentGridCache::Part cache_part_of(const EnvironmentDraft& draft, const Dataset& dataset,
                                     const std::optional<Period>& period) {
  const std::int64_t row = dataset_row(draft.db, dataset.id);
  if (!period) return {row, std::nullopt, std::nullopt};
  return {row, core::unix_seconds(period->from), core::unix_seconds(period->to)};
}

/// The grid from the cache of earlier readings, or else the result of `read`.
template <class Read>
std::shared_ptr<const ocean::CurrentGrid> kept_or_read(const Reading& reading,
                                                       const CurrentGridCache::Key& key, const Read& read) {
  if (reading.kept_currents != nullptr)
    if (auto kept = reading.kept_currents->find(key)) return kept;
  std::optional<ocean::CurrentGrid> found = read();
  if (!found) return nullptr;
  auto grid = std::make_shared<const ocean::CurrentGrid>(std::move(*found));
  if (reading.kept_currents != nullptr && !reading.stop.stop_requested())
    reading.kept_currents->keep(key, grid);
  return grid;
}

}  // namespace

std::optional<Period> period_of(const Dataset& dataset) {
  if (!dataset.time_start || !dataset.time_end) return std::nullopt;
  return Period{*dataset.time_start, *dataset.time_end};
}

std::string coverage_text(const Dataset& dataset, const Period& period) {
  if (period.from == period.to) return title(dataset) + " has only the time " + core::iso8601(period.from);
  return title(dataset) + " covers " + period_text(period);
}

std::string period_text(const Period& period) {
  if (period.from == period.to) return core::iso8601(period.from);
  return core::iso8601(period.from) + " to " + core::iso8601(period.to);
}

bool covers(const Period& period, core::UtcTime time) { return period.from <= time && time <= period.to; }

void tell_of_gap(EnvironmentDraft& draft, const DatasetChoice& choice, messages::Message left_out,
                 messages::Message missing) {
  draft.tell(choice.how == DatasetChoice::How::none ? std::move(left_out) : std::move(missing));
}

std::vector<JoinedPart> joined_parts(const EnvironmentDraft& draft, const std::vector<Dataset>& found,
                                     std::size_t which, bool named) {
  const EnvironmentQuery& query = draft.query;
  if (!period_of(found[which])) return {};
  if (named) return join_runs(draft.db, {found[which]}, 0, {}, query.depart, query.may_begin_later);
  // A run that ends before the first moment may be followed by one that begins after it.
  constexpr core::Seconds before{2.0 * 86400.0};
  // Limits the memory if a year of runs is stored. Chosen: no mission that is planned in one piece lasts
  // longer.
  constexpr core::Seconds beyond{30.0 * 86400.0};
  const core::UtcTime last = query.until ? std::max(query.depart, query.until->time) : query.depart;
  return join_runs(draft.db, found, which, {drift_start(draft) - before, last + beyond}, query.depart,
                   query.may_begin_later);
}

std::optional<Period> joined_period(const Dataset& dataset, const std::vector<JoinedPart>& parts) {
  if (parts.empty()) return period_of(dataset);
  return Period{parts.front().used.from, parts.back().used.to};
}

void cite_joined(EnvironmentDraft& draft, const std::vector<JoinedPart>& parts) {
  if (parts.size() == 1) return draft.cite(parts.front().dataset);
  std::string text;
  for (const JoinedPart& part : parts) {
    draft.cite(part.dataset, part.used);
    text += (text.empty() ? "" : ", then ") + title(part.dataset) + " from " + period_text(part.used);
  }
  draft.tell(messages::data_message<"runs-joined">(kind_name(parts.front().dataset.kind), text));
}

std::shared_ptr<const ocean::CurrentGrid> read_joined(const EnvironmentDraft& draft,
                                                      const std::vector<JoinedPart>& parts,
                                                      const CurrentsBox& box, core::UtcTime from) {
  CurrentGridCache::Key key{.parts = {},
                            .area = box.area,
                            .from_s = core::unix_seconds(from),
                            .deepest_m = box.deepest ? std::optional{box.deepest->value} : std::nullopt};
  for (const JoinedPart& part : parts) key.parts.push_back(cache_part_of(draft, part.dataset, part.used));
  return kept_or_read(draft.reading, key, [&] {
    return load_joined(draft.db, parts, box.area, from, box.deepest, draft.reading.stop);
  });
}

std::shared_ptr<const ocean::CurrentGrid> read_currents(const EnvironmentDraft& draft, const Dataset& dataset,
                                                        const CurrentsBox& box,
                                                        const std::optional<Period>& period) {
  const CurrentGridCache::Key key{
      .parts = {cache_part_of(draft, dataset, period)},
      .area = box.area,
      .from_s = std::nullopt,
      .deepest_m = box.deepest ? std::optional{box.deepest->value} : std::nullopt};
  return kept_or_read(draft.reading, key, [&] {
    return FieldRepository{draft.db, draft.reading.stop}.load_currents(dataset.id, box.area, period,
                                                                       box.deepest);
  });
}

bool covers_begin(const Period& period, const EnvironmentQuery& query) {
  return covers(period, query.depart) || (query.may_begin_later && query.depart <= period.to);
}

core::UtcTime drift_start(const EnvironmentDraft& draft) {
  core::UtcTime start = draft.query.depart;
  if (!draft.query.iceberg_drift) return start;
  for (const ocean::Iceberg& iceberg : draft.environment.icebergs)
    start = std::min(start, ocean::forecast_needs_from(iceberg));
  return start;
}

}  // namespace floeplan::repository
