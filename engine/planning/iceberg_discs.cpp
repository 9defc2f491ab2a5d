#include "engine/planning/iceberg_discs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/ocean/iceberg_drift.hpp"
#include "engine/planning/iceberg_track.hpp"

namespace floeplan::planning {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();
constexpr double most_deviation_m = 1.0;   // of chords from the drive: far below any margin
constexpr double most_slots = 96.0;        // of the index; more would be mostly copies
constexpr double least_slot_s = 3600.0;    // the step of the forecast
constexpr double most_index_cells = 64.0;  // a side
constexpr double least_index_cells = 8.0;

PlaneBox box_around(geo::PlanePoint centre, double radius_m) {
  return PlaneBox{centre, centre}.grown(radius_m);
}

void include(PlaneBox& box, const PlaneBox& other) {
  box.include(other.low);
  box.include(other.high);
}

bool overlap(const PlaneBox& a, const PlaneBox& b) {
  return a.low.x_m <= b.high.x_m && b.low.x_m <= a.high.x_m && a.low.y_m <= b.high.y_m &&
         b.low.y_m <= a.high.y_m;
}

PlaneBox box_of(const motion::EvenMove& move) {
  PlaneBox box{move.from, move.from};
  box.include(move.to);
  return box;
}

geo::PlanePoint place_at(const motion::EvenMove& move, double t_s) {
  const double duration = move.t1_s - move.t0_s;
  const double share = duration > 0.0 ? (t_s - move.t0_s) / duration : 0.0;
  return {move.from.x_m + share * (move.to.x_m - move.from.x_m),
          move.from.y_m + share * (move.to.y_m - move.from.y_m)};
}

/// The same in reversed time.
motion::EvenMove reversed(const motion::EvenMove& move) {
  return {move.to, move.from, -move.t1_s, -move.t0_s};
}

motion::MovingDisc reversed(const motion::MovingDisc& disc) {
  const double duration = disc.t1_s - disc.t0_s;
  return {
      -disc.t1_s,
      -disc.t0_s,
      {disc.centre0.x_m + duration * disc.velocity.x_m_s, disc.centre0.y_m + duration * disc.velocity.y_m_s},
      {-disc.velocity.x_m_s, -disc.velocity.y_m_s},
      disc.radius0_m + duration * disc.growth_m_s,
      -disc.growth_m_s};
}

/// When the vehicle is in a disc; empty: never. Distance less radius is convex in time, so it is one span.
std::optional<TimeSpan> in_disc(const motion::MovingDisc& disc, const motion::EvenMove& move) {
  const auto first = motion::first_touch(move, disc);
  if (!first) return std::nullopt;
  motion::MovingDisc ending = disc;
  ending.t1_s = std::min(disc.t1_s, move.t1_s);
  const auto last = motion::first_touch(reversed(move), reversed(ending));
  return TimeSpan{core::Seconds{*first}, core::Seconds{last ? -*last : *first}};
}

/// When a disc covers a point; empty: never. Distance less radius is convex in time, so it is one span.
std::optional<TimeSpan> covered_by(const motion::MovingDisc& disc, geo::PlanePoint point) {
  const motion::EvenMove standing{point, point, disc.t0_s, disc.t1_s};
  const auto first = motion::first_touch(standing, disc);
  if (!first) return std::nullopt;
  if (disc.t1_s == forever) return TimeSpan{core::Seconds{*first}, core::Seconds{forever}};
  const auto last = motion::first_touch(reversed(standing), reversed(disc));
  return TimeSpan{core::Seconds{*first}, core::Seconds{last ? -*last : *first}};
}

struct Interval {
  double from_s;
  double until_s;
};

/// The vehicle sweeps a strip as wide as twice what is kept, at its speed against the berg, through the density of
/// the berg's position: a normal one in two dimensions, whose mean error is sqrt(pi / 2) of its standard deviation.
/// By Simpson's rule in steps in which the vehicle goes no more than half a standard deviation, or ten minutes.
template <class ErrorAt>
double encounters_with(const motion::MovingDisc& disc, const motion::EvenMove& move, Interval during,
                       double kept_m, const ErrorAt& error_at) {
  constexpr double farthest = 6.0;  // standard deviations: 1e-8 of the density at the middle
  constexpr double longest_step_s = 600.0;
  constexpr double shortest_step_s = 10.0;
  const double mean_per_deviation = std::sqrt(0.5 * std::numbers::pi);
  const double duration_s = move.t1_s - move.t0_s;
  const double vx = (move.to.x_m - move.from.x_m) / duration_s - disc.velocity.x_m_s;
  const double vy = (move.to.y_m - move.from.y_m) / duration_s - disc.velocity.y_m_s;
  const double speed_m_s = std::hypot(vx, vy);
  const double widest_m = std::max(error_at(during.from_s), error_at(during.until_s)) / mean_per_deviation;
  const double nearest_m = motion::least_distance(move, disc).value_or(forever);
  if (speed_m_s <= 0.0 || widest_m <= 0.0 || nearest_m > farthest * widest_m) return 0.0;

  const auto rate = [&](double t_s) {
    const double deviation_m = std::max(error_at(t_s) / mean_per_deviation, 1.0);
    const geo::PlanePoint vehicle = place_at(move, t_s);
    const double dx = vehicle.x_m - disc.centre0.x_m - (t_s - disc.t0_s) * disc.velocity.x_m_s;
    const double dy = vehicle.y_m - disc.centre0.y_m - (t_s - disc.t0_s) * disc.velocity.y_m_s;
    const double square = (dx * dx + dy * dy) / (deviation_m * deviation_m);
    const double density = std::exp(-0.5 * square) / (2.0 * std::numbers::pi * deviation_m * deviation_m);
    return 2.0 * kept_m * speed_m_s * density;
  };
  const double narrowest_m = std::min(error_at(during.from_s), error_at(during.until_s)) / mean_per_deviation;
  const double step_s = std::clamp(0.5 * narrowest_m / speed_m_s, shortest_step_s, longest_step_s);
  const int steps = static_cast<int>(std::ceil((during.until_s - during.from_s) / step_s));
  const double h = (during.until_s - during.from_s) / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double a = during.from_s + i * h;
    sum += h / 6.0 * (rate(a) + 4.0 * rate(a + 0.5 * h) + rate(a + h));
  }
  return sum;
}

}  // namespace

IcebergDiscs::IcebergDiscs(const ocean::Environment& environment, const IcebergRules& rules,
                           const geo::LocalProjection& projection, const PlaneBox& area, core::UtcTime epoch,
                           core::Seconds horizon, const std::stop_token& stop,
                           std::optional<PassUnder> pass_under, const std::vector<geo::PlanePoint>& stops)
    : pass_under_{std::move(pass_under)}, standing_{!rules.drift || environment.icebergs.empty()} {
  for (const ocean::Iceberg& iceberg : environment.icebergs) {
    if (stop.stop_requested()) return;
    const auto track = track_of(iceberg, environment, rules, projection, epoch, horizon, stop);
    const double hull_m = 0.5 * ocean::safe_length(iceberg).value;
    Berg berg{.name = iceberg.id,
              .hull_radius_m = track.front().scale * hull_m,
              .kept_m = track.front().scale * (hull_m + rules.margin.value),
              .scale = track.front().scale,
              .stated_error = iceberg.position_uncertainty.value_or(core::Metres{0.0}),
              .sighted_s = (iceberg.observed - epoch).count(),
              .swept = {track.front().centre, track.front().centre},
              .knots = {}};
    for (const TrackPoint& point : track) {
      const double radius_m = point.scale * (hull_m + rules.margin.value + point.error.value);
      berg.knots.push_back({point.t_s, point.centre, radius_m});
      include(berg.swept, box_around(point.centre, radius_m));
    }
    if (pass_under_) berg.keel = pass_under_->keel_of(iceberg);
    const auto comes_over = [&](geo::PlanePoint stop_here) {
      const motion::EvenMove staying{stop_here, stop_here, 0.0, std::max(0.0, track.back().t_s)};
      return berg.swept.contains(stop_here) && touch(berg, staying, 0.0);
    };
    if (berg.keel && std::ranges::any_of(stops, comes_over)) berg.keel.reset();
    bergs_.push_back(std::move(berg));
  }
  index(area, horizon);
}

void IcebergDiscs::index(const PlaneBox& area, core::Seconds horizon) {
  slot_s_ = std::max(least_slot_s, horizon.count() / most_slots);
  double largest_m = 0.0;
  std::vector<DiscIndex::Entry> entries;
  for (std::uint32_t i = 0; i < bergs_.size(); ++i) {
    const Berg& berg = bergs_[i];
    if (!overlap(berg.swept, area)) continue;
    for (const Knot& knot : berg.knots) largest_m = std::max(largest_m, knot.radius_m);
    // Every piece of the track in each slot it lasts into; the last knot stays for ever.
    for (std::size_t k = 0; k < berg.knots.size(); ++k) {
      const bool last = k + 1 == berg.knots.size();
      PlaneBox box = box_around(berg.knots[k].centre, berg.knots[k].radius_m);
      if (!last) include(box, box_around(berg.knots[k + 1].centre, berg.knots[k + 1].radius_m));
      const double until_s = last ? forever : berg.knots[k + 1].t_s;
      const bool same_slot =
          !entries.empty() && entries.back().item == i && !last &&
          std::floor(entries.back().span.from.count() / slot_s_) == std::floor(until_s / slot_s_);
      if (same_slot) {
        include(entries.back().box, box);
        entries.back().span.until = core::Seconds{until_s};
      } else {
        entries.push_back({i, box, {core::Seconds{berg.knots[k].t_s}, core::Seconds{until_s}}});
      }
    }
  }
  if (entries.empty()) return;
  const double side_m = std::max(area.width_m(), area.height_m());
  const double cell_m = std::clamp(largest_m, side_m / most_index_cells, side_m / least_index_cells);
  index_ =
      DiscIndex{area, cell_m, core::Seconds{slot_s_}, standing_ ? core::Seconds{slot_s_} : horizon, entries};
}

motion::MovingDisc IcebergDiscs::disc(const Berg& berg, std::size_t knot, double slack_m) {
  const Knot& a = berg.knots[knot];
  if (knot + 1 == berg.knots.size()) return {a.t_s, forever, a.centre, {}, a.radius_m + slack_m, 0.0};
  const Knot& b = berg.knots[knot + 1];
  const double duration = b.t_s - a.t_s;
  return {a.t_s,
          b.t_s,
          a.centre,
          {(b.centre.x_m - a.centre.x_m) / duration, (b.centre.y_m - a.centre.y_m) / duration},
          a.radius_m + slack_m,
          (b.radius_m - a.radius_m) / duration};
}

/// Calls `visit(disc)` for the pieces of the track that last into the span, in order, until it answers true.
template <class Visit>
void IcebergDiscs::for_each_disc(const Berg& berg, double from_s, double until_s, double slack_m,
                                 Visit&& visit) {
  const auto after = std::ranges::upper_bound(berg.knots, from_s, {}, &Knot::t_s);
  auto knot = static_cast<std::size_t>(after - berg.knots.begin());
  if (knot > 0) --knot;
  for (; knot < berg.knots.size() && berg.knots[knot].t_s <= until_s; ++knot) {
    if (visit(disc(berg, knot, slack_m))) return;
  }
}

std::optional<double> IcebergDiscs::touch(const Berg& berg, const motion::EvenMove& move, double slack_m) {
  std::optional<double> first;
  for_each_disc(berg, move.t0_s, move.t1_s, slack_m, [&](const motion::MovingDisc& disc) {
    first = motion::first_touch(move, disc);
    return first.has_value();
  });
  return first;
}

const IcebergDiscs::Berg* IcebergDiscs::met_by(const motion::EvenMove& move, double slack_m) const {
  if (bergs_.empty()) return nullptr;
  // Slot by slot, because over a longer time the box of a long move meets discs that the vehicle does not.
  double from_s = move.t0_s;
  for (double slot = std::floor(move.t0_s / slot_s_); from_s <= move.t1_s; slot += 1.0) {
    const double end_s = (slot + 1.0) * slot_s_;
    const double until_s = std::clamp(end_s, from_s, move.t1_s);
    const motion::EvenMove part{place_at(move, from_s), place_at(move, until_s), from_s, until_s};
    const Berg* met = nullptr;
    index_.any_in(box_of(part).grown(slack_m), {core::Seconds{from_s}, core::Seconds{until_s}},
                  [&](std::uint32_t i) {
                    const bool meets = touch(bergs_[i], part, slack_m).has_value();
                    if (meets && !has_room_under(bergs_[i], part, slack_m)) met = &bergs_[i];
                    return met != nullptr;
                  });
    if (met != nullptr) return met;
    if (end_s >= move.t1_s) return nullptr;
    from_s = until_s;
  }
  return nullptr;
}

std::optional<double> IcebergDiscs::gap_m(const Berg& berg, geo::PlanePoint point, double t_s) {
  std::optional<double> gap_m;
  for_each_disc(berg, t_s, t_s, 0.0, [&](const motion::MovingDisc& disc) {
    const double since_s = t_s - disc.t0_s;
    gap_m = std::hypot(point.x_m - disc.centre0.x_m - since_s * disc.velocity.x_m_s,
                       point.y_m - disc.centre0.y_m - since_s * disc.velocity.y_m_s) -
            disc.radius0_m - since_s * disc.growth_m_s;
    return true;
  });
  return gap_m;
}

bool IcebergDiscs::covers(const Berg& berg, geo::PlanePoint point, double t_s) const {
  const auto gap = gap_m(berg, point, t_s);
  return gap && *gap <= 0.0;
}

bool IcebergDiscs::has_room_under(const Berg& berg, const motion::EvenMove& move, double slack_m) const {
  if (!berg.keel) return false;
  constexpr double step_m = 100.0;  // about the finest bathymetry in use
  const double length_m = std::hypot(move.to.x_m - move.from.x_m, move.to.y_m - move.from.y_m);
  const int steps = std::max(1, static_cast<int>(std::ceil(length_m / step_m)));
  for (int i = 0; i <= steps; ++i) {
    const double t_s = move.t0_s + (move.t1_s - move.t0_s) * i / steps;
    const geo::PlanePoint point = place_at(move, t_s);
    const auto gap = gap_m(berg, point, t_s);
    const bool near = gap && *gap <= step_m + slack_m;
    if (near && !pass_under_->has_room(point, berg.keel->upper_turn)) return false;
  }
  return true;
}

bool IcebergDiscs::touched(const motion::EvenMove& move, double slack_m) const {
  return met_by(move, slack_m) != nullptr;
}

std::optional<core::Seconds> IcebergDiscs::first_clear(geo::PlanePoint from, geo::PlanePoint to,
                                                       core::Seconds duration, core::Seconds depart,
                                                       core::Seconds latest) const {
  constexpr int most_bergs = 64;         // in the way one after the other
  constexpr double first_step_s = 60.0;  // out of one disc's way, then twice as far each time
  constexpr double longest_step_s =
      900.0;  // a berg that turns back may leave the way open for an hour or two
  constexpr double close_enough_s = 5.0;
  const auto leaving = [&](double t_s) { return motion::EvenMove{from, to, t_s, t_s + duration.count()}; };
  double t_s = depart.count();
  for (int i = 0; i < most_bergs && t_s <= latest.count(); ++i) {
    const Berg* berg = met_by(leaving(t_s), 0.0);
    if (berg == nullptr) return core::Seconds{t_s};
    // For one piece of a straight drift the departures that touch the disc are all those between two of them.
    double closed_s = t_s;
    double open_s = t_s + first_step_s;
    for (double step_s = first_step_s; touch(*berg, leaving(open_s), 0.0);) {
      if (open_s > latest.count()) return std::nullopt;
      step_s = std::min(2.0 * step_s, longest_step_s);
      closed_s = open_s;
      open_s += step_s;
    }
    while (open_s - closed_s > close_enough_s) {
      const double middle_s = 0.5 * (closed_s + open_s);
      (touch(*berg, leaving(middle_s), 0.0) ? closed_s : open_s) = middle_s;
    }
    t_s = open_s;
  }
  return std::nullopt;
}

bool IcebergDiscs::touched(const motion::PlaneEdge& edge, const motion::EdgePiece& piece,
                           double slack_m) const {
  if (bergs_.empty()) return false;
  const auto met = motion::follow_piece(
      edge, piece, most_deviation_m, [&](const motion::EvenMove& move, double deviation_m) {
        return touched(move, slack_m + deviation_m) ? std::optional{true} : std::nullopt;
      });
  return met.has_value();
}

std::vector<TimeSpan> IcebergDiscs::closed_times(geo::PlanePoint point) const {
  std::vector<TimeSpan> closed;
  for (const Berg& berg : bergs_) {
    if (!berg.swept.contains(point)) continue;
    if (berg.keel && pass_under_->has_room(point, berg.keel->upper_turn)) continue;
    const std::size_t of_others = closed.size();
    for_each_disc(berg, 0.0, forever, 0.0, [&](const motion::MovingDisc& disc) {
      const auto span = covered_by(disc, point);
      if (!span) return false;
      // Where the disc covers the point at a knot, two pieces of its drift end and begin there.
      if (closed.size() > of_others && span->from <= closed.back().until) {
        closed.back().until = std::max(closed.back().until, span->until);
      } else {
        closed.push_back(*span);
      }
      return false;
    });
  }
  return joined(std::move(closed));
}

std::optional<IcebergDiscs::Nearest> IcebergDiscs::nearest(geo::PlanePoint point, core::Seconds time) const {
  std::optional<Nearest> result;
  const motion::EvenMove here{point, point, time.count(), time.count()};
  double least_m = forever;
  for (const Berg& berg : bergs_) {
    for_each_disc(berg, time.count(), time.count(), 0.0, [&](const motion::MovingDisc& disc) {
      const auto distance_m = motion::least_distance(here, disc);
      const double radius_m = disc.radius0_m + (time.count() - disc.t0_s) * disc.growth_m_s;
      if (!distance_m || *distance_m - radius_m >= least_m) return false;
      least_m = *distance_m - radius_m;
      result = Nearest{berg.name,
                       {(*distance_m - berg.hull_radius_m) / berg.scale},
                       {(radius_m - berg.hull_radius_m) / berg.scale}};
      return false;
    });
  }
  return result;
}

double IcebergDiscs::mean_error_m(const Berg& berg, double t_s) const {
  const double age_s = standing_ ? 0.0 : std::abs(t_s - berg.sighted_s);
  return berg.scale * (berg.stated_error.value + ocean::error_growth.value * age_s);
}

double IcebergDiscs::expected_encounters(const motion::EvenMove& move) const {
  double sum = 0.0;
  for (const Berg& berg : bergs_) {
    for_each_disc(berg, move.t0_s, move.t1_s, 0.0, [&](const motion::MovingDisc& disc) {
      const double from_s = std::max(move.t0_s, disc.t0_s);
      const double until_s = std::min(move.t1_s, disc.t1_s);
      const auto error_at = [&](double t_s) { return mean_error_m(berg, t_s); };
      const auto add = [&](double begin_s, double end_s) {
        if (begin_s < end_s) sum += encounters_with(disc, move, {begin_s, end_s}, berg.kept_m, error_at);
      };
      const auto under = berg.keel ? in_disc(disc, move) : std::nullopt;
      add(from_s, under ? under->from.count() : until_s);
      if (under) add(under->until.count(), until_s);
      return false;
    });
  }
  return sum;
}

double IcebergDiscs::encounter_rate(geo::PlanePoint point, core::Seconds time, core::MetresPerSecond speed,
                                    core::Metres blur) const {
  const double mean_per_deviation = std::sqrt(0.5 * std::numbers::pi);
  constexpr double farthest_square = 36.0;  // six standard deviations
  double sum = 0.0;
  for (const Berg& berg : bergs_) {
    const double error_m = mean_error_m(berg, time.count());
    const double deviation_m = std::max(error_m / mean_per_deviation, blur.value);
    for_each_disc(berg, time.count(), time.count(), 0.0, [&](const motion::MovingDisc& disc) {
      const double since_s = time.count() - disc.t0_s;
      const double dx = point.x_m - disc.centre0.x_m - since_s * disc.velocity.x_m_s;
      const double dy = point.y_m - disc.centre0.y_m - since_s * disc.velocity.y_m_s;
      const double square = (dx * dx + dy * dy) / (deviation_m * deviation_m);
      const bool under = berg.keel && std::hypot(dx, dy) <= disc.radius0_m + since_s * disc.growth_m_s;
      if (square < farthest_square && error_m > 0.0 && !under) {
        sum += 2.0 * berg.kept_m * speed.value * std::exp(-0.5 * square) /
               (2.0 * std::numbers::pi * deviation_m * deviation_m);
      }
      return true;
    });
  }
  return sum;
}

std::optional<core::Metres> IcebergDiscs::least_upper_turn(geo::PlanePoint point, core::Seconds time) const {
  std::optional<core::Metres> deepest;
  for (const Berg& berg : bergs_) {
    if (!berg.keel || !berg.swept.contains(point) || !covers(berg, point, time.count())) continue;
    deepest = std::max(deepest.value_or(core::Metres{0.0}), berg.keel->upper_turn);
  }
  return deepest;
}

std::vector<IcebergDiscs::Under> IcebergDiscs::passed_under(const motion::EvenMove& move) const {
  std::vector<Under> result;
  for (std::size_t i = 0; i < bergs_.size(); ++i) {
    if (!bergs_[i].keel) continue;
    for_each_disc(bergs_[i], move.t0_s, move.t1_s, 0.0, [&](const motion::MovingDisc& disc) {
      if (const auto span = in_disc(disc, move)) result.push_back({i, *span});
      return false;
    });
  }
  return result;
}

std::optional<core::Metres> IcebergDiscs::distance_from_hulls(const motion::EvenMove& move) const {
  std::optional<core::Metres> least;
  for (const Berg& berg : bergs_) {
    if (berg.keel && touch(berg, move, 0.0)) continue;  // passed under
    for_each_disc(berg, move.t0_s, move.t1_s, 0.0, [&](const motion::MovingDisc& disc) {
      const auto distance_m = motion::least_distance(move, disc);
      if (!distance_m) return false;
      const core::Metres clear{(*distance_m - berg.hull_radius_m) / berg.scale};
      if (!least || clear < *least) least = clear;
      return false;
    });
  }
  return least;
}

}  // namespace floeplan::planning
