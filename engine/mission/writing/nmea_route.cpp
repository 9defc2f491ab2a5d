#include "engine/mission/writing/nmea_route.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <vector>

namespace floeplan::mission {
namespace {

constexpr std::size_t longest_sentence = 82;
constexpr std::size_t around_body = 6;  // $, *, two digits, CR, LF

std::string sentence(const std::string& body) {
  std::uint8_t sum = 0;
  for (const char c : body) sum ^= static_cast<std::uint8_t>(c);
  std::array<char, 8> ending{};
  std::snprintf(ending.data(), ending.size(), "*%02X\r\n", static_cast<unsigned>(sum));
  return "$" + body + ending.data();
}

/// Text such as "6912.3456,N". Rounded once, so that minutes never read 60.
std::string angle(double degrees, int degree_digits, char positive, char negative) {
  constexpr long long per_degree = 600'000;
  const long long units = std::llround(std::abs(degrees) * per_degree);
  const long long minutes = units % per_degree;
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%0*lld%02lld.%04lld,%c", degree_digits, units / per_degree,
                minutes / 10'000, minutes % 10'000, degrees < 0.0 && units > 0 ? negative : positive);
  return text.data();
}

/// Name of a waypoint, as on the map and in all other formats: S for the start, then 1, 2, ...
std::string name_of(std::size_t index) { return index == 0 ? "S" : std::to_string(index); }

/// Letters and digits of the plan's id; other characters could end a field.
std::string route_name(const std::string& plan_id) {
  std::string name;
  for (const char c : plan_id) {
    const bool kept = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (kept && name.size() < 13) name += c;
  }
  return name;
}

}  // namespace

MissionFile write_nmea_route(const planning::Plan& plan, const std::string& plan_id) {
  if (plan.waypoints.size() > most_nmea_waypoints)
    throw std::invalid_argument{"write_nmea_route: more than 999 waypoints"};
  std::string text;
  for (std::size_t i = 0; i < plan.waypoints.size(); ++i) {
    const geo::LonLat place = plan.waypoints[i].place;
    text += sentence("GPWPL," + angle(place.lat_deg, 2, 'N', 'S') + "," +
                     angle(geo::wrap_longitude(place.lon_deg), 3, 'E', 'W') + "," + name_of(i));
  }
  const std::string route = route_name(plan_id);
  constexpr std::size_t longest_head = 16 + 13;  // "GPRTE,nnn,nnn,c," and the name
  constexpr std::size_t longest_name = 1 + 3;    // a comma and three digits
  constexpr std::size_t per_sentence = (longest_sentence - around_body - longest_head) / longest_name;
  const std::size_t total = (plan.waypoints.size() + per_sentence - 1) / per_sentence;
  for (std::size_t part = 0; part < total; ++part) {
    std::string body = "GPRTE," + std::to_string(total) + "," + std::to_string(part + 1) + ",c," + route;
    for (std::size_t i = part * per_sentence; i < std::min((part + 1) * per_sentence, plan.waypoints.size());
         ++i)
      body += "," + name_of(i);
    text += sentence(body);
  }
  return {"route.nmea", text};
}

}  // namespace floeplan::mission
