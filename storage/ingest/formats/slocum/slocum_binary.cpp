#include "storage/ingest/formats/slocum/slocum_binary.hpp"

#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include "engine/core/shown_text.hpp"
#include "engine/messages/ingest_track_messages.hpp"
#include "storage/ingest/formats/slocum/slocum_bytes.hpp"
#include "storage/ingest/formats/slocum/slocum_header.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::uintmax_t most_binary_bytes = 200'000'000;

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

/// Whether the byte order of numbers differs from this machine's; empty if the known bytes are missing.
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

/// Decodes the cycles of a log one after the other.
class Cycles {
 public:
  Cycles(std::string_view bytes, std::size_t at, std::vector<LoggedSensor> sensors, bool swapped)
      : bytes_{bytes}, at_{at}, sensors_{std::move(sensors)}, swapped_{swapped} {}

  /// Reads the next cycle into `row`. False if no complete cycle is left.
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

}  // namespace

Checked<SlocumLog> read_slocum_binary(const std::filesystem::path& file, const FileGroup& given,
                                      const std::function<void(const SlocumRow&)>& take) {
  if (std::filesystem::file_size(file) > most_binary_bytes)
    return refuse(messages::ingest_track_message<"binary-log-too-long">());
  const auto [bytes, damaged] = slocum_bytes(file, most_binary_bytes + 1);
  if (bytes.size() > most_binary_bytes)
    return refuse(messages::ingest_track_message<"binary-log-unpacks-to-too-much">());
  if (damaged)
    return refuse(
        messages::ingest_track_message<"binary-log-damaged">("a compressed block of it cannot be unpacked"));
  auto header = slocum_header_of(file, bytes, given);
  if (!header) return refuse(header.error());
  std::size_t at = header->size;
  const auto swapped = order_of(bytes, at);
  if (!swapped)
    return refuse(messages::ingest_track_message<"binary-log-damaged">(
        "the bytes that tell the order of bytes are missing"));

  SlocumLog log{.name = slocum_name_of(file)};
  for (const LoggedSensor& sensor : header->sensors)
    if (sensor.wanted) log.has.at(*sensor.wanted) = true;
  Cycles cycles{bytes, at, std::move(header->sensors), *swapped};
  std::size_t count = 0;
  for (SlocumRow row; cycles.next(row); ++count) take(row);
  if (cycles.is_at_end()) return log;
  if (!cycles.was_cut())
    return refuse(messages::ingest_track_message<"binary-log-damaged">(
        "what follows " + core::counted(count, "cycle") + " is no cycle"));
  log.rows_refused = 1;
  log.warnings.push_back(messages::ingest_track_message<"binary-log-without-end">());
  return log;
}

}  // namespace floeplan::ingest
