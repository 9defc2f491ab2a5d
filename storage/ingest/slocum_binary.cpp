#include "storage/ingest/slocum_binary.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>
#include <sstream>
#include <vector>

#include "storage/ingest/first_bytes.hpp"
#include "storage/ingest/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::uintmax_t most_bytes = 200'000'000;
constexpr std::uintmax_t most_cache_bytes = 4'000'000;
constexpr int most_sensors = 20'000;  // a Slocum's list of 2019 has 2,142
constexpr int most_tags = 100;

/// A sensor that each cycle has two bits for.
struct LoggedSensor {
  std::size_t bytes{};
  std::optional<std::size_t> wanted{};  // its place in slocum_sensors
};

/// What stands before the cycles of a log.
struct Header {
  int sensors{};
  int state_bytes{};
  int listed{};  // sensors in the file's own list; 0: it is factored
  std::string cache_crc;
  std::size_t size{};
};

std::string without_end(std::string_view what) {
  return "the binary log is damaged: " + std::string{what} + "; copy it from the glider again";
}

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

Checked<Header> header_of(std::string_view bytes) {
  Header header;
  int tags = most_tags;
  bool factored = false;
  int total = 0;
  for (int line_number = 0; line_number < tags; ++line_number) {
    const std::string_view line = next_line(bytes, header.size);
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) return refuse(without_end("its tags end early"));
    const std::string_view key = line.substr(0, colon);
    const std::string_view value = line.substr(colon + 1);
    if (key == "num_ascii_tags") tags = whole(value, most_tags);
    if (key == "sensors_per_cycle") header.sensors = whole(value, most_sensors);
    if (key == "state_bytes_per_cycle") header.state_bytes = whole(value, most_sensors);
    if (key == "total_num_sensors") total = whole(value, most_sensors);
    if (key == "sensor_list_factored") factored = whole(value, 1) == 1;
    if (key == "sensor_list_crc") header.cache_crc = lower(trimmed(value));
  }
  if (header.sensors < 1 || header.state_bytes != (header.sensors + 3) / 4 || total < header.sensors)
    return refuse(without_end("its tags do not say how many sensors it has"));
  header.listed = factored ? 0 : total;
  return header;
}

/// In which unit masterdata lists a sensor, and its position, current, depth and time are read.
std::string_view unit_of(std::string_view sensor) {
  if (sensor.ends_with("_vx") || sensor.ends_with("_vy")) return "m/s";
  if (sensor.ends_with("_lat")) return "lat";
  if (sensor.ends_with("_lon")) return "lon";
  if (sensor == "m_depth") return "m";
  return sensor == "m_present_time" ? "timestamp" : "enum";
}

/// Lines "s: T <number> <index in a cycle> <bytes> <name> <unit>"; F and -1: not in this log.
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
      return refuse(without_end("line " + std::to_string(i + 1) + " of the list of its sensors is none"));
    if (in_log != "T") continue;
    if (index != static_cast<int>(sensors.size()))
      return refuse(without_end("the list of its sensors is out of order"));
    const auto known = std::ranges::find(slocum_sensors, name);
    sensors.push_back({.bytes = size, .wanted = std::nullopt});
    if (known == slocum_sensors.end()) continue;
    line >> unit;
    if (unit != unit_of(name))
      return refuse("the binary log gives " + name + " in \"" + unit + "\", not in \"" +
                    std::string{unit_of(name)} +
                    "\" as all Slocums do; its list of sensors is damaged or altered; give the glider's own");
    sensors.back().wanted = static_cast<std::size_t>(known - slocum_sensors.begin());
  }
  if (static_cast<int>(sensors.size()) != wanted)
    return refuse("the list of sensors has " + std::to_string(sensors.size()) + ", the binary log " +
                  std::to_string(wanted) + "; it belongs to another log; give the one that the log names");
  return sensors;
}

std::optional<std::filesystem::path> cache_beside(const std::filesystem::path& log, const std::string& crc,
                                                  const FileGroup& given) {
  const auto is_it = [&](const std::filesystem::path& file) {
    return lower(file.filename().string()) == crc + ".cac";
  };
  const auto found = std::ranges::find_if(given, is_it);
  if (found != given.end()) return *found;
  std::string upper = crc;
  for (char& c : upper) c = c >= 'a' && c <= 'f' ? static_cast<char>(c - 'a' + 'A') : c;
  for (const std::string& name : {crc + ".cac", crc + ".CAC", upper + ".CAC", upper + ".cac"}) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(log.parent_path() / name, ignored)) return log.parent_path() / name;
  }
  return std::nullopt;
}

/// A checksum as text, fit to be part of a file's name.
bool is_crc(const std::string& text) {
  return !text.empty() && text.size() <= 8 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

Checked<std::vector<LoggedSensor>> sensors_of(const std::filesystem::path& log, std::string_view bytes,
                                              Header& header, const FileGroup& given) {
  if (header.listed > 0) return sensors_in(bytes, header.size, header.listed, header.sensors);
  if (!is_crc(header.cache_crc)) return refuse(without_end("its tags do not name the list of its sensors"));
  const auto cache = cache_beside(log, header.cache_crc, given);
  if (!cache)
    return refuse("the binary log does not list its sensors itself; their list is the file " +
                  header.cache_crc +
                  ".cac, which the glider keeps in state/cache; give it together with the log");
  const std::string text = first_bytes(*cache, most_cache_bytes);
  std::size_t at = 0;
  return sensors_in(text, at, static_cast<int>(std::ranges::count(text, '\n')), header.sensors);
}

template <class Number, class Bits>
double number_at(const char* bytes, bool swapped) {
  Bits bits{};
  std::memcpy(&bits, bytes, sizeof(bits));
  if (swapped) {
    Bits turned{};
    for (std::size_t i = 0; i < sizeof(Bits); ++i)
      turned = static_cast<Bits>((turned << 8) | ((bits >> (8 * i)) & 0xff));
    bits = turned;
  }
  return static_cast<double>(std::bit_cast<Number>(bits));
}

double value_at(const char* bytes, std::size_t size, bool swapped) {
  switch (size) {
    case 1: return static_cast<double>(static_cast<signed char>(*bytes));
    case 2: return number_at<std::int16_t, std::uint16_t>(bytes, swapped);
    case 4: return number_at<float, std::uint32_t>(bytes, swapped);
    default: return number_at<double, std::uint64_t>(bytes, swapped);
  }
}

/// Whether the bytes of numbers stand in the other order than this machine's; empty: the known bytes are not there.
std::optional<bool> order_of(std::string_view bytes, std::size_t& at) {
  constexpr std::size_t known = 16;
  if (bytes.size() < at + known || bytes.substr(at, 2) != "sa") return std::nullopt;
  const char* const numbers = bytes.data() + at + 2;
  at += known;
  for (const bool swapped : {false, true}) {
    if (value_at(numbers, 2, swapped) == 0x1234 &&
        std::abs(value_at(numbers + 2, 4, swapped) - 123.456) < 1e-4 &&
        std::abs(value_at(numbers + 6, 8, swapped) - 123456789.12345) < 1e-4)
      return swapped;
  }
  return std::nullopt;
}

/// Takes the cycles apart.
class Cycles {
 public:
  Cycles(std::string_view bytes, std::size_t at, std::vector<LoggedSensor> sensors, bool swapped)
      : bytes_{bytes}, at_{at}, sensors_{std::move(sensors)}, swapped_{swapped} {}

  /// Moves `row` on to the next cycle. False: there is none that is whole.
  bool next(SlocumRow& row) {
    const std::size_t state_bytes = (sensors_.size() + 3) / 4;
    const std::size_t states = at_ + 1;
    if (at_ >= bytes_.size() || bytes_[at_] != 'd' || states + state_bytes > bytes_.size()) return false;
    std::size_t value = states + state_bytes;
    row = {};
    for (std::size_t i = 0; i < sensors_.size(); ++i) {
      const auto packed = static_cast<unsigned char>(bytes_[states + i / 4]);
      const unsigned state = (packed >> (6 - 2 * (i % 4))) & 3U;
      const LoggedSensor& sensor = sensors_[i];
      if (state == 2) {
        if (value + sensor.bytes > bytes_.size()) return false;
        if (sensor.wanted) note(*sensor.wanted, value_at(bytes_.data() + value, sensor.bytes, swapped_));
        value += sensor.bytes;
      }
      if (sensor.wanted && state != 0) row.values.at(*sensor.wanted) = last_.values.at(*sensor.wanted);
    }
    at_ = value;
    return true;
  }

  [[nodiscard]] bool is_at_end() const { return at_ < bytes_.size() && bytes_[at_] == 'X'; }
  [[nodiscard]] bool was_cut() const { return at_ >= bytes_.size() || bytes_[at_] == 'd'; }

 private:
  void note(std::size_t sensor, double value) {
    last_.values.at(sensor) = std::isfinite(value) ? std::optional{value} : std::nullopt;
  }

  std::string_view bytes_;
  std::size_t at_;
  std::vector<LoggedSensor> sensors_;
  bool swapped_;
  SlocumRow last_;
};

std::string head_of(const std::filesystem::path& file) { return first_bytes(file, 16'384); }

}  // namespace

bool is_slocum_binary(std::string_view head) {
  const std::string_view first = head.substr(0, head.find('\n'));
  return first.starts_with("dbd_label:") && first.find("DBD_ASC") == std::string_view::npos;
}

bool holds_slocum_binary(const std::filesystem::path& file) { return is_slocum_binary(head_of(file)); }

bool is_compressed_slocum(std::string_view head) {
  constexpr std::size_t longest_lead =
      8;  // the length of the block, and that of its first run of plain bytes
  const std::size_t lead = std::min(head.substr(0, 32).find("dbd_label:"), head.substr(0, 32).find("s: T"));
  return lead >= 3 && lead <= longest_lead;
}

bool is_sensor_cache(std::string_view head) { return head.starts_with("s: T") || head.starts_with("s: F"); }

bool holds_sensor_cache(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored) && is_sensor_cache(head_of(file));
}

bool is_cache_of(const std::filesystem::path& cache, const std::filesystem::path& log) {
  const std::string head = head_of(log);
  const auto header = is_slocum_binary(head) ? header_of(head) : refuse("");
  return header && header->listed == 0 && lower(cache.filename().string()) == header->cache_crc + ".cac";
}

FileGroup without_sensor_caches(const FileGroup& files) {
  FileGroup logs;
  std::ranges::copy_if(files, std::back_inserter(logs),
                       [](const std::filesystem::path& file) { return !holds_sensor_cache(file); });
  return logs;
}

Checked<SlocumLog> read_slocum_binary(const std::filesystem::path& file, const FileGroup& given,
                                      const std::function<void(const SlocumRow&)>& take) {
  if (std::filesystem::file_size(file) > most_bytes)
    return refuse(
        "the binary log is longer than 200 MB; no glider writes such; give the segments one by one");
  const std::string bytes = first_bytes(file, most_bytes);
  auto header = header_of(bytes);
  if (!header) return refuse(header.error());
  const auto sensors = sensors_of(file, bytes, *header, given);
  if (!sensors) return refuse(sensors.error());
  const auto swapped = order_of(bytes, header->size);
  if (!swapped) return refuse(without_end("the bytes by which the order of bytes is told are not there"));

  SlocumLog log{.name = slocum_name_of(file)};
  for (const LoggedSensor& sensor : *sensors)
    if (sensor.wanted) log.has.at(*sensor.wanted) = true;
  Cycles cycles{bytes, header->size, *sensors, *swapped};
  std::size_t count = 0;
  for (SlocumRow row; cycles.next(row); ++count) take(row);
  if (cycles.is_at_end()) return log;
  if (!cycles.was_cut())
    return refuse(without_end("what follows " + std::to_string(count) + " cycles is no cycle"));
  log.rows_refused = 1;
  log.warning =
      "the log ends before its end mark; what is whole was read; if it was cut short, copy it again";
  return log;
}

}  // namespace floeplan::ingest
