#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "api/codec/route_files/route_formats.hpp"
#include "engine/mission/document/line_words.hpp"

namespace floeplan::codec {
namespace {

constexpr std::size_t most_faults = 20;
constexpr std::size_t check_sum_length = 3;  // '*' and two digits

using Fields = std::vector<std::string_view>;

Fields fields_of(std::string_view body) {
  Fields fields;
  while (true) {
    const std::size_t end = body.find(',');
    fields.push_back(body.substr(0, end));
    if (end == std::string_view::npos) return fields;
    body.remove_prefix(end + 1);
  }
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return -1;
}

/// Whether the check sum is right, or absent.
bool sums_up(std::string_view body, std::string_view sum) {
  if (sum.empty()) return true;
  if (sum.size() != check_sum_length) return false;
  int expected = 0;
  for (const char c : body) expected ^= static_cast<std::uint8_t>(c);
  return hex_digit(sum[1]) * 16 + hex_digit(sum[2]) == expected && hex_digit(sum[1]) >= 0 &&
         hex_digit(sum[2]) >= 0;
}

/// Degrees of an angle such as "05312.0000" with its hemisphere; nullopt if it is invalid or greater than
/// `most_deg`.
std::optional<double> angle_of(std::string_view text, std::string_view side, std::size_t degree_digits,
                               char positive, char negative, double most_deg) {
  if (text.size() < degree_digits + 2 || side.size() != 1) return std::nullopt;
  if (side[0] != positive && side[0] != negative) return std::nullopt;
  const bool plain = text.find_first_not_of("0123456789.") == std::string_view::npos;
  const auto degrees = mission::parse_number(text.substr(0, degree_digits));
  const auto minutes = mission::parse_number(text.substr(degree_digits));
  if (!plain || !degrees || !minutes || *minutes >= 60.0) return std::nullopt;
  const double angle = *degrees + *minutes / 60.0;
  if (angle > most_deg) return std::nullopt;
  return side[0] == negative ? -angle : angle;
}

/// A route as listed in RTE sentences, which loggers repeat.
struct Listing {
  std::string name;
  std::vector<std::string> order;
  int sentences{};  // number of sentences of the route
  int read{};

  friend bool operator==(const Listing&, const Listing&) = default;
};

std::optional<int> count_of(std::string_view text) {
  const auto number = mission::parse_number(text);
  if (!number || *number < 1.0 || *number > 999.0 || *number != std::floor(*number)) return std::nullopt;
  return static_cast<int>(*number);
}

/// The content of the sentences read so far.
struct Sentences {
  std::vector<std::string> order_of_waypoints;
  std::map<std::string, geo::LonLat> waypoints;
  std::vector<Listing> listings;
  messages::Faults faults;

  void read_waypoint(const Fields& fields, int line) {
    if (fields.size() < 6 || fields[5].empty())
      return faults.refuse<"wrong-shape">(at_line(line), "WPL,latitude,N or S,longitude,E or W,name");
    const auto lat = angle_of(fields[1], fields[2], 2, 'N', 'S', 90.0);
    const auto lon = angle_of(fields[3], fields[4], 3, 'E', 'W', 180.0);
    if (!lat || !lon) return faults.refuse<"no-minutes-in-line">(at_line(line));
    const std::string name{fields[5]};
    const auto [known, is_new] = waypoints.try_emplace(name, *lon, *lat);
    if (is_new) order_of_waypoints.push_back(name);
    if (!is_new && known->second != geo::LonLat{*lon, *lat})
      faults.refuse<"waypoint-in-two-places">(at_line(line), name);
  }

  void read_route(const Fields& fields, int line) {
    const auto sentences = fields.size() < 5 ? std::nullopt : count_of(fields[1]);
    const auto number = fields.size() < 5 ? std::nullopt : count_of(fields[2]);
    if (!sentences || !number || *number > *sentences)
      return faults.refuse<"wrong-shape">(at_line(line), "RTE,sentences,number,c or w,name,waypoints");
    const std::string name{fields[4]};
    if (*number == 1) listings.push_back({name, {}, *sentences, 0});
    if (listings.empty() || listings.back().name != name || listings.back().sentences != *sentences ||
        listings.back().read != *number - 1)
      return faults.refuse<"sentence-before-missing">(at_line(line), *number);
    ++listings.back().read;
    for (std::size_t i = 5; i < fields.size(); ++i) {
      if (!fields[i].empty()) listings.back().order.emplace_back(fields[i]);
    }
  }

  void read(std::string_view line, int number) {
    const std::size_t star = line.find('*');
    const std::string_view body = line.substr(1, star == std::string_view::npos ? star : star - 1);
    const Fields fields = fields_of(body);
    const bool is_waypoint = fields[0].ends_with("WPL");
    if (!is_waypoint && !fields[0].ends_with("RTE"))
      return;  // other sentences of a logger, such as fixes and depths
    if (!sums_up(body, star == std::string_view::npos ? "" : line.substr(star)))
      return faults.refuse<"wrong-check-sum">(at_line(number));
    if (is_waypoint) {
      read_waypoint(fields, number);
    } else {
      read_route(fields, number);
    }
  }
};

std::vector<geo::LonLat> places_in_order(const Sentences& sentences, const std::vector<std::string>& order,
                                         core::Violations& faults) {
  std::vector<geo::LonLat> places;
  for (const std::string& name : order) {
    const auto found = sentences.waypoints.find(name);
    if (found != sentences.waypoints.end()) {
      places.push_back(found->second);
    } else if (faults.size() < most_faults) {
      faults.push_back(messages::fault<"waypoint-without-place">("file", name));
    }
  }
  return places;
}

/// The routes of the file; a repeated route is taken once. If no RTE sentence lists a waypoint: one route of
/// all waypoints, in the order of the file.
ReadRoutes routes_of(const Sentences& sentences) {
  FileRoutes file;
  core::Violations faults;
  std::vector<Listing> known;
  for (const Listing& listing : sentences.listings) {
    if (listing.read < listing.sentences)
      faults.push_back(
          messages::fault<"sentence-missing">("file", listing.read + 1, listing.sentences, listing.name));
    if (listing.order.empty() || std::ranges::find(known, listing) != known.end()) continue;
    known.push_back(listing);
    file.routes.push_back({listing.name, {places_in_order(sentences, listing.order, faults)}});
  }
  if (file.routes.empty() && !sentences.order_of_waypoints.empty())
    file.routes.push_back({"", {places_in_order(sentences, sentences.order_of_waypoints, faults)}});
  if (!faults.empty()) return tl::unexpected(std::move(faults));
  if (file.routes.empty()) return route_fault<"holds-no">("file", "WPL sentence with a waypoint");
  return file;
}

}  // namespace

ReadRoutes read_nmea(std::string_view bytes) {
  Sentences sentences;
  int number = 0;
  while (!bytes.empty() && sentences.faults.found().size() < most_faults) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size() - 1);
    std::string_view line = bytes.substr(0, end + 1);
    bytes.remove_prefix(end + 1);
    ++number;
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r' || line.back() == ' '))
      line.remove_suffix(1);
    if (line.starts_with('$')) sentences.read(line, number);
  }
  if (!sentences.faults.found().empty()) return tl::unexpected(sentences.faults.found());
  return routes_of(sentences);
}

}  // namespace floeplan::codec
