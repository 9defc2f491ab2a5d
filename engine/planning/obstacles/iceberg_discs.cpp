#include "engine/planning/obstacles/iceberg_discs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/ocean/iceberg_drift.hpp"
#include "engine/planning/obstacles/iceberg_track.hpp"

namespace floeplan::planning::obstacles {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();
constexpr double most_deviation_m = 1.0;   // allowed distance of chords from the drive; far below any margin
constexpr double most_index_slots = 96.0;  // limit: more slots would mostly hold copies
constexpr double least_slot_s = 3600.0;    // the step of the forecast
constexpr double most_index_cells = 64.0;  // on each side
constexpr double least_index_cells = 8.0;
/// A box of the index is listed in each cell that it overlaps. Smaller cells hold fewer discs that are not met;
/// with 100 cells a box, plans among 60 icebergs took 6 % less time than with 9.
constexpr double fewest_listings = 9.0;
constexpr double most_listings = 100.0;
constexpr double most_listings_in_all = 4e6;  // 16 MB

plane::PlaneBox box_of(const motion::EvenMove& move) {
  plane::PlaneBox box{move.from, move.from};
  box.include(move.to);
  return box;
}

}  // namespace

IcebergDiscs::IcebergDiscs(const ocean::Environment& environment, const IcebergRules& rules,
                           const geo::LocalProjection& projection, const plane::PlaneBox& area,
                           core::UtcTime epoch, core::Seconds horizon, const std::stop_token& stop,
                           std::optional<PassUnder> pass_under, const std::vector<geo::PlanePoint>& stops,
                           core::Metres rounding)
    : pass_under_{std::move(pass_under)}, standing_{!rules.drift || environment.icebergs.empty()} {
  for (const ocean::Iceberg& iceberg : environment.icebergs) {
    if (stop.stop_requested()) return;
    if (ocean::is_too_old(iceberg, epoch)) continue;
    const auto track = track_of(iceberg, environment, rules, projection, epoch, horizon, stop);
    const double scale = track.front().scale;
    const core::Metres stated = iceberg.position_uncertainty.value_or(core::Metres{0.0});
    Berg berg{.name = iceberg.id,
              .disc = {track, core::Metres{0.5 * ocean::safe_length(iceberg).value}, rules.margin, rounding},
              .error = {.at_sighting_m = scale * stated.value,
                        .growth_m_s = standing_ ? 0.0 : scale * ocean::error_growth.value,
                        .sighted_s = (iceberg.observed - epoch).count()},
              .keel = pass_under_ ? pass_under_->keel_of(iceberg) : std::nullopt};
    const auto comes_over = [&](geo::PlanePoint stop_here) {
      const motion::EvenMove staying{stop_here, stop_here, 0.0, std::max(0.0, track.back().t_s)};
      return berg.disc.swept().contains(stop_here) && berg.disc.first_touch(staying);
    };
    if (berg.keel && std::ranges::any_of(stops, comes_over)) berg.keel.reset();
    may_pass_under_ = may_pass_under_ || berg.keel;
    bergs_.push_back(std::move(berg));
  }
  index(area, horizon);
}

void IcebergDiscs::index(const plane::PlaneBox& area, core::Seconds horizon) {
  slot_s_ = std::max(least_slot_s, horizon.count() / most_index_slots);
  double largest_m = 0.0;
  std::vector<DiscIndex::Entry> entries;
  for (std::uint32_t i = 0; i < bergs_.size(); ++i) {
    const DriftingDisc& disc = bergs_[i].disc;
    if (!plane::overlap(disc.swept(), area)) continue;
    const std::vector<DriftingDisc::Knot>& knots = disc.knots();
    for (const auto& knot : knots) largest_m = std::max(largest_m, knot.radius_m);
    // One entry for each slot that a piece of the track overlaps. The last knot stays without end.
    for (std::size_t k = 0; k < knots.size(); ++k) {
      const bool last = k + 1 == knots.size();
      const double until_s = last ? forever : knots[k + 1].t_s;
      const bool same_slot =
          !entries.empty() && entries.back().item == i && !last &&
          std::floor(entries.back().span.from.count() / slot_s_) == std::floor(until_s / slot_s_);
      if (same_slot) {
        entries.back().box.include(disc.swept_from(k));
        entries.back().span.until = core::Seconds{until_s};
      } else {
        entries.push_back({i, disc.swept_from(k), {core::Seconds{knots[k].t_s}, core::Seconds{until_s}}});
      }
    }
  }
  if (entries.empty()) return;
  const double side_m = std::max(area.width_m(), area.height_m());
  const double listings =
      std::clamp(most_listings_in_all / static_cast<double>(entries.size()), fewest_listings, most_listings);
  // A box as wide as the largest disc overlaps at most (width / cell + 1)^2 cells.
  const double cell_m = std::clamp(2.0 * largest_m / (std::sqrt(listings) - 1.0), side_m / most_index_cells,
                                   side_m / least_index_cells);
  index_ =
      DiscIndex{area, cell_m, core::Seconds{slot_s_}, standing_ ? core::Seconds{slot_s_} : horizon, entries};
}

const IcebergDiscs::Berg* IcebergDiscs::met_by(const motion::EvenMove& move, double slack_m) const {
  if (bergs_.empty()) return nullptr;
  // Slot by slot: over a longer time the box of a long move would contain discs that the vehicle does not
  // meet.
  double from_s = move.t0_s;
  for (double slot = std::floor(move.t0_s / slot_s_); from_s <= move.t1_s; slot += 1.0) {
    const double end_s = (slot + 1.0) * slot_s_;
    const double until_s = std::clamp(end_s, from_s, move.t1_s);
    const motion::EvenMove part{motion::place_at(move, from_s), motion::place_at(move, until_s), from_s,
                                until_s};
    const Berg* met = nullptr;
    index_.any_in(box_of(part).grown(slack_m), {core::Seconds{from_s}, core::Seconds{until_s}},
                  [&](std::uint32_t i) {
                    const bool meets = bergs_[i].disc.first_touch(part, slack_m).has_value();
                    if (meets && !has_room_under(bergs_[i], part, slack_m)) met = &bergs_[i];
                    return met != nullptr;
                  });
    if (met != nullptr) return met;
    if (end_s >= move.t1_s) return nullptr;
    from_s = until_s;
  }
  return nullptr;
}

bool IcebergDiscs::has_room_under(const Berg& berg, const motion::EvenMove& move, double slack_m) const {
  if (!berg.keel) return false;
  constexpr double step_m = 100.0;  // distance between samples: about the finest bathymetry in use
  const double length_m = geo::distance_m(move.from, move.to);
  const int steps = std::max(1, static_cast<int>(std::ceil(length_m / step_m)));
  geo::PlanePoint last = move.from;
  for (int i = 0; i <= steps; ++i) {
    const double t_s = move.t0_s + (move.t1_s - move.t0_s) * i / steps;
    const geo::PlanePoint point = motion::place_at(move, t_s);
    const auto gap = berg.disc.gap_m(point, t_s);
    const bool near = gap && *gap <= step_m + slack_m;
    if (near && !pass_under_->has_room_along(last, point, berg.keel->upper_turn)) return false;
    last = point;
  }
  return true;
}

std::size_t IcebergDiscs::bytes() const {
  std::size_t bytes = index_.bytes() + bergs_.size() * sizeof(Berg);
  for (const Berg& berg : bergs_) bytes += berg.disc.bytes();
  return bytes;
}

bool IcebergDiscs::touched(const motion::EvenMove& move, double slack_m) const {
  return met_by(move, slack_m) != nullptr;
}

std::optional<core::Seconds> IcebergDiscs::first_clear(geo::PlanePoint from, geo::PlanePoint to,
                                                       core::Seconds duration, core::Seconds depart,
                                                       core::Seconds latest) const {
  constexpr int most_bergs = 64;         // avoided one after another
  constexpr double first_step_s = 60.0;  // first step to a departure behind one disc; doubled each time
  constexpr double longest_step_s =
      900.0;  // limit of the step, because a berg that turns back may open the line for only an hour or two
  constexpr double close_enough_s = 5.0;
  const auto leaving = [&](double t_s) { return motion::EvenMove{from, to, t_s, t_s + duration.count()}; };
  double t_s = depart.count();
  for (int i = 0; i < most_bergs && t_s <= latest.count(); ++i) {
    const Berg* berg = met_by(leaving(t_s), 0.0);
    if (berg == nullptr) return core::Seconds{t_s};
    // For one straight piece of drift, the departures that touch the disc form a single interval.
    double closed_s = t_s;
    double open_s = t_s + first_step_s;
    for (double step_s = first_step_s; berg->disc.first_touch(leaving(open_s));) {
      if (open_s > latest.count()) return std::nullopt;
      step_s = std::min(2.0 * step_s, longest_step_s);
      closed_s = open_s;
      open_s += step_s;
    }
    while (open_s - closed_s > close_enough_s) {
      const double middle_s = 0.5 * (closed_s + open_s);
      (berg->disc.first_touch(leaving(middle_s)) ? closed_s : open_s) = middle_s;
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

std::vector<TimeSpan> IcebergDiscs::closed_times(geo::PlanePoint point, core::Metres grown) const {
  std::vector<TimeSpan> closed;
  for (const Berg& berg : bergs_) {
    const std::vector<TimeSpan> covered = berg.disc.covers(point, grown.value);
    if (covered.empty() || (berg.keel && pass_under_->has_room(point, berg.keel->upper_turn))) continue;
    closed.insert(closed.end(), covered.begin(), covered.end());
  }
  return joined(std::move(closed));
}

std::optional<IcebergDiscs::Nearest> IcebergDiscs::nearest(geo::PlanePoint point, core::Seconds time) const {
  std::optional<Nearest> result;
  const motion::EvenMove here{point, point, time.count(), time.count()};
  double least_m = forever;
  for (const Berg& berg : bergs_) {
    berg.disc.for_each_piece(time.count(), time.count(), [&](const motion::MovingDisc& disc) {
      const auto distance_m = motion::least_distance(here, disc);
      const double radius_m = disc.radius0_m + (time.count() - disc.t0_s) * disc.growth_m_s;
      if (!distance_m || *distance_m - radius_m >= least_m) return false;
      least_m = *distance_m - radius_m;
      const DriftingDisc::Hull hull = berg.disc.hull(time.count());
      result = Nearest{
          berg.name, {(*distance_m - hull.radius_m) / hull.scale}, {(radius_m - hull.radius_m) / hull.scale}};
      return false;
    });
  }
  return result;
}

double IcebergDiscs::expected_encounters(const motion::EvenMove& move) const {
  double sum = 0.0;
  for (const Berg& berg : bergs_) {
    sum += obstacles::expected_encounters(berg.disc, berg.error, berg.keel.has_value(), move);
  }
  return sum;
}

double IcebergDiscs::encounter_rate(geo::PlanePoint point, core::Seconds time, core::MetresPerSecond speed,
                                    core::Metres blur) const {
  double sum = 0.0;
  for (const Berg& berg : bergs_) {
    sum += obstacles::encounter_rate(berg.disc, berg.error, berg.keel.has_value(), point, time, speed, blur);
  }
  return sum;
}

std::optional<core::Metres> IcebergDiscs::least_upper_turn(geo::PlanePoint point, core::Seconds time) const {
  std::optional<core::Metres> deepest;
  if (!may_pass_under_) return deepest;
  for (const Berg& berg : bergs_) {
    if (!berg.keel || !berg.disc.swept().contains(point)) continue;
    const auto gap_m = berg.disc.gap_m(point, time.count());
    if (!gap_m || *gap_m > 0.0) continue;
    deepest = std::max(deepest.value_or(core::Metres{0.0}), berg.keel->upper_turn);
  }
  return deepest;
}

std::vector<IcebergDiscs::Under> IcebergDiscs::passed_under(const motion::EvenMove& move) const {
  std::vector<Under> result;
  for (std::size_t i = 0; i < bergs_.size(); ++i) {
    if (!bergs_[i].keel) continue;
    bergs_[i].disc.for_each_piece(move.t0_s, move.t1_s, [&](const motion::MovingDisc& disc) {
      if (const auto span = time_within(disc, move)) result.push_back({i, *span});
      return false;
    });
  }
  return result;
}

std::optional<IcebergDiscs::NearestHull> IcebergDiscs::nearest_hull(const motion::EvenMove& move) const {
  std::optional<NearestHull> least;
  for (std::size_t i = 0; i < bergs_.size(); ++i) {
    const Berg& berg = bergs_[i];
    if (berg.keel && berg.disc.first_touch(move)) continue;  // passed under
    berg.disc.for_each_piece(move.t0_s, move.t1_s, [&](const motion::MovingDisc& disc) {
      const auto distance_m = motion::least_distance(move, disc);
      if (!distance_m) return false;
      const DriftingDisc::Hull hull = berg.disc.hull(std::max(disc.t0_s, move.t0_s));
      const core::Metres clear{(*distance_m - hull.radius_m) / hull.scale};
      if (!least || clear < least->distance) least = NearestHull{i, clear};
      return false;
    });
  }
  return least;
}

}  // namespace floeplan::planning::obstacles
