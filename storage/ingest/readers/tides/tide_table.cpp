#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>

#include "engine/geo/written_place.hpp"
#include "engine/messages/ingest_tide_messages.hpp"
#include "storage/ingest/notation/stated_place.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/tides/station_rows.hpp"
#include "storage/ingest/readers/tides/tide_readers.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/fields/tide_repository.hpp"

namespace floeplan::ingest {
namespace {

using nlohmann::json;
using repository::TideStation;

constexpr std::size_t max_bytes = 50'000'000;
constexpr std::size_t max_stations = 100'000;

std::vector<std::string> split_line(std::string_view line, std::string_view separators) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while ((begin = line.find_first_not_of(separators, begin)) != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    parts.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end;
  }
  return parts;
}

Checked<std::string> text_of_file(const std::filesystem::path& file) {
  if (std::filesystem::file_size(file) > max_bytes)
    return refuse(messages::ingest_tide_message<"station-list-too-long">());
  std::ifstream in{file, std::ios::binary};
  return std::string{std::istreambuf_iterator<char>{in}, {}};
}

Checked<double> unit_of(const std::string& stated, const IngestOptions& options) {
  const std::string unit = stated.empty() ? options.unit.value_or("") : stated;
  if (const auto metres = metres_of(unit)) return *metres;
  return refuse(unit.empty() ? messages::ingest_tide_message<"amplitude-unit-missing">()
                             : messages::ingest_tide_message<"amplitude-unit-unknown">(unit));
}

Checked<geo::LonLat> station_place(std::optional<double> lon, std::optional<double> lat,
                                   const IngestOptions& options) {
  if (options.at) return *options.at;
  if (!lon || !lat) return refuse(messages::ingest_tide_message<"station-place-missing">());
  const geo::LonLat place{*lon, *lat};
  if (const auto fault = fault_of_place(place))
    return refuse(messages::ingest_tide_message<"station-place-impossible">(fault->text));
  return *geo::written_place(*lon, *lat);
}

std::optional<double> number_in(const json& object, std::initializer_list<const char*> keys) {
  for (const char* key : keys) {
    const auto found = object.find(key);
    if (found != object.end() && found->is_number()) return found->get<double>();
    if (found != object.end() && found->is_string())
      return parse_number(found->get_ref<const std::string&>());
  }
  return std::nullopt;
}

std::string text_in(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string{};
}

/// The time to which phases refer.
enum class PhaseTime { unstated, greenwich, local };

/// The time to which phases refer according to a text in lower case.
PhaseTime phase_time_of(std::string_view text) {
  PhaseTime stated = PhaseTime::unstated;
  for (const std::string& line : split_line(text, "\r\n")) {
    const bool of_time = contains_any(line, {"time", "phase", "g_deg"});
    for (const std::string& word : split_line(line, " \t,;:()[]\"#_=/"))
      if ((word == "local" && of_time) || word == "lst" || word == "lmt") return PhaseTime::local;
    const std::size_t at = std::min(line.find("time zone"), line.find("timezone"));
    if (at != std::string::npos) {
      const auto zone = split_line(line.substr(line.find("zone", at) + 4), " \t,;:\"=");
      const bool at_greenwich = zone.empty() || zone[0] == "utc" || zone[0] == "gmt" || zone[0] == "z" ||
                                parse_number(zone[0]) == 0.0;
      if (!at_greenwich) return PhaseTime::local;
      if (!zone.empty()) stated = PhaseTime::greenwich;
    }
    if (contains_any(line, {"gmt", "utc", "greenwich"})) stated = PhaseTime::greenwich;
  }
  return stated;
}

/// Positions of the columns of a table.
struct TableColumns {
  std::size_t name{};
  std::size_t amplitude{};
  std::size_t phase{};
  std::optional<std::size_t> speed;
  std::string unit;        // "m", out of "A_m"; empty: not stated
  std::string phase_name;  // lower case
  char separator{','};
};

std::optional<TableColumns> table_columns(const std::string& line) {
  for (const char separator : {'\t', ',', ';'}) {
    const auto fields = split_line(line, std::string_view{&separator, 1});
    std::optional<std::size_t> name;
    std::optional<std::size_t> amplitude;
    std::optional<std::size_t> phase;
    TableColumns columns;
    columns.separator = separator;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const std::string field = lower(fields[i]);
      if (field == "name" || field == "constituent") name = i;
      if (field.starts_with("amplitude") || field.starts_with("amp") || field.starts_with("a_")) {
        amplitude = i;
        const std::size_t mark = field.find_last_of("_( ");
        if (mark != std::string::npos)
          columns.unit = trimmed(field.substr(mark + 1, field.find(')') - mark - 1));
      }
      const bool of_phase = field.starts_with("phase") || field.starts_with("g_deg");
      // If a table has phases for two times, those for Greenwich are used.
      if (of_phase && (!phase || phase_time_of(columns.phase_name) != PhaseTime::greenwich)) {
        phase = i;
        columns.phase_name = field;
      }
      if (field == "speed") columns.speed = i;
    }
    if (!name || !amplitude || !phase) continue;
    columns.name = *name;
    columns.amplitude = *amplitude;
    columns.phase = *phase;
    return columns;
  }
  return std::nullopt;
}

/// The first line that is no comment. `rest` moves behind it.
std::string header_of(std::string_view text, std::size_t& rest) {
  while (rest < text.size()) {
    const std::size_t end = std::min(text.find('\n', rest), text.size());
    const std::string line = trimmed(text.substr(rest, end - rest));
    rest = std::min(end + 1, text.size());
    if (!line.empty() && line[0] != '#' && !line.starts_with("\"#")) return line;
  }
  return {};
}

}  // namespace

bool is_tide_json(std::string_view head) {
  return contains_any(head, {"\"harmonic_constituents\"", "\"HarmonicConstituents\""});
}

bool is_tide_table(std::string_view head) {
  std::size_t rest = 0;
  return table_columns(header_of(head, rest)).has_value();
}

bool is_otps_extract(std::string_view head) {
  return head.find("_amp") != std::string_view::npos && head.find("_ph") != std::string_view::npos &&
         contains_any(head.substr(0, 2000), {"Elevations (m)"});
}

Checked<PreparedDataset> read_tide_json(const std::filesystem::path& file, const IngestOptions& options) {
  const auto text = text_of_file(file);
  if (!text) return refuse(text.error());
  const json document = json::parse(*text, nullptr, false);
  const char* key =
      document.contains("HarmonicConstituents") ? "HarmonicConstituents" : "harmonic_constituents";
  if (!document.is_object() || !document.contains(key) || !document[key].is_array())
    return refuse(messages::ingest_tide_message<"station-json-damaged">());
  const bool of_database = std::string_view{key} == "harmonic_constituents";  // this list is always in metres
  const auto metres = unit_of(of_database ? "m" : text_in(document, "units"), options);
  if (!metres) return refuse(metres.error());
  const auto place = station_place(number_in(document, {"longitude", "lng"}),
                                   number_in(document, {"latitude", "lat"}), options);
  if (!place) return refuse(place.error());

  StationRows rows;
  for (const json& item : document[key]) {
    const auto amplitude = number_in(item, {"amplitude"});
    const auto phase = number_in(item, {"phase_UTC", "phase_GMT"});
    if (!item.is_object() || text_in(item, "name").empty() || !amplitude || !phase)
      return refuse(messages::ingest_tide_message<"constituent-incomplete">());
    const auto added =
        rows.add({text_in(item, "name"), *amplitude, *phase, number_in(item, {"speed"})}, *metres);
    if (!added) return refuse(added.error());
  }
  Messages warnings;
  rows.warn(warnings);
  return prepared_stations(
      {{text_in(document, "name"), *place, ocean::TideQuantity::elevation, std::move(rows).constants()}},
      std::move(warnings));
}

Checked<PreparedDataset> read_tide_table(const std::filesystem::path& file, const IngestOptions& options) {
  const auto text = text_of_file(file);
  if (!text) return refuse(text.error());
  std::size_t rest = 0;
  const std::string header_line = header_of(*text, rest);
  const auto columns = table_columns(header_line);
  if (!columns) return refuse(messages::ingest_tide_message<"station-columns-missing">());
  const std::size_t header = text->rfind(header_line, rest);
  const PhaseTime phase_time = phase_time_of(lower(text->substr(0, header)) + "\n" + columns->phase_name);
  if (phase_time == PhaseTime::local) return refuse(messages::ingest_tide_message<"phases-in-local-time">());
  const auto metres = unit_of(metres_of(columns->unit) ? columns->unit : "", options);
  if (!metres) return refuse(metres.error());
  const auto place = station_place(std::nullopt, std::nullopt, options);
  if (!place) return refuse(place.error());

  StationRows rows;
  for (std::string line = header_of(*text, rest); !line.empty(); line = header_of(*text, rest)) {
    const auto fields = split_line(line, std::string_view{&columns->separator, 1});
    const std::size_t needed =
        std::max({columns->name, columns->amplitude, columns->phase, columns->speed.value_or(0)});
    if (fields.size() <= needed)
      return refuse(messages::ingest_tide_message<"station-row-short">(line.substr(0, 60)));
    const auto amplitude = parse_number(fields[columns->amplitude]);
    const auto phase = parse_number(fields[columns->phase]);
    const auto speed = columns->speed ? parse_number(fields[*columns->speed]) : std::nullopt;
    if (!amplitude || !phase || (columns->speed && !speed))
      return refuse(messages::ingest_tide_message<"station-row-incomplete">(line.substr(0, 60)));
    const auto added = rows.add({fields[columns->name], *amplitude, *phase, speed}, *metres);
    if (!added) return refuse(added.error());
  }
  Messages warnings;
  rows.warn(warnings);
  if (phase_time == PhaseTime::unstated)
    warnings.push_back(messages::ingest_tide_message<"phases-taken-as-greenwich">());
  return prepared_stations({{"", *place, ocean::TideQuantity::elevation, std::move(rows).constants()}},
                           std::move(warnings));
}

Checked<PreparedDataset> read_otps_extract(const std::filesystem::path& file) {
  const auto text = text_of_file(file);
  if (!text) return refuse(text.error());
  std::vector<std::string> names;  // names of the constituents, after the header was found
  std::vector<TideStation> stations;
  Messages warnings;
  std::int64_t outside = 0;
  for (const std::string& line : split_line(*text, "\n")) {
    const auto fields = split_line(line, " \t\r");
    if (names.empty()) {
      for (const std::string& field : fields)
        if (field.ends_with("_amp")) names.push_back(field.substr(0, field.size() - 4));
      continue;
    }
    if (line.find('*') != std::string::npos || line.find("Site is out") != std::string::npos) {
      ++outside;
      continue;
    }
    if (fields.size() != 2 + 2 * names.size())
      return refuse(messages::ingest_tide_message<"extract-row-short">(line.substr(0, 60), fields.size(),
                                                                       2 + 2 * names.size()));
    std::vector<double> numbers;
    for (const std::string& field : fields)
      if (const auto value = parse_number(field)) numbers.push_back(*value);
    if (numbers.size() != fields.size())
      return refuse(messages::ingest_tide_message<"extract-row-unreadable">(line.substr(0, 60)));
    const auto place = station_place(numbers[1], numbers[0], {});
    if (!place) return refuse(place.error());
    StationRows rows;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto added = rows.add({names[i], numbers[2 + 2 * i], numbers[3 + 2 * i], std::nullopt}, 1.0);
      if (!added) return refuse(added.error());
    }
    if (stations.empty()) rows.warn(warnings);
    stations.push_back({"", *place, ocean::TideQuantity::elevation, std::move(rows).constants()});
    if (stations.size() > max_stations) return refuse(messages::ingest_tide_message<"too-many-places">());
  }
  if (outside > 0) warnings.push_back(messages::ingest_tide_message<"places-outside-model">(outside));
  return prepared_stations(std::move(stations), std::move(warnings));
}

}  // namespace floeplan::ingest
