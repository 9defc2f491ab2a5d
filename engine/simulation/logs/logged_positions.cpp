#include "engine/simulation/logs/logged_positions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/core/letter_case.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/messages/flight_fault_messages.hpp"
#include "engine/messages/flight_messages.hpp"
#include "engine/mission/document/packed_degrees.hpp"

namespace floeplan::simulation {
namespace {

enum class Notation { packed, decimal };

constexpr double most_packed_lat = 9'000.0;
constexpr double most_packed_lon = 18'000.0;
constexpr double rounded_minutes = 60.001;  // 60.0000 may be written for 59.99996
constexpr double rare = 0.01;               // of a pair's values: a smaller share may be damaged data
constexpr double clearly_nearer = 0.1;
/// In the two readings distances differ by a factor of 60, so this share separates them, with room for
/// currents.
constexpr double least_share = 0.3;
constexpr double most_share = 3.0;
constexpr double least_way_m = 200.0;
constexpr double least_speed_m_s = 0.1;     // of a gliding glider
constexpr double fastest_m_s = 10.0;        // no glider is faster
constexpr double least_wait_s = 600.0;      // between the places whose speed is computed
constexpr double longest_step_s = 900.0;    // of dead reckoning, from row to row
constexpr double longest_step_m = 1'000.0;  // longer steps: a new mission with another origin of its metres

struct Pair {
  const char* lat_name;
  const char* lon_name;
};
constexpr auto pairs =
    std::to_array<Pair>({{"m_gps_lat", "m_gps_lon"}, {"m_lat", "m_lon"}, {"c_wpt_lat", "c_wpt_lon"}});
constexpr std::size_t fixes = 0;
constexpr std::size_t reckoned = 1;

bool lists(const LogTable& log, const Pair& pair) { return log.has(pair.lat_name) && log.has(pair.lon_name); }

std::optional<geo::LonLat> place_in(Notation notation, double lon, double lat) {
  if (notation == Notation::packed) return mission::unpack_place(lon, lat);
  const geo::LonLat place{lon, lat};
  return geo::is_valid(place) ? std::optional{place} : std::nullopt;
}

double packed(double degrees) {
  const double size = std::abs(degrees);
  const double whole = std::floor(size);
  return std::copysign(100.0 * whole + 60.0 * (size - whole), degrees);
}

/// The notation in the unit above a column; empty: the vehicle's own unit, or none.
std::optional<Notation> notation_of_unit(const std::string& unit) {
  const std::string word = core::plain_word(unit);
  if (word.starts_with("ddmm") || word.starts_with("dddmm") || word == "nmea") return Notation::packed;
  const bool says_degrees =
      word.starts_with("deg") || word.starts_with("decimaldeg") || word == "dd" || unit == "°";
  return says_degrees ? std::optional{Notation::decimal} : std::nullopt;
}

/// Counts of values that are possible in only one notation.
struct Proofs {
  std::size_t values{};
  std::size_t packed{};
  std::size_t decimal{};
  double packed_value{};  // the first packed one
  double decimal_value{};

  void add(double value, double most_degrees, double most_packed) {
    const double size = std::abs(value);
    if (value == 0.0 || size > most_packed) return;  // not a position
    ++values;
    if (size > most_degrees) {
      if (packed++ == 0) packed_value = value;
    } else if (std::fmod(size, 100.0) > rounded_minutes) {
      if (decimal++ == 0) decimal_value = value;
    }
  }
  /// Whether this many values are too many to be damaged data.
  [[nodiscard]] bool has(std::size_t count) const {
    return count > 0 && static_cast<double>(count) >= rare * static_cast<double>(values);
  }
};

Proofs proofs_of(const LogTable& log, const Pair& pair) {
  Proofs proofs;
  for (const auto& lat : log[pair.lat_name])
    if (lat) proofs.add(*lat, 90.0, most_packed_lat);
  for (const auto& lon : log[pair.lon_name])
    if (lon) proofs.add(*lon, 180.0, most_packed_lon);
  return proofs;
}

std::string angle_words(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  return text.ends_with('.') ? text + "0" : text;
}

template <messages::Code code, class... Given>
core::Violation contradiction(const Pair& pair, const Given&... values) {
  return messages::flight_fault<code>(std::string{"/"} + pair.lat_name, pair.lon_name, values...);
}

/// Distances between the rows of a pair of position sensors: in both readings, and by other sensors.
struct Ways {
  double packed_m{};
  double decimal_m{};
  double told_m{};

  /// The only reading whose distances are near those by other sensors; empty: none or both.
  [[nodiscard]] std::optional<Notation> fitting() const {
    if (told_m < least_way_m) return std::nullopt;
    const auto fits = [&](double way_m) {
      return way_m > least_share * told_m && way_m < most_share * told_m;
    };
    if (fits(packed_m) == fits(decimal_m)) return std::nullopt;
    return fits(packed_m) ? Notation::packed : Notation::decimal;
  }
};

/// A position of a log, read in each of the two notations.
struct Read {
  std::size_t row{};
  std::optional<double> seconds;
  std::array<std::optional<geo::LonLat>, 2> places;
};

std::optional<double> value_at(const LogTable& log, const char* name, std::size_t row) {
  return log.has(name) ? log[name][row] : std::nullopt;
}

std::vector<Read> reads_of(const LogTable& log, const Pair& pair) {
  std::vector<Read> reads;
  for (std::size_t row = 0; row < log.rows(); ++row) {
    const auto lon = log[pair.lon_name][row];
    const auto lat = log[pair.lat_name][row];
    if (!lon || !lat || (*lon == 0.0 && *lat == 0.0)) continue;
    Read read{row, value_at(log, "m_present_time", row), {}};
    for (const Notation notation : {Notation::packed, Notation::decimal})
      read.places.at(static_cast<std::size_t>(notation)) = place_in(notation, *lon, *lat);
    if (read.places[0] || read.places[1]) reads.push_back(read);
  }
  return reads;
}

double apart_m(const std::optional<geo::LonLat>& one, const std::optional<geo::LonLat>& other) {
  return one && other ? geo::geodesic_between(*one, *other).length.value : 0.0;
}

void add_way(Ways& ways, const Read& from, const Read& to, double told_m) {
  ways.packed_m += apart_m(from.places[0], to.places[0]);
  ways.decimal_m += apart_m(from.places[1], to.places[1]);
  ways.told_m += told_m;
}

/// Compares with the vehicle's own metres, in which its dead reckoning is also logged.
std::optional<Notation> by_local_metres(const LogTable& log, const std::vector<Read>& reads) {
  Ways ways;
  const Read* last = nullptr;
  for (const Read& read : reads) {
    const auto x = value_at(log, "m_x_lmc", read.row);
    const auto y = value_at(log, "m_y_lmc", read.row);
    if (!x || !y) continue;
    if (last != nullptr) {
      const double told_m =
          std::hypot(*x - *value_at(log, "m_x_lmc", last->row), *y - *value_at(log, "m_y_lmc", last->row));
      if (told_m < longest_step_m) add_way(ways, *last, read, told_m);
    }
    last = &read;
  }
  return ways.fitting();
}

/// Compares with the speed through the water times the time.
std::optional<Notation> by_speed(const LogTable& log, const std::vector<Read>& reads) {
  if (!log.has("m_speed")) return std::nullopt;
  Ways ways;
  for (std::size_t i = 1; i < reads.size(); ++i) {
    const Read& from = reads[i - 1];
    const Read& to = reads[i];
    const auto speed_m_s = log.before("m_speed", to.row);
    if (!from.seconds || !to.seconds || !speed_m_s || *speed_m_s < least_speed_m_s) continue;
    const double wait_s = *to.seconds - *from.seconds;
    if (wait_s > 0.0 && wait_s < longest_step_s) add_way(ways, from, to, *speed_m_s * wait_s);
  }
  return ways.fitting();
}

/// Excludes decimal degrees if the vehicle would always be faster than any glider.
std::optional<Notation> by_fastest(const std::vector<Read>& reads) {
  std::vector<double> speeds_m_s;
  const Read* last = nullptr;
  for (const Read& read : reads) {
    if (!read.seconds || !read.places[1]) continue;
    if (last == nullptr) last = &read;
    const double wait_s = *read.seconds - *last->seconds;
    if (wait_s < least_wait_s) continue;
    speeds_m_s.push_back(apart_m(last->places[1], read.places[1]) / wait_s);
    last = &read;
  }
  if (speeds_m_s.size() < 3) return std::nullopt;
  const auto middle = speeds_m_s.begin() + static_cast<std::ptrdiff_t>(speeds_m_s.size() / 2);
  std::ranges::nth_element(speeds_m_s, middle);
  return *middle > fastest_m_s ? std::optional{Notation::packed} : std::nullopt;
}

std::optional<Notation> by_zone(const LogTable& log, const std::vector<Read>& reads) {
  for (const Read& read : reads) {
    const auto zone =
        log.has("x_lmc_utm_zone_digit") ? log.before("x_lmc_utm_zone_digit", read.row) : std::nullopt;
    if (!zone || !read.places[0] || !read.places[1]) continue;
    const auto is_in = [&](geo::LonLat place) {
      return std::floor((place.lon_deg + 180.0) / 6.0) + 1.0 == *zone;
    };
    const bool is_packed = is_in(*read.places[0]);
    if (is_packed != is_in(*read.places[1])) return is_packed ? Notation::packed : Notation::decimal;
  }
  return std::nullopt;
}

/// The reading that is ten times nearer to known places.
std::optional<Notation> by_nearness(const std::vector<Read>& reads, const std::vector<Read>& others,
                                    Notation notation_of_others) {
  double packed_m = 0.0;
  double decimal_m = 0.0;
  auto other = others.begin();
  for (const Read& read : reads) {
    while (other != others.end() && std::next(other) != others.end() && std::next(other)->row <= read.row)
      ++other;
    if (other == others.end()) return std::nullopt;
    const auto& place = other->places.at(static_cast<std::size_t>(notation_of_others));
    if (!place || !read.places[0] || !read.places[1]) continue;
    packed_m += apart_m(place, read.places[0]);
    decimal_m += apart_m(place, read.places[1]);
  }
  if (packed_m < clearly_nearer * decimal_m) return Notation::packed;
  if (decimal_m < clearly_nearer * packed_m) return Notation::decimal;
  return std::nullopt;
}

/// Decides the notation of each pair of position sensors of one log.
class Settling {
 public:
  explicit Settling(LogTable& log) : log_{log} {}

  tl::expected<std::optional<std::string>, core::Violation> settle() {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (!lists(log_, pairs.at(i))) continue;
      if (auto fault = read_pair(i)) return tl::unexpected(std::move(*fault));
    }
    const bool any_is_settled =
        std::ranges::any_of(notations_, [](const auto& known) { return known.has_value(); });
    for (const std::size_t i : {reckoned, fixes})
      if (!any_is_settled && is_open(i)) settle_by_ways(i);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (is_open(i)) settle_by_another(i);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (is_open(i)) return tl::unexpected(undecided(i));
      if (notations_.at(i) == Notation::decimal) pack(pairs.at(i));
    }
    return told();
  }

 private:
  [[nodiscard]] bool is_open(std::size_t i) const { return has_places_.at(i) && !notations_.at(i); }

  /// The positions of a pair, read at the first call: most logs do not need them.
  const std::vector<Read>& reads(std::size_t i) {
    if (reads_.at(i).empty()) reads_.at(i) = reads_of(log_, pairs.at(i));
    return reads_.at(i);
  }

  std::optional<core::Violation> read_pair(std::size_t i) {
    const Pair& pair = pairs.at(i);
    const Proofs proofs = proofs_of(log_, pair);
    const auto of_lat = notation_of_unit(log_.unit(pair.lat_name));
    const auto of_lon = notation_of_unit(log_.unit(pair.lon_name));
    has_places_.at(i) = proofs.values > 0;
    if (of_lat && of_lon && *of_lat != *of_lon) return contradiction<"units-of-positions-differ">(pair);
    if (const auto stated = of_lat ? of_lat : of_lon) {
      const bool is_decimal = *stated == Notation::decimal;
      notations_.at(i) = *stated;
      if (proofs.has(is_decimal ? proofs.packed : proofs.decimal))
        return is_decimal
                   ? contradiction<"positions-not-in-degrees">(pair, angle_words(proofs.packed_value))
                   : contradiction<"positions-not-in-minutes">(pair, angle_words(proofs.decimal_value));
      return std::nullopt;
    }
    const bool is_packed = proofs.has(proofs.packed);
    const bool is_decimal = proofs.has(proofs.decimal);
    if (is_packed && is_decimal)
      return contradiction<"positions-of-two-notations">(pair, angle_words(proofs.packed_value),
                                                         angle_words(proofs.decimal_value));
    if (is_packed) notations_.at(i) = Notation::packed;
    if (is_decimal) take_for_decimal(i, "their minutes would be 60 and more");
    return std::nullopt;
  }

  void take_for_decimal(std::size_t i, const std::string& reason) {
    notations_.at(i) = Notation::decimal;
    if (reason_.empty()) reason_ = reason;
    taken_ += (taken_.empty() ? "" : ", ") + std::string{pairs.at(i).lat_name} + ", " + pairs.at(i).lon_name;
  }

  void settle_by_another(std::size_t i) {
    for (std::size_t other = 0; other < pairs.size(); ++other) {
      if (!notations_.at(other) || !has_places_.at(other) || other == i) continue;
      const auto near = by_nearness(reads(i), reads(other), *notations_.at(other));
      const Notation found = near.value_or(*notations_.at(other));
      if (found == Notation::packed)
        notations_.at(i) = found;
      else
        take_for_decimal(i, "they then lie where " + std::string{pairs.at(other).lat_name} + " does");
      return;
    }
  }

  void settle_by_ways(std::size_t i) {
    std::optional<Notation> found;
    std::string reason = "the ways between them are then those of m_x_lmc and m_y_lmc";
    if (i == reckoned) found = by_local_metres(log_, reads(i));
    if (!found && (found = by_zone(log_, reads(i))))
      reason = "they then lie in the zone x_lmc_utm_zone_digit";
    if (!found && i == reckoned && (found = by_speed(log_, reads(i))))
      reason = "the ways between them then fit m_speed";
    if (!found) found = by_fastest(reads(i));
    if (found == Notation::packed) notations_.at(i) = found;
    if (found == Notation::decimal) take_for_decimal(i, reason);
  }

  [[nodiscard]] core::Violation undecided(std::size_t i) {
    const Read& first = reads(i).front();
    const auto words = [](const std::optional<geo::LonLat>& place) {
      return place ? angle_words(place->lat_deg) + " N " + angle_words(place->lon_deg) + " E"
                   : std::string{"no place"};
    };
    return contradiction<"positions-undecided">(pairs.at(i), words(first.places[0]), words(first.places[1]));
  }

  [[nodiscard]] std::optional<std::string> told() const {
    if (taken_.empty()) return std::nullopt;
    return messages::flight_text<"positions-taken-for-decimal">(taken_, reason_);
  }

  void pack(const Pair& pair) {
    const auto packed_or_none = [](double most_degrees) {
      return [most_degrees](double degrees) {
        return std::abs(degrees) <= most_degrees ? std::optional{packed(degrees)} : std::nullopt;
      };
    };
    log_.change(pair.lat_name, packed_or_none(90.0));
    log_.change(pair.lon_name, packed_or_none(180.0));
  }

  LogTable& log_;  // borrowed
  std::array<bool, pairs.size()> has_places_{};
  std::array<std::vector<Read>, pairs.size()> reads_;
  std::array<std::optional<Notation>, pairs.size()> notations_;
  std::string taken_;
  std::string reason_;
};

}  // namespace

std::vector<std::string_view> columns_that_tell_of_positions() {
  return {"m_lat",   "m_lon",   "m_gps_lat", "m_gps_lon",      "c_wpt_lat",           "c_wpt_lon",
          "m_x_lmc", "m_y_lmc", "m_speed",   "m_present_time", "x_lmc_utm_zone_digit"};
}

tl::expected<std::optional<std::string>, core::Violation> settle_positions(LogTable& log) {
  return Settling{log}.settle();
}

}  // namespace floeplan::simulation
