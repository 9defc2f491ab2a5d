#include "engine/planning/obstacles/stay_in_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "engine/planning/plane/coast_lines.hpp"
#include "engine/planning/plane/plane_lines.hpp"
#include "engine/planning/plane/plane_polygon.hpp"
#include "engine/planning/plane/polygon_cells.hpp"

namespace floeplan::planning::obstacles {
namespace {

constexpr std::int64_t most_line_tests = 200'000'000;  // about a second of work
constexpr double nothing_m = 1e-3;                     // shorter lengths are rounding errors

struct OutlineLine {
  geo::PlanePoint from;
  geo::PlanePoint to;
};

/// The lines of an area's outline that cross a cell.
struct OutlinePart {
  std::size_t area;
  bool holds_reference{false};
  std::vector<OutlineLine> lines{};
};

/// A cell that the outlines of several areas cross.
struct Seam {
  std::size_t cell;
  std::vector<OutlinePart> parts{};  // one for each area
};

/// The part of the line from a to b inside the box; empty if there is none.
std::optional<OutlineLine> clipped(geo::PlanePoint a, geo::PlanePoint b, const plane::PlaneBox& box) {
  double from = 0.0;
  double to = 1.0;
  const auto keep_between = [&](double start, double step, double low, double high) {
    if (step == 0.0) return start >= low && start <= high;
    const double at_low = (low - start) / step;
    const double at_high = (high - start) / step;
    from = std::max(from, std::min(at_low, at_high));
    to = std::min(to, std::max(at_low, at_high));
    return from < to;
  };
  if (!keep_between(a.x_m, b.x_m - a.x_m, box.low.x_m, box.high.x_m) ||
      !keep_between(a.y_m, b.y_m - a.y_m, box.low.y_m, box.high.y_m))
    return std::nullopt;
  return OutlineLine{plane::place_between(a, b, from), plane::place_between(a, b, to)};
}

double distance_to(const OutlineLine& line, geo::PlanePoint point) {
  const double dx = line.to.x_m - line.from.x_m;
  const double dy = line.to.y_m - line.from.y_m;
  const double square = dx * dx + dy * dy;
  const double along = (point.x_m - line.from.x_m) * dx + (point.y_m - line.from.y_m) * dy;
  const double share = square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
  return geo::distance_m(point, plane::place_between(line.from, line.to, share));
}

/// Decides whether the areas of a seam together contain the whole cell. They do if just beside every line, on
/// both sides, some area contains the place.
class SeamJudge {
 public:
  explicit SeamJudge(std::stop_token stop) : stop_{std::move(stop)} {}

  bool hold_all(const Seam& seam, const plane::PlaneBox& cell, geo::PlanePoint reference) {
    const auto is_clear = [&](const OutlinePart& part) {
      return std::ranges::all_of(
          part.lines, [&](const OutlineLine& line) { return distance_to(line, reference) > nothing_m; });
    };
    if (left_ < 0 || std::ranges::none_of(seam.parts, &OutlinePart::holds_reference)) return false;
    if (!std::ranges::all_of(seam.parts, is_clear)) return false;
    return std::ranges::all_of(seam.parts, [&](const OutlinePart& part) {
      return std::ranges::all_of(
          part.lines, [&](const OutlineLine& line) { return held_beside(line, seam, cell, reference); });
    });
  }

 private:
  bool held_beside(const OutlineLine& line, const Seam& seam, const plane::PlaneBox& cell,
                   geo::PlanePoint reference) {
    const double length_m = geo::distance_m(line.from, line.to);
    if (length_m <= 0.0) return true;
    const double x_m = -plane::touching_m * (line.to.y_m - line.from.y_m) / length_m;
    const double y_m = plane::touching_m * (line.to.x_m - line.from.x_m) / length_m;
    for (const double side : {1.0, -1.0}) {
      const auto beside = clipped({line.from.x_m + side * x_m, line.from.y_m + side * y_m},
                                  {line.to.x_m + side * x_m, line.to.y_m + side * y_m}, cell);
      if (beside && !held_along(*beside, seam, reference)) return false;
    }
    return true;
  }

  bool held_along(const OutlineLine& way, const Seam& seam, geo::PlanePoint reference) {
    std::vector<double> shares{0.0, 1.0};
    for (const OutlinePart& part : seam.parts) {
      left_ -= static_cast<std::int64_t>(part.lines.size());
      for (const OutlineLine& line : part.lines)
        if (const auto share = plane::crossing(way.from, way.to, line.from, line.to))
          shares.push_back(*share);
    }
    if (left_ < 0 || stop_.stop_requested()) return false;
    std::ranges::sort(shares);
    const double length_m = geo::distance_m(way.from, way.to);
    for (std::size_t i = 1; i < shares.size(); ++i) {
      const bool is_between_two = i > 1 && i + 1 < shares.size();
      const double stretch_m = (shares[i] - shares[i - 1]) * length_m;
      if (stretch_m <= (is_between_two ? plane::touching_m : nothing_m)) continue;
      const geo::PlanePoint middle =
          plane::place_between(way.from, way.to, 0.5 * (shares[i - 1] + shares[i]));
      if (!held(middle, seam, reference)) return false;
    }
    return true;
  }

  /// Whether some area contains the point: from the reference, each crossing of an outline changes between
  /// inside and outside.
  bool held(geo::PlanePoint point, const Seam& seam, geo::PlanePoint reference) {
    return std::ranges::any_of(seam.parts, [&](const OutlinePart& part) {
      left_ -= static_cast<std::int64_t>(part.lines.size());
      bool inside = part.holds_reference;
      for (const OutlineLine& line : part.lines)
        if (plane::crossing(reference, point, line.from, line.to)) inside = !inside;
      return inside;
    });
  }

  std::stop_token stop_;
  std::int64_t left_{most_line_tests};
};

/// A raster whose cell centres serve as reference points for the cells of `raster`. They lie slightly off the
/// centres of these cells: through the centres themselves outlines may run that were drawn around the same
/// place.
plane::PlaneRaster references_of(const plane::PlaneRaster& raster) {
  const double cell_m = raster.cell_m();
  const geo::PlanePoint low{raster.area().low.x_m + 0.0618 * cell_m, raster.area().low.y_m + 0.0382 * cell_m};
  const geo::PlanePoint high{low.x_m + (static_cast<double>(raster.nx()) - 0.5) * cell_m,
                             low.y_m + (static_cast<double>(raster.ny()) - 0.5) * cell_m};
  return {{low, high}, core::Metres{cell_m}};
}

plane::PlaneBox box_of_cell(std::size_t cell, const plane::PlaneRaster& raster) {
  const auto column = static_cast<double>(static_cast<std::int64_t>(cell) % raster.nx());
  const auto row = static_cast<double>(static_cast<std::int64_t>(cell) / raster.nx());
  const double cell_m = raster.cell_m();
  const geo::PlanePoint low{raster.area().low.x_m + column * cell_m, raster.area().low.y_m + row * cell_m};
  return {low, {low.x_m + cell_m, low.y_m + cell_m}};
}

/// Finds the cells of a raster where outlines meet, and decides which of them the areas contain completely.
class Seams {
 public:
  /// `cells` must be ascending. The raster and the projection are borrowed.
  Seams(std::vector<std::size_t> cells, const plane::PlaneRaster& raster,
        const geo::LocalProjection& projection)
      : raster_{raster}, references_{references_of(raster)}, projection_{projection} {
    for (const std::size_t cell : cells) seams_.push_back({cell});
  }

  void add(std::size_t area, const geo::Polygon& polygon) {
    const plane::PlaneBox reach = raster_.area().grown(raster_.cell_m());
    const auto add_line = [&](geo::PlanePoint a, geo::PlanePoint b) {
      plane::PlaneBox box{a, a};
      box.include(b);
      if (!plane::overlap(box, reach)) return;
      raster_.for_each_cell(a, b, [&](std::int64_t ix, std::int64_t iy) {
        if (Seam* seam = raster_.holds(ix, iy) ? find(raster_.index(ix, iy)) : nullptr)
          part_of(*seam, area).lines.push_back({a, b});
        return true;
      });
    };
    plane::for_each_coast_line(polygon.outer, projection_, add_line);
    for (const geo::Ring& hole : polygon.holes) plane::for_each_coast_line(hole, projection_, add_line);

    const auto hold_reference = [&](std::size_t cell) {
      if (Seam* seam = find(cell)) part_of(*seam, area).holds_reference = true;
    };
    plane::visit_cells(polygon, references_, projection_, hold_reference, [](std::size_t) {});
  }

  void judge(std::vector<bool>& held, const std::stop_token& stop) const {
    SeamJudge judge{stop};
    for (const Seam& seam : seams_) {
      if (stop.stop_requested()) return;
      const plane::PlaneBox reference = box_of_cell(seam.cell, references_);
      held[seam.cell] = judge.hold_all(seam, box_of_cell(seam.cell, raster_),
                                       plane::place_between(reference.low, reference.high, 0.5));
    }
  }

 private:
  Seam* find(std::size_t cell) {
    const auto at = std::ranges::lower_bound(seams_, cell, {}, &Seam::cell);
    return at != seams_.end() && at->cell == cell ? &*at : nullptr;
  }
  static OutlinePart& part_of(Seam& seam, std::size_t area) {
    if (seam.parts.empty() || seam.parts.back().area != area) seam.parts.push_back({area});
    return seam.parts.back();
  }

  const plane::PlaneRaster& raster_;
  plane::PlaneRaster references_;
  const geo::LocalProjection& projection_;
  std::vector<Seam> seams_{};
};

}  // namespace

std::vector<bool> cells_to_stay_in(const std::vector<geo::Polygon>& areas, const plane::PlaneRaster& raster,
                                   const geo::LocalProjection& projection, const std::stop_token& stop) {
  std::vector<bool> held(raster.size(), false);
  std::vector<bool> on_an_outline(raster.size(), false);
  std::vector<bool> on_several(raster.size(), false);
  std::vector<bool> within(raster.size(), false);
  for (const geo::Polygon& area : areas) {
    if (stop.stop_requested()) return held;
    std::size_t first = raster.size();
    std::size_t last = 0;
    std::vector<std::size_t> outline;
    const auto enter = [&](std::size_t cell) {
      within[cell] = true;
      first = std::min(first, cell);
      last = std::max(last, cell);
    };
    const auto leave = [&](std::size_t cell) {
      within[cell] = false;
      outline.push_back(cell);
    };
    plane::visit_cells(area, raster, projection, enter, leave);
    for (std::size_t cell = first; cell <= last && cell < raster.size(); ++cell) {
      if (within[cell]) held[cell] = true;
      within[cell] = false;
    }
    std::ranges::sort(outline);
    outline.erase(std::ranges::unique(outline).begin(), outline.end());
    for (const std::size_t cell : outline) {
      if (on_an_outline[cell]) on_several[cell] = true;
      on_an_outline[cell] = true;
    }
  }

  std::vector<std::size_t> undecided;
  for (std::size_t cell = 0; cell < held.size(); ++cell)
    if (on_several[cell] && !held[cell]) undecided.push_back(cell);
  if (undecided.empty()) return held;
  Seams seams{std::move(undecided), raster, projection};
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (stop.stop_requested()) return held;
    seams.add(i, areas[i]);
  }
  seams.judge(held, stop);
  return held;
}

}  // namespace floeplan::planning::obstacles
