#include "storage/ingest/iceberg_rows.hpp"

#include <algorithm>
#include <cmath>

#include "storage/ingest/text.hpp"
#include "storage/repository/iceberg_repository.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::size_t max_reasons = 10;

}  // namespace

std::string fault_of_place(geo::LonLat place) {
  if (!std::isfinite(place.lon_deg) || !std::isfinite(place.lat_deg)) return "the position is missing";
  if (std::abs(place.lat_deg) > 90.0) return "the latitude " + number(place.lat_deg) + " lies beyond a pole";
  if (place.lon_deg < -180.0 || place.lon_deg > 360.0)
    return "the longitude " + number(place.lon_deg) + " is not within -180 and 360";
  return {};
}

void IcebergRows::reject(const std::string& where, const std::string& reason) {
  ++rejected_;
  if (reasons_.size() < max_reasons) reasons_.push_back(where + " was left out: " + reason);
}

Checked<PreparedDataset> IcebergRows::prepared(std::vector<std::string> variables) && {
  if (icebergs_.empty())
    return refuse("the file holds no usable sighting" +
                  (reasons_.empty() ? std::string{"; it has no rows"} : "; " + reasons_.front()) +
                  "; correct the file and try again");

  PreparedDataset data;
  data.kind = repository::DatasetKind::icebergs;
  data.variables = std::move(variables);
  data.rows_accepted = static_cast<std::int64_t>(icebergs_.size());
  data.rows_refused = rejected_;
  data.warnings = reasons_;
  if (rejected_ > static_cast<std::int64_t>(reasons_.size()))
    data.warnings.push_back(std::to_string(rejected_ - static_cast<std::int64_t>(reasons_.size())) +
                            " more rows were left out");

  std::vector<geo::LonLat> places;
  for (const ocean::Iceberg& iceberg : icebergs_) places.push_back(iceberg.place);
  data.bounds = geo::bounding_box(places);
  const auto [first, last] =
      std::minmax_element(icebergs_.begin(), icebergs_.end(),
                          [](const auto& a, const auto& b) { return a.observed < b.observed; });
  data.time_start = first->observed;
  data.time_end = last->observed;
  data.write = [icebergs = std::move(icebergs_)](
                   sqlite::Connection& db,
                   const repository::DatasetId& id) -> tl::expected<void, std::string> {
    repository::IcebergRepository{db}.insert(id, icebergs);
    return {};
  };
  return data;
}

}  // namespace floeplan::ingest
