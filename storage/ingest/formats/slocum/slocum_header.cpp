#include "storage/ingest/formats/slocum/slocum_header.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

#include "engine/messages/ingest_track_messages.hpp"
#include "storage/ingest/formats/slocum/slocum_bytes.hpp"
#include "storage/ingest/formats/slocum/slocum_log.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::uintmax_t most_cache_bytes = 4'000'000;
constexpr int most_sensors = 20'000;  // a Slocum's list of 2019 has 2,142 sensors
constexpr int most_tags = 100;

/// The values of the lines "key: value" at the beginning of a log.
struct Tags {
  int sensors{};
  int listed{};  // sensors in the file's own list; 0: the log is factored
  std::string cache_crc;
  std::size_t size{};  // length of the lines in bytes
};

std::string_view next_line(std::string_view bytes, std::size_t& at) {
  const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
  const std::string_view line = bytes.substr(at, end - at);
  at = std::min(end + 1, bytes.size());
  return line;
}

int whole(std::string_view text, int most) {
  const auto value = parse_number(trimmed(text));
  const bool fits = value && *value >= 0.0 && *value <= most && *value == std::floor(*value);
  return fits ? static_cast<int>(*value) : -1;
}

Checked<Tags> tags_of(std::string_view bytes) {
  Tags tags;
  int count = most_tags;
  bool factored = false;
  int total = 0;
  int state_bytes = 0;
  for (int line_number = 0; line_number < count; ++line_number) {
    const std::string_view line = next_line(bytes, tags.size);
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos)
      return refuse(messages::ingest_track_message<"binary-log-damaged">("its tags end early"));
    const std::string_view key = line.substr(0, colon);
    const std::string_view value = line.substr(colon + 1);
    if (key == "num_ascii_tags") count = whole(value, most_tags);
    if (key == "sensors_per_cycle") tags.sensors = whole(value, most_sensors);
    if (key == "state_bytes_per_cycle") state_bytes = whole(value, most_sensors);
    if (key == "total_num_sensors") total = whole(value, most_sensors);
    if (key == "sensor_list_factored") factored = whole(value, 1) == 1;
    if (key == "sensor_list_crc") tags.cache_crc = lower(trimmed(value));
  }
  if (tags.sensors < 1 || state_bytes != (tags.sensors + 3) / 4 || total < tags.sensors)
    return refuse(
        messages::ingest_track_message<"binary-log-damaged">("its tags do not say how many sensors it has"));
  tags.listed = factored ? 0 : total;
  return tags;
}

/// The unit of a sensor in masterdata, for the sensors of positions, currents, axes, depths and times.
std::string_view unit_of(std::string_view sensor) {
  if (sensor.starts_with("x_utm_to_lmc_")) return "nodim";
  if (sensor == "x_lmc_utm_zone_digit") return "byte";
  if (sensor == "m_gps_mag_var") return "rad";
  if (sensor.ends_with("_vx") || sensor.ends_with("_vy")) return "m/s";
  if (sensor.ends_with("_lat")) return "lat";
  if (sensor.ends_with("_lon")) return "lon";
  if (sensor == "m_depth") return "m";
  return sensor == "m_present_time" ? "timestamp" : "enum";
}

messages::Message in_another_unit(const std::string& sensor, const std::string& unit) {
  return messages::ingest_track_message<"sensor-unit-altered">(sensor, unit, unit_of(sensor));
}

/// Reads lines "s: T <number> <index in a cycle> <bytes> <name> <unit>"; F and -1 mark a sensor that is not
/// in this log.
Checked<std::vector<LoggedSensor>> sensors_in(std::string_view bytes, std::size_t& at, int lines,
                                              int wanted) {
  std::vector<LoggedSensor> sensors;
  for (int i = 0; i < lines; ++i) {
    std::istringstream line{std::string{next_line(bytes, at)}};
    std::string label;
    std::string in_log;
    std::string name;
    std::string unit;
    int number = -1;
    int index = -1;
    std::size_t size = 0;
    line >> label >> in_log >> number >> index >> size >> name;
    const bool is_size = size == 1 || size == 2 || size == 4 || size == 8;
    if (!line || label != "s:" || !is_size)
      return refuse(messages::ingest_track_message<"binary-log-damaged">(
          "line " + std::to_string(i + 1) + " of the list of its sensors is none"));
    if (in_log != "T") continue;
    if (index != static_cast<int>(sensors.size()))
      return refuse(
          messages::ingest_track_message<"binary-log-damaged">("the list of its sensors is out of order"));
    const auto known = std::ranges::find(slocum_sensors, name);
    sensors.push_back({.bytes = size, .wanted = std::nullopt});
    if (known == slocum_sensors.end()) continue;
    line >> unit;
    if (unit != unit_of(name)) return refuse(in_another_unit(name, unit));
    sensors.back().wanted = static_cast<std::size_t>(known - slocum_sensors.begin());
  }
  if (static_cast<int>(sensors.size()) != wanted)
    return refuse(messages::ingest_track_message<"sensor-list-of-another-log">(sensors.size(), wanted));
  return sensors;
}

/// Whether a file has the name of the cache with this checksum, compressed or not.
bool is_cache_name(const std::filesystem::path& file, const std::string& crc) {
  const std::string name = lower(file.filename().string());
  return name == crc + ".cac" || name == crc + ".ccc";
}

std::optional<std::filesystem::path> cache_beside(const std::filesystem::path& log, const std::string& crc,
                                                  const FileGroup& given) {
  const auto is_it = [&](const std::filesystem::path& file) { return is_cache_name(file, crc); };
  const auto found = std::ranges::find_if(given, is_it);
  if (found != given.end()) return *found;
  std::string upper = crc;
  for (char& c : upper) c = c >= 'a' && c <= 'f' ? static_cast<char>(c - 'a' + 'A') : c;
  for (const std::string& stem : {crc, upper}) {
    for (const char* extension : {".cac", ".CAC", ".ccc", ".CCC"}) {
      std::filesystem::path beside = log.parent_path() / (stem + extension);
      std::error_code ignored;
      if (std::filesystem::is_regular_file(beside, ignored)) return beside;
    }
  }
  return std::nullopt;
}

/// Whether a text is a checksum and so can safely be part of a file name.
bool is_crc(const std::string& text) {
  return !text.empty() && text.size() <= 8 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::string head_of(const std::filesystem::path& file) { return slocum_bytes(file, 16'384).bytes; }

}  // namespace

bool is_slocum_binary(std::string_view head) {
  const std::string_view first = head.substr(0, head.find('\n'));
  return first.starts_with("dbd_label:") && first.find("DBD_ASC") == std::string_view::npos;
}

bool holds_slocum_binary(const std::filesystem::path& file) { return is_slocum_binary(head_of(file)); }

bool is_sensor_cache(std::string_view head) { return head.starts_with("s: T") || head.starts_with("s: F"); }

bool holds_sensor_cache(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored) && is_sensor_cache(head_of(file));
}

bool is_cache_of(const std::filesystem::path& cache, const std::filesystem::path& log) {
  const std::string head = head_of(log);
  if (!is_slocum_binary(head)) return false;
  const auto tags = tags_of(head);
  return tags && tags->listed == 0 && is_cache_name(cache, tags->cache_crc);
}

FileGroup without_sensor_caches(const FileGroup& files) {
  FileGroup logs;
  std::ranges::copy_if(files, std::back_inserter(logs),
                       [](const std::filesystem::path& file) { return !holds_sensor_cache(file); });
  return logs;
}

Checked<SlocumHeader> slocum_header_of(const std::filesystem::path& log, std::string_view bytes,
                                       const FileGroup& given) {
  const auto tags = tags_of(bytes);
  if (!tags) return refuse(tags.error());
  std::size_t at = tags->size;
  if (tags->listed > 0) {
    auto sensors = sensors_in(bytes, at, tags->listed, tags->sensors);
    if (!sensors) return refuse(sensors.error());
    return SlocumHeader{std::move(*sensors), at};
  }
  if (!is_crc(tags->cache_crc))
    return refuse(
        messages::ingest_track_message<"binary-log-damaged">("its tags do not name the list of its sensors"));
  const auto cache = cache_beside(log, tags->cache_crc, given);
  if (!cache) return refuse(messages::ingest_track_message<"sensor-list-missing">(tags->cache_crc + ".cac"));
  const std::string text = slocum_bytes(*cache, most_cache_bytes).bytes;
  std::size_t in_cache = 0;
  auto sensors = sensors_in(text, in_cache, static_cast<int>(std::ranges::count(text, '\n')), tags->sensors);
  if (!sensors) return refuse(sensors.error());
  return SlocumHeader{std::move(*sensors), at};
}

}  // namespace floeplan::ingest
