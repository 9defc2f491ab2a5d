#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/utc_text.hpp"
#include "engine/messages/ingest_iceberg_messages.hpp"
#include "storage/ingest/notation/cf_units.hpp"
#include "storage/ingest/notation/delimited_text.hpp"
#include "storage/ingest/notation/stated_place.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/icebergs/detection.hpp"
#include "storage/ingest/readers/icebergs/iceberg_readers.hpp"
#include "storage/ingest/readers/icebergs/iceberg_rows.hpp"
#include "storage/ingest/readers/icebergs/position_errors.hpp"

namespace floeplan::ingest {
namespace {

struct LengthColumn {
  std::size_t index{};
  double metres{1.0};  // metres per unit
};

/// The only column whose name is the quantity and a unit of length: "length_m", "length_ft". In tables of
/// icebergs "nm" is a nautical mile.
std::optional<LengthColumn> length_column(const DelimitedText& table, const std::string& quantity) {
  constexpr double nautical_mile_m = 1852.0;
  std::optional<LengthColumn> found;
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    const std::string& name = table.columns()[i];
    if (!name.starts_with(quantity + "_")) continue;
    const std::string unit = name.substr(quantity.size() + 1);
    const auto metres = unit == "nm" ? std::optional{nautical_mile_m} : length_factor(unit);
    if (!metres) continue;
    if (found) return std::nullopt;
    found = LengthColumn{i, *metres};
  }
  return found;
}

struct BergColumns {
  std::optional<std::size_t> id;  // empty in a list of detections
  std::size_t lat{};
  std::size_t lon{};
  std::size_t observed{};
  bool observed_in_utc{};
  std::optional<LengthColumn> length;
  std::optional<LengthColumn> draft;
  PositionErrors position_errors;
  std::optional<std::size_t> size;
  std::optional<std::size_t> shape;
  std::optional<std::size_t> method;
  std::optional<std::size_t> confidence;  // only in a list of detections
};

std::optional<BergColumns> berg_columns_of(const DelimitedText& table) {
  const auto id = table.column({"id", "name", "berg", "iceberg", "berg_id", "iceberg_id"});
  const auto lat = table.column({"lat", "latitude", "lat_deg", "latitude_deg"});
  const auto lon = table.column({"lon", "long", "longitude", "lon_deg", "longitude_deg"});
  const auto with_zone = table.column({"observed", "time", "timestamp", "datetime", "date_time", "date",
                                       "last_seen", "acquired", "acquisition_time", "image_time"});
  const auto in_utc =
      table.column({"observed_utc", "time_utc", "timestamp_utc", "datetime_utc", "date_time_utc", "date_utc",
                    "last_seen_utc", "acquired_utc", "acquisition_time_utc", "image_time_utc"});
  const auto confidence = table.column({confidence_names.begin(), confidence_names.end()});
  if ((!id && !confidence) || !lat || !lon || with_zone.has_value() == in_utc.has_value())
    return std::nullopt;
  const BergColumns columns{.id = id,
                            .lat = *lat,
                            .lon = *lon,
                            .observed = with_zone ? *with_zone : *in_utc,
                            .observed_in_utc = in_utc.has_value(),
                            .length = length_column(table, "length"),
                            .draft = length_column(table, "draft"),
                            .position_errors = PositionErrors{table.headers()},
                            .size = table.column({"size", "size_class"}),
                            .shape = table.column({"shape"}),
                            .method = table.column({"method", "source"}),
                            .confidence = confidence};
  return columns;
}

/// Whether the names of the columns show that the rows are icebergs.
bool name_icebergs(const DelimitedText& table, const BergColumns& columns) {
  return (columns.id && contains_any(table.columns()[*columns.id], {"berg"})) || columns.length ||
         columns.draft || columns.size;
}

/// A size whose column states no unit. It is not read, but the table may still be one of icebergs.
bool is_size_without_unit(const std::string& column) { return column == "length" || column == "draft"; }

/// Whether there are only an id, the columns of a sighting, and sizes without a unit.
bool are_sightings_alone(const DelimitedText& table, const BergColumns& columns) {
  std::size_t known = 4 + std::size_t{columns.shape.has_value()} + std::size_t{columns.method.has_value()};
  for (std::size_t i = 0; i < table.columns().size(); ++i)
    known += std::size_t{columns.position_errors.is_read(i) || is_size_without_unit(table.columns()[i])};
  return columns.id && table.columns()[*columns.id] == "id" && known == table.columns().size();
}

/// Warns of columns that seem to state a size or a position error but are not read.
Messages warnings_of(const DelimitedText& table, const BergColumns& columns) {
  Messages warnings = columns.position_errors.warnings();
  if (columns.confidence) warnings.push_back(messages::ingest_iceberg_message<"detections-all-count">());
  if (!name_icebergs(table, columns))
    warnings.push_back(messages::ingest_iceberg_message<"kind-of-sighting-not-stated">());
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    const std::string& name = table.columns()[i];
    if ((name.starts_with("length") && !columns.length) || (name.starts_with("draft") && !columns.draft))
      warnings.push_back(messages::ingest_iceberg_message<"iceberg-column-not-read">(table.header(i)));
  }
  return warnings;
}

/// One line; its fields are found by the meaning of their columns.
class Row {
 public:
  Row(const DelimitedText& table, const BergColumns& columns, std::vector<std::string> fields)
      : table_{table}, columns_{columns}, fields_{std::move(fields)} {}

  [[nodiscard]] Checked<ocean::Iceberg> sighting() const {
    ocean::Iceberg iceberg;
    iceberg.id = text(columns_.id);
    if (iceberg.id.empty() && !columns_.confidence)
      return refuse(messages::ingest_iceberg_message<"iceberg-without-column">(table_.header(*columns_.id)));
    const auto lat = table_.number(fields_[columns_.lat]);
    const auto lon = table_.number(fields_[columns_.lon]);
    if (!lat || !lon)
      return refuse(messages::ingest_iceberg_message<"iceberg-position-not-in-degrees">(
          fields_[columns_.lat], fields_[columns_.lon]));
    iceberg.place = {*lon, *lat};
    if (auto fault = fault_of_place(iceberg.place)) return refuse(std::move(*fault));
    const auto observed = time();
    if (!observed) return refuse(observed.error());
    iceberg.observed = *observed;
    const auto length = metres(columns_.length, longest_iceberg_m);
    if (!length) return refuse(length.error());
    iceberg.length = *length;
    const auto draft = metres(columns_.draft, deepest_iceberg_m);
    if (!draft) return refuse(draft.error());
    iceberg.draft = *draft;
    const auto error =
        columns_.position_errors.of([this](std::size_t column) { return fields_[column]; },
                                    [this](const std::string& field) { return table_.number(field); });
    if (!error) return refuse(error.error());
    iceberg.position_uncertainty = *error;
    if (const std::string size = text(columns_.size); !size.empty()) {
      const auto known = ocean::parse_size(lower(size));
      if (!known) return refuse(messages::ingest_iceberg_message<"iceberg-size-unknown">(size));
      iceberg.size = *known;
    }
    iceberg.shape = text(columns_.shape);
    iceberg.method = text(columns_.method);
    return columns_.confidence ? as_detection(std::move(iceberg), text(columns_.confidence)) : iceberg;
  }

 private:
  [[nodiscard]] std::string text(std::optional<std::size_t> column) const {
    return column ? fields_[*column] : std::string{};
  }

  [[nodiscard]] Checked<core::UtcTime> time() const {
    const std::string& observed = fields_[columns_.observed];
    if (const auto time = core::parse_iso8601(observed)) return *time;
    if (columns_.observed_in_utc)
      if (const auto time = core::parse_iso8601(observed + "Z")) return *time;
    return refuse(messages::ingest_iceberg_message<"iceberg-time-unusable">(
        table_.header(columns_.observed), observed,
        columns_.observed_in_utc ? "" : " with its zone; in UTC, call the column time_utc"));
  }

  [[nodiscard]] Checked<std::optional<core::Metres>> metres(const std::optional<LengthColumn>& column,
                                                            double most_m) const {
    if (!column) return std::nullopt;
    const std::string& value = fields_[column->index];
    auto length = table_.number(value);
    if (length) *length *= column->metres;
    return metres_of(table_.header(column->index), value, length, most_m);
  }

  const DelimitedText& table_;
  const BergColumns& columns_;
  std::vector<std::string> fields_;
};

}  // namespace

bool is_own_iceberg_table_header(std::string_view line, bool stated) {
  if (line.find_first_of(",;\t") == std::string_view::npos) return false;
  const DelimitedText table{line};
  const auto columns = berg_columns_of(table);
  return columns && (stated || name_icebergs(table, *columns) || are_sightings_alone(table, *columns));
}

Checked<PreparedDataset> read_own_iceberg_table(const std::filesystem::path& file) {
  std::ifstream in{file};
  std::string line;
  std::getline(in, line);
  const DelimitedText table{line};
  const auto columns = berg_columns_of(table);
  if (!columns) return refuse(messages::ingest_iceberg_message<"iceberg-columns-missing">());

  IcebergRows rows;
  for (int line_number = 2; std::getline(in, line); ++line_number) {
    const std::string where = "line " + std::to_string(line_number);
    auto fields = table.fields(line);
    if (fields.empty()) continue;
    if (fields.size() != table.columns().size()) {
      rows.reject(where, messages::ingest_iceberg_message<"iceberg-row-short">(
                             fields.size(), table.columns().size(),
                             in.eof() ? "; the file seems to be cut short" : ""));
      continue;
    }
    auto iceberg = Row{table, *columns, std::move(fields)}.sighting();
    if (iceberg) {
      rows.accept(std::move(*iceberg));
    } else {
      rows.reject(where, iceberg.error().front());
    }
  }
  return std::move(rows).prepared(table.columns(), warnings_of(table, *columns));
}

}  // namespace floeplan::ingest
