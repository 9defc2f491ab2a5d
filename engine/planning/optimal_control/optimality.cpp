#include "engine/planning/optimal_control/optimality.hpp"

#include <algorithm>
#include <cstdint>

#include "engine/planning/currents/current_drive.hpp"
#include "engine/planning/optimal_control/free_way.hpp"

namespace floeplan::planning::optimal_control {
namespace {

constexpr double tolerance =
    1e-6;  // of a leg's time: small, because the descent compares routes of nearly equal duration
/// Largest number of timed legs for all sections together; about two seconds. A count gives the same result on every
/// machine; a clock would not.
constexpr std::int64_t most_evaluations = 1'000'000;

constexpr const char* took_too_long = "the search for the best possible route took too long";
constexpr const char* would_be_closed =
    "obstacles shape the route: without them the fastest route would lead ";

std::string describe(motion::EdgeClosed closed) {
  const std::string without = would_be_closed;
  switch (closed) {
    case motion::EdgeClosed::on_land: return without + "over land";
    case motion::EdgeClosed::too_shallow: return without + "through water that is too shallow";
    case motion::EdgeClosed::obstacle: return without + "through the keep-out distance of an iceberg";
    case motion::EdgeClosed::in_zone: return without + "through a zone against its rule";
    case motion::EdgeClosed::current_too_strong:
      return "the fastest route would meet currents that are too strong";
    case motion::EdgeClosed::under_ice: return without + "below ice that leaves no room for the vehicle";
    case motion::EdgeClosed::no_surfacing: return without + "too long past places without surfacing";
    case motion::EdgeClosed::outside_data:
    case motion::EdgeClosed::too_late: break;
  }
  return "the fastest route would leave the area or the period of the data";
}

std::string describe(NoFreeWay none) {
  switch (none) {
    case NoFreeWay::closed:
      return "the fastest route would leave the data, or meet currents that are too strong";
    case NoFreeWay::not_settled: return "the search for the best possible route did not converge";
    case NoFreeWay::cancelled: break;
  }
  return "cancelled";
}

/// Times legs in the currents alone, without obstacles, and counts them.
class OpenWater {
 public:
  explicit OpenWater(const cost::Sea& sea)
      : sea_{sea}, accuracy_{currents::drive_accuracy(sea.domain().currents(), tolerance)} {}

  [[nodiscard]] bool is_exhausted() const { return evaluations_ >= most_evaluations; }

  [[nodiscard]] LegTimer timer() {
    return [this](geo::PlanePoint from, geo::PlanePoint to,
                  core::Seconds depart) -> std::optional<core::Seconds> {
      if (is_exhausted()) return std::nullopt;
      ++evaluations_;
      const motion::PlaneEdge edge{from, to, sea_.domain().lengths().between(from, to)};
      const auto time =
          currents::drive_time(sea_.domain().currents(), edge, depart, sea_.through_water(), accuracy_);
      return time ? std::optional{*time} : std::nullopt;
    };
  }

 private:
  const cost::Sea& sea_;
  motion::EdgeAccuracy accuracy_;
  std::int64_t evaluations_{};
};

/// The parts of the route between fixed points.
std::vector<std::vector<geo::PlanePoint>> sections_of(const cost::Route& route) {
  std::vector<std::vector<geo::PlanePoint>> sections;
  for (std::size_t i = 0; i < route.points.size(); ++i) {
    if (!sections.empty()) sections.back().push_back(route.points[i]);
    if (route.fixed[i] && i + 1 < route.points.size()) sections.push_back({route.points[i]});
  }
  return sections;
}

/// The fastest routes near the section's own points and near the straight line, with the number of legs of a first
/// search; the fastest is the first.
tl::expected<std::vector<TimedWay>, NoFreeWay> coarse_ways(const std::vector<geo::PlanePoint>& section,
                                                           core::Seconds depart, const LegTimer& timer,
                                                           const std::stop_token& stop) {
  std::vector<std::vector<geo::PlanePoint>> starts{section};
  if (section.size() > 2) starts.push_back({section.front(), section.back()});
  std::vector<TimedWay> roughs;
  for (const auto& points : starts) {
    const auto start = time_way(points, depart, timer);
    if (!start) continue;
    TimedWay rough = find_rough_free_way(*start, timer, stop);
    const bool is_known =
        std::ranges::any_of(roughs, [&](const TimedWay& other) { return lead_to_one_way(other, rough); });
    if (!is_known) roughs.push_back(std::move(rough));
  }
  std::vector<TimedWay> ways;
  NoFreeWay none = NoFreeWay::closed;
  for (const TimedWay& rough : roughs) {
    auto way = find_coarse_free_way(rough, timer, stop);
    if (way) {
      ways.push_back(std::move(*way));
    } else {
      none = way.error();
    }
  }
  if (ways.empty()) return tl::unexpected(none);
  std::ranges::sort(ways, {}, &TimedWay::duration);
  return ways;
}

/// The fastest route whose search converges. `starts`: the fastest first.
tl::expected<FreeWay, NoFreeWay> settled_way(const std::vector<TimedWay>& starts, const LegTimer& timer,
                                             const std::stop_token& stop) {
  tl::expected<FreeWay, NoFreeWay> way = tl::unexpected(NoFreeWay::closed);
  for (const TimedWay& start : starts) {
    way = find_free_way(start, timer, stop);
    if (way) break;
  }
  return way;
}

/// The reason why the route is closed; empty if it is open.
/// `since_surfacing` time since the vehicle could last surface: before the call at the start of the route, afterwards
/// at its end
std::optional<motion::EdgeClosed> closure(const cost::Sea& sea, const TimedWay& way,
                                          core::Seconds& since_surfacing) {
  for (std::size_t i = 1; i < way.points.size(); ++i) {
    const auto leg = sea.leg(way.points[i - 1], way.points[i], way.times[i - 1], since_surfacing);
    if (!leg) return leg.error();
    since_surfacing = leg->since_surfacing;
  }
  return std::nullopt;
}

}  // namespace

Optimality rate_route(const cost::Sea& sea, const cost::Route& route, const std::stop_token& stop) {
  OpenWater water{sea};
  const LegTimer timer = water.timer();
  const auto own = time_way(route.points, core::Seconds{0.0}, timer);
  if (!own) return {std::nullopt, "the route cannot be timed without its obstacles"};

  core::Seconds least{0.0};
  core::Seconds since_surfacing{0.0};
  double accuracy = 0.0;
  for (const auto& section : sections_of(route)) {
    const auto starts = coarse_ways(section, least, timer, stop);
    if (water.is_exhausted()) return {std::nullopt, took_too_long};
    if (!starts) return {std::nullopt, describe(starts.error())};
    // If a route of few legs crosses land or ice, a route of more legs does, too: the distance between both is far
    // smaller than such obstacles.
    core::Seconds till_there = since_surfacing;
    if (const auto closed = closure(sea, starts->front(), till_there))
      return {std::nullopt, describe(*closed)};
    const auto way = settled_way(*starts, timer, stop);
    if (water.is_exhausted()) return {std::nullopt, took_too_long};
    if (!way) return {std::nullopt, describe(way.error())};
    if (const auto closed = closure(sea, way->way, since_surfacing)) return {std::nullopt, describe(*closed)};
    least += way->duration;
    accuracy = std::max(accuracy, way->accuracy);
  }
  const double gap = own->duration() / least - 1.0;
  if (gap < -std::max(accuracy, tolerance)) {
    return {std::nullopt, "the route is faster than the best route that the comparison found"};
  }
  return {std::max(gap, 0.0), ""};
}

}  // namespace floeplan::planning::optimal_control
