#include "storage/ingest/readers/coastline/gshhg_bin.hpp"

#include <algorithm>
#include <cassert>

namespace floeplan::ingest {
namespace {

constexpr int side_steps = 65535;
constexpr int round_steps = 4 * side_steps;

/// Position of a point along the bin's border, anticlockwise from the south-west corner, in [0, round_steps).
int way_round(BinSide side, BinPoint point) {
  switch (side) {
    case BinSide::south: return point.east;
    case BinSide::east: return side_steps + point.north;
    case BinSide::north: return 3 * side_steps - point.east;
    case BinSide::west: return (4 * side_steps - point.north) % round_steps;
    case BinSide::none: break;
  }
  assert(false && "a closed ring has no place on the bin's sides");
  return 0;
}

constexpr std::array<BinPoint, 4> corners{
    {{0, 0}, {side_steps, 0}, {side_steps, side_steps}, {0, side_steps}}};

int distance_round(int from, int to) { return (to - from + round_steps) % round_steps; }

bool is_closed(const ShoreSegment& segment) { return segment.entry == BinSide::none; }

/// Where a segment enters the bin. Unused entries are in a list sorted by position along the border, then by
/// index.
struct Entry {
  int at{};
  std::size_t segment{};
};

std::vector<Entry> entries_of(const ShoreBin& bin) {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < bin.segments.size(); ++i) {
    const ShoreSegment& segment = bin.segments[i];
    if (!is_closed(segment)) entries.push_back({way_round(segment.entry, segment.points.front()), i});
  }
  std::ranges::stable_sort(entries, {}, &Entry::at);
  return entries;
}

std::size_t next_entry(const std::vector<Entry>& waiting, int from) {
  const auto next = std::ranges::lower_bound(waiting, from, {}, &Entry::at);
  return next == waiting.end() ? 0 : static_cast<std::size_t>(next - waiting.begin());
}

class RingBuilder {
 public:
  explicit RingBuilder(const ShoreBin& bin) : bin_{bin}, step_deg_{bin.size_deg / side_steps} {}

  void add(BinPoint point) {
    const geo::LonLat place{bin_.south_west.lon_deg + point.east * step_deg_,
                            bin_.south_west.lat_deg + point.north * step_deg_};
    if (ring_.empty() || ring_.back() != place) ring_.push_back(place);
  }
  void add(const std::vector<BinPoint>& points) {
    for (const BinPoint point : points) add(point);
  }
  /// Adds the corners strictly between two positions on the bin's border, anticlockwise.
  void add_corners_between(int from, int to) {
    for (int i = 1; i <= 4; ++i) {
      const int corner = (from / side_steps + i) % 4;
      if (distance_round(from, corner * side_steps) >= distance_round(from, to)) return;
      add(corners[static_cast<std::size_t>(corner)]);
    }
  }
  [[nodiscard]] geo::Ring finished() && {
    while (ring_.size() > 1 && ring_.front() == ring_.back()) ring_.pop_back();
    return std::move(ring_);
  }

 private:
  const ShoreBin& bin_;
  double step_deg_;
  geo::Ring ring_;
};

geo::Ring whole_bin(const ShoreBin& bin) {
  RingBuilder ring{bin};
  for (const BinPoint corner : corners) ring.add(corner);
  return std::move(ring).finished();
}

geo::Ring closed_ring(const ShoreBin& bin, const ShoreSegment& segment) {
  RingBuilder ring{bin};
  ring.add(segment.points);
  return std::move(ring).finished();
}

/// Traces an outer ring: follows a segment, with the dry side on the left, to where it leaves the bin, then
/// the border anticlockwise to the next entry, until the first segment is reached again.
geo::Ring trace(const ShoreBin& bin, std::vector<Entry>& waiting) {
  RingBuilder ring{bin};
  const std::size_t first = waiting.front().segment;
  std::size_t current = first;
  while (true) {
    const ShoreSegment& segment = bin.segments[current];
    ring.add(segment.points);
    const int left_at = way_round(segment.exit, segment.points.back());
    const std::size_t next = next_entry(waiting, left_at);
    ring.add_corners_between(left_at, waiting[next].at);
    current = waiting[next].segment;
    waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(next));
    if (current == first) return std::move(ring).finished();
  }
}

/// The piece of land around a lake: of the pieces that contain a point of its shore, the one with the
/// smallest box.
geo::Polygon* piece_around(std::vector<geo::Polygon>& land, const std::vector<geo::BoundingBox>& boxes,
                           geo::LonLat shore) {
  geo::Polygon* best = nullptr;
  double best_area = 0.0;
  for (std::size_t i = 0; i < land.size(); ++i) {
    if (!geo::contains(boxes[i], shore) || !geo::contains(land[i], shore)) continue;
    const double area = geo::width_deg(boxes[i]) * (boxes[i].north_deg - boxes[i].south_deg);
    if (best != nullptr && area >= best_area) continue;
    best = &land[i];
    best_area = area;
  }
  return best;
}

/// The box of a ring within one bin; a bin never crosses the antimeridian.
geo::BoundingBox box_of(const geo::Ring& ring) {
  const auto [west, east] = std::ranges::minmax(ring, {}, &geo::LonLat::lon_deg);
  const auto [south, north] = std::ranges::minmax(ring, {}, &geo::LonLat::lat_deg);
  return {west.lon_deg, south.lat_deg, east.lon_deg, north.lat_deg};
}

void cut_lakes(const ShoreBin& bin, std::vector<geo::Polygon>& land) {
  std::vector<geo::BoundingBox> boxes;
  boxes.reserve(land.size());
  for (const geo::Polygon& piece : land) boxes.push_back(box_of(piece.outer));
  for (const ShoreSegment& segment : bin.segments) {
    if (!is_closed(segment) || segment.level % 2 != 0) continue;
    geo::Ring lake = closed_ring(bin, segment);
    if (lake.size() < 3) continue;
    geo::Polygon* const piece = piece_around(land, boxes, lake.front());
    if (piece != nullptr) piece->holes.push_back(std::move(lake));
  }
}

}  // namespace

std::vector<geo::Polygon> land_of(const ShoreBin& bin) {
  std::vector<geo::Polygon> land;
  std::vector<Entry> waiting = entries_of(bin);
  const bool nothing_crosses = waiting.empty();
  if (nothing_crosses && *std::ranges::max_element(bin.corner_levels) % 2 == 1)
    land.push_back({whole_bin(bin), {}});

  while (!waiting.empty()) {
    geo::Ring ring = trace(bin, waiting);
    if (ring.size() >= 3) land.push_back({std::move(ring), {}});
  }
  for (const ShoreSegment& segment : bin.segments) {
    if (!is_closed(segment) || segment.level % 2 == 0) continue;
    geo::Ring island = closed_ring(bin, segment);
    if (island.size() >= 3) land.push_back({std::move(island), {}});
  }
  cut_lakes(bin, land);
  return land;
}

}  // namespace floeplan::ingest
