#include "storage/ingest/readers/icebergs/iceberg_rows.hpp"

#include <algorithm>
#include <iterator>

#include "engine/messages/ingest_iceberg_messages.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/repository/features/iceberg_repository.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::size_t max_reasons = 10;

/// Latitudes of the icebergs seen nearest to the equator: in the South Atlantic in 1894, at 26.5 S, and off
/// Bermuda in 1926, at 30.3 N.
constexpr double southern_record_deg = -26.5;
constexpr double northern_record_deg = 30.3;

void warn_of_warm_places(const std::vector<ocean::Iceberg>& icebergs, Messages& warnings) {
  const auto warm = [](const ocean::Iceberg& iceberg) {
    return iceberg.place.lat_deg > southern_record_deg && iceberg.place.lat_deg < northern_record_deg;
  };
  const auto count = std::ranges::count_if(icebergs, warm);
  if (count == 0) return;
  const ocean::Iceberg& first = *std::ranges::find_if(icebergs, warm);
  warnings.push_back(messages::ingest_iceberg_message<"icebergs-in-warm-water">(count, first.id,
                                                                                number(first.place.lat_deg)));
}

}  // namespace

Checked<std::optional<core::Metres>> metres_of(const std::string& name, const std::string& text,
                                               std::optional<double> value, double most_m, Zero zero) {
  if (text.empty()) return std::nullopt;
  if (!value || *value < 0.0 || (*value == 0.0 && zero == Zero::refused) || *value > most_m)
    return refuse(messages::ingest_iceberg_message<"iceberg-length-unusable">(name, text, number(most_m)));
  return core::Metres{*value};
}

void IcebergRows::reject(const std::string& where, messages::Message reason) {
  ++rejected_;
  if (reasons_.size() < max_reasons) reasons_.push_back(about(where + " was left out", std::move(reason)));
}

Checked<PreparedDataset> IcebergRows::prepared(std::vector<std::string> variables, Messages warnings) && {
  if (icebergs_.empty())
    return refuse(messages::ingest_iceberg_message<"no-usable-sighting">(
        reasons_.empty() ? std::string{"it has no rows"} : reason_of({reasons_.front()})));

  PreparedDataset data;
  data.kind = repository::DatasetKind::icebergs;
  data.variables = std::move(variables);
  data.rows_accepted = static_cast<std::int64_t>(icebergs_.size());
  data.rows_refused = rejected_;
  data.warnings = std::move(warnings);
  std::ranges::copy(reasons_, std::back_inserter(data.warnings));
  if (rejected_ > static_cast<std::int64_t>(reasons_.size()))
    data.warnings.push_back(messages::ingest_iceberg_message<"rows-left-out">(
        rejected_ - static_cast<std::int64_t>(reasons_.size())));

  warn_of_warm_places(icebergs_, data.warnings);

  std::vector<geo::LonLat> places;
  places.reserve(icebergs_.size());
  for (const ocean::Iceberg& iceberg : icebergs_) places.push_back(iceberg.place);
  data.bounds = geo::bounding_box(places);
  const auto [first, last] =
      std::minmax_element(icebergs_.begin(), icebergs_.end(),
                          [](const auto& a, const auto& b) { return a.observed < b.observed; });
  data.time_start = first->observed;
  data.time_end = last->observed;
  data.write = [icebergs = std::move(icebergs_)](sql::Connection& db,
                                                 const repository::DatasetId& id) -> Checked<void> {
    repository::IcebergRepository{db}.insert(id, icebergs);
    return {};
  };
  return data;
}

}  // namespace floeplan::ingest
