#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

#include "engine/core/utc_text.hpp"
#include "engine/messages/ingest_iceberg_messages.hpp"
#include "storage/ingest/notation/delimited_text.hpp"
#include "storage/ingest/notation/stated_place.hpp"
#include "storage/ingest/notation/table_dates.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/icebergs/iceberg_readers.hpp"
#include "storage/ingest/readers/icebergs/iceberg_rows.hpp"
#include "storage/ingest/readers/icebergs/position_errors.hpp"
#include "storage/json/json.hpp"

namespace floeplan::ingest {
namespace {

using nlohmann::json;

constexpr double metres_a_nautical_mile = 1852.0;
constexpr double longest_nm = 220.0;         // B-15 was 160 nautical miles long
constexpr double shortest_listed_nm = 10.0;  // the US National Ice Center names bergs from this length on
constexpr std::size_t max_bytes = 50'000'000;

std::string bare(std::string line) {
  if (line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
  while (line.ends_with('\r')) line.pop_back();
  return line;
}

/// The header of a table, which gives the column of each name.
class Header {
 public:
  explicit Header(const std::string& line) : names_{csv_fields(bare(line))} {
    for (std::string& name : names_) name = lower(trimmed(name));
  }

  [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const {
    const auto found = std::ranges::find(names_, name);
    if (found == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names_.begin());
  }
  [[nodiscard]] bool has_all(std::initializer_list<std::string_view> names) const {
    return std::ranges::all_of(names, [&](std::string_view name) { return column(name).has_value(); });
  }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

/// One row of a table; values are found by the names of the columns.
class TableRow {
 public:
  TableRow(const Header& header, const std::vector<std::string>& fields) : header_{header}, fields_{fields} {}

  /// Text in the column with this name; empty if there is none.
  [[nodiscard]] std::string text(std::string_view name) const {
    const auto column = header_.column(name);
    return column ? trimmed(fields_[*column]) : std::string{};
  }
  [[nodiscard]] std::optional<double> number(std::string_view name) const { return parse_number(text(name)); }

 private:
  const Header& header_;
  const std::vector<std::string>& fields_;
};

Checked<geo::LonLat> berg_place(std::optional<double> lon, std::optional<double> lat) {
  if (!lon || !lat) return refuse(messages::ingest_iceberg_message<"iceberg-position-not-a-number">());
  const geo::LonLat place{*lon, *lat};
  if (auto fault = fault_of_place(place)) return refuse(std::move(*fault));
  return place;
}

/// The longer of two lengths in nautical miles, as metres; empty if neither is stated.
Checked<std::optional<core::Metres>> length_of(std::optional<double> a_nm, std::optional<double> b_nm) {
  const double longest = std::max(a_nm.value_or(0.0), b_nm.value_or(0.0));
  if (longest < 0.0 || longest > longest_nm)
    return refuse(messages::ingest_iceberg_message<"iceberg-too-long">(ingest::number(longest)));
  if (longest == 0.0) return std::nullopt;
  return core::Metres{longest * metres_a_nautical_mile};
}

ocean::IcebergSize size_of(const std::optional<core::Metres>& length) {
  return length && length->value > 200.0 ? ocean::IcebergSize::very_large : ocean::IcebergSize::unknown;
}

bool is_ice_center(const Header& header) {
  return header.has_all({"iceberg", "length (nm)", "width (nm)", "latitude", "longitude", "last update"});
}

Checked<ocean::Iceberg> row_of_ice_center(const TableRow& row) {
  ocean::Iceberg iceberg;
  iceberg.id = row.text("iceberg");
  if (iceberg.id.empty()) return refuse(messages::ingest_iceberg_message<"iceberg-without-name">());
  const auto place = berg_place(row.number("longitude"), row.number("latitude"));
  if (!place) return refuse(place.error());
  iceberg.place = *place;
  const auto observed = us_date(row.text("last update"));
  if (!observed)
    return refuse(
        messages::ingest_iceberg_message<"iceberg-day-unusable">(row.text("last update"), "MM/DD/YYYY"));
  iceberg.observed = *observed;
  const auto length = length_of(row.number("length (nm)"), row.number("width (nm)"));
  if (!length) return refuse(length.error());
  iceberg.length = *length;
  iceberg.size = size_of(*length);
  if (lower(row.text("remarks")).find("grounded") != std::string::npos) iceberg.shape = "grounded";
  iceberg.method = "USNIC";
  return iceberg;
}

bool is_beacon(const Header& header) {
  return header.has_all({"beacon_id", "datetime_data", "latitude", "longitude"});
}

/// Accuracy radius of an Argos position of this class; empty without a class.
std::optional<core::Metres> argos_accuracy(const std::string& loc_class) {
  if (loc_class.empty()) return std::nullopt;
  if (loc_class == "3" || loc_class == "3.0") return core::Metres{250.0};
  if (loc_class == "2" || loc_class == "2.0") return core::Metres{500.0};
  return core::Metres{1500.0};
}

Checked<ocean::Iceberg> row_of_beacon(const TableRow& row) {
  ocean::Iceberg iceberg;
  iceberg.id = row.text("beacon_id");
  if (iceberg.id.empty()) return refuse(messages::ingest_iceberg_message<"beacon-missing">());
  const auto place = berg_place(row.number("longitude"), row.number("latitude"));
  if (!place) return refuse(place.error());
  iceberg.place = *place;
  std::string time = row.text("datetime_data");
  std::ranges::replace(time, ' ', 'T');
  const auto observed = core::parse_iso8601(time);
  if (!observed)
    return refuse(messages::ingest_iceberg_message<"beacon-time-unusable">(row.text("datetime_data")));
  iceberg.observed = *observed;
  iceberg.position_uncertainty = argos_accuracy(row.text("loc_accuracy"));
  iceberg.method = "beacon";
  return iceberg;
}

/// The sensors of a consolidated track, from the names of its columns; the most trusted first.
std::vector<std::string> sensors_of(const Header& header) {
  std::vector<std::string> sensors;
  for (const char* sensor :
       {"ascat", "qscat", "seawinds", "oscat", "nscat", "ers", "ers1", "ers2", "sass", "nic"})
    if (header.has_all({std::string{sensor} + "_1", std::string{sensor} + "_2", std::string{sensor} + "_3"}))
      sensors.emplace_back(sensor);
  return sensors;
}

bool is_track(const Header& header) { return header.column("date") && !sensors_of(header).empty(); }

/// A sensor's position of one day.
struct SensorFix {
  geo::LonLat place;
  bool seen{};
  std::string sensor;
};

std::optional<SensorFix> sensor_fix_of(const TableRow& row, const std::string& sensor) {
  const auto lat = row.number(sensor + "_1");
  const auto lon = row.number(sensor + "_2");
  const auto flag = row.number(sensor + "_3");
  if (!lat || !lon || (*lat == 0.0 && *lon == 0.0)) return std::nullopt;
  return SensorFix{{*lon, *lat}, flag == 1.0, sensor};
}

/// Reads the rows of one berg's track. A size stated in one row applies to the rows after it.
class Track {
 public:
  Track(std::string id, const Header& header) : id_{std::move(id)}, sensors_{sensors_of(header)} {}

  Checked<ocean::Iceberg> sighting(const TableRow& row) {
    const auto day = year_and_day(row.text("date"));
    if (!day)
      return refuse(messages::ingest_iceberg_message<"iceberg-day-unusable">(row.text("date"), "YYYYDDD"));
    const auto stated = length_of(row.number("size_1"), row.number("size_2"));
    if (!stated) return refuse(stated.error());
    if (*stated) length_ = *stated;

    std::optional<SensorFix> best;
    for (const std::string& sensor : sensors_) {
      const auto fix = sensor_fix_of(row, sensor);
      if (fix && (!best || (fix->seen && !best->seen))) best = fix;
    }
    if (!best) return refuse(messages::ingest_iceberg_message<"iceberg-sensor-position-missing">());
    const auto place = berg_place(best->place.lon_deg, best->place.lat_deg);
    if (!place) return refuse(place.error());
    ocean::Iceberg iceberg;
    iceberg.id = id_;
    iceberg.place = *place;
    iceberg.observed = *day;
    iceberg.length = length_;
    iceberg.size = size_of(length_);
    iceberg.method = best->sensor + (best->seen ? "" : " interpolated");
    return iceberg;
  }

 private:
  std::string id_;
  std::vector<std::string> sensors_;
  std::optional<core::Metres> length_;
};

/// "52 49'S" as -52.8167.
std::optional<double> degrees_and_minutes(const std::string& text, char positive, char negative) {
  const std::size_t gap = text.find(' ');
  const std::size_t mark = text.find('\'', gap == std::string::npos ? 0 : gap);
  if (gap == std::string::npos || mark == std::string::npos || mark + 2 != text.size()) return std::nullopt;
  const auto degrees = whole_number(text.substr(0, gap));
  const auto minutes = parse_number(text.substr(gap + 1, mark - gap - 1));
  const char side = text.back();
  if (!degrees || !minutes || *degrees < 0 || *minutes < 0.0 || *minutes >= 60.0) return std::nullopt;
  if (side != positive && side != negative) return std::nullopt;
  return (side == positive ? 1.0 : -1.0) * (*degrees + *minutes / 60.0);
}

std::string text_in(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string{};
}

Checked<ocean::Iceberg> listed(const json& item) {
  if (!item.is_object()) return refuse(messages::ingest_iceberg_message<"iceberg-not-an-object">());
  ocean::Iceberg iceberg;
  iceberg.id = text_in(item, "iceberg");
  if (iceberg.id.empty()) return refuse(messages::ingest_iceberg_message<"iceberg-without-name">());
  const auto place = berg_place(degrees_and_minutes(text_in(item, "dms_longitude"), 'E', 'W'),
                                degrees_and_minutes(text_in(item, "dms_lattitude"), 'N', 'S'));
  if (!place) return refuse(place.error());
  iceberg.place = *place;
  const auto observed = us_date(text_in(item, "recent_observation"));
  if (!observed)
    return refuse(messages::ingest_iceberg_message<"iceberg-day-unusable">(
        text_in(item, "recent_observation"), "MM/DD/YY"));
  iceberg.observed = *observed;
  iceberg.length = core::Metres{shortest_listed_nm * metres_a_nautical_mile};
  iceberg.size = ocean::IcebergSize::very_large;
  iceberg.method = "BYU";
  return iceberg;
}

using ReadRow = std::function<Checked<ocean::Iceberg>(const TableRow&)>;

Checked<PreparedDataset> read_rows(std::ifstream& in, const Header& header, const ReadRow& read_row) {
  const PositionErrors position_errors{header.names(), {"loc_accuracy"}};
  IcebergRows rows;
  std::string line;
  for (int line_number = 2; std::getline(in, line); ++line_number) {
    const std::string where = "line " + std::to_string(line_number);
    std::vector<std::string> fields = csv_fields(bare(line));
    if (fields.size() == 1 && trimmed(fields.front()).empty()) continue;
    while (fields.size() > header.names().size() && trimmed(fields.back()).empty()) fields.pop_back();
    if (fields.size() != header.names().size()) {
      rows.reject(where, messages::ingest_iceberg_message<"iceberg-row-short">(
                             fields.size(), header.names().size(),
                             in.eof() ? "; the file seems to be cut short" : ""));
      continue;
    }
    auto iceberg = read_row(TableRow{header, fields});
    if (iceberg) iceberg = with_position_error(std::move(*iceberg), position_errors, fields);
    if (iceberg) {
      rows.accept(std::move(*iceberg));
    } else {
      rows.reject(where, iceberg.error().front());
    }
  }
  return std::move(rows).prepared(header.names(), position_errors.warnings());
}

}  // namespace

bool is_iceberg_table_header(const std::string& line) {
  const Header header{line};
  return is_ice_center(header) || is_beacon(header) || is_track(header);
}

bool is_iceberg_list_json(std::string_view head) {
  return contains_any(head, {"\"icebergs\""}) && contains_any(head, {"\"dms_longitude\""});
}

Checked<PreparedDataset> read_iceberg_table(const std::filesystem::path& file) {
  std::ifstream in{file};
  std::string line;
  std::getline(in, line);
  const Header header{line};
  if (is_ice_center(header)) return read_rows(in, header, &row_of_ice_center);
  if (is_beacon(header)) return read_rows(in, header, &row_of_beacon);
  if (!is_track(header)) return refuse(messages::ingest_iceberg_message<"iceberg-columns-unknown">());

  Track track{file.stem().string(), header};
  auto data = read_rows(in, header, [&](const TableRow& row) { return track.sighting(row); });
  if (data)
    data->warnings.insert(data->warnings.begin(),
                          messages::ingest_iceberg_message<"track-named-after-file">(file.stem().string()));
  return data;
}

Checked<PreparedDataset> read_iceberg_list_json(const std::filesystem::path& file) {
  if (std::filesystem::file_size(file) > max_bytes)
    return refuse(messages::ingest_iceberg_message<"iceberg-list-too-long">());
  std::ifstream in{file, std::ios::binary};
  const std::string text{std::istreambuf_iterator<char>{in}, {}};
  const json document = json::parse(text, nullptr, false);
  if (!document.is_object() || !document.contains("icebergs") || !document["icebergs"].is_array())
    return refuse(messages::ingest_iceberg_message<"iceberg-list-damaged">());
  IcebergRows rows;
  int position = 0;
  for (const json& item : document["icebergs"]) {
    auto iceberg = listed(item);
    ++position;
    if (iceberg) {
      rows.accept(std::move(*iceberg));
    } else {
      rows.reject("iceberg " + std::to_string(position), iceberg.error().front());
    }
  }
  auto data = std::move(rows).prepared({"iceberg", "dms_longitude", "dms_lattitude", "recent_observation"});
  if (data)
    data->warnings.insert(data->warnings.begin(),
                          messages::ingest_iceberg_message<"iceberg-sizes-not-stated">());
  return data;
}

}  // namespace floeplan::ingest
