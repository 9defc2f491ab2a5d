#include "engine/planning/nearby_currents.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floeplan::planning {
namespace {

constexpr std::size_t most_reach = 8;  // in cells
// In cells, chosen: a search meets a few per cent of the data, and a smaller tile would look at more of its neighbours'
// cells than of its own.
constexpr std::size_t tile_side = 16;
constexpr std::size_t most_boxed_nodes = 1U << 23U;  // 256 MB of boxes for a voyage as long as the data
constexpr double beside_chord = 2.5e-4;  // of a cell: how far CurrentLine strays from the data's coordinates
constexpr float infinite = std::numeric_limits<float>::infinity();

double narrowest(const FastAxis& axis) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < axis.size(); ++i)
    least = std::min(least, axis.nodes()[i] - axis.nodes()[i - 1]);
  return least;
}

}  // namespace

NearbyCurrents::NearbyCurrents(const PlaneCurrents& currents, core::Metres longest_edge,
                               core::Seconds longest_drive)
    : currents_{currents}, longest_s_{longest_drive.count()} {
  const FastAxis& x = currents.x_;
  const FastAxis& y = currents.y_;
  if (!currents.has_lines() || x.size() < 2 || y.size() < 2 || currents.nodes_.size() > most_boxed_nodes)
    return;
  if (currents.times_s_ && currents.times_s_->size() < 2) return;
  cells_x_ = x.size() - 1;
  cells_y_ = y.size() - 1;

  // The table's slopes change by its bend over an edge and the steps of the table that the edge begins and ends in.
  const double edge_m = longest_edge.value;
  const geo::GridPoint bend = currents.lookup_.bend();
  const double bent_m2 = edge_m * (edge_m + currents.lookup_.step_m());
  off_line_ = {bend.x * bent_m2 + beside_chord * x.mean_step(),
               bend.y * bent_m2 + beside_chord * y.mean_step()};
  const geo::GridPoint steepest = currents.lookup_.steepest();
  const double cells_along_x = (steepest.x * edge_m + off_line_.x) / narrowest(x);
  const double cells_along_y = (steepest.y * edge_m + off_line_.y) / narrowest(y);
  if (!(std::max(cells_along_x, cells_along_y) <= static_cast<double>(most_reach))) return;
  reach_x_ = static_cast<std::size_t>(std::ceil(cells_along_x));
  reach_y_ = static_cast<std::size_t>(std::ceil(cells_along_y));
  judge_cells();
  tiles_x_ = (cells_x_ + tile_side - 1) / tile_side;
  tiles_y_ = (cells_y_ + tile_side - 1) / tile_side;
  tiles_.resize((currents.times_s_ ? currents.times_s_->size() : 1) * tiles_y_ * tiles_x_);
  useful_ = true;
}

void NearbyCurrents::judge_cells() {
  const std::size_t nx = currents_.x_.size();
  const std::size_t slice = nx * currents_.y_.size();
  const std::size_t slices = currents_.nodes_.size() / slice;
  covers_.assign(cells_x_ * cells_y_, Cover::never);
  for (std::size_t s = 0; s < slices; ++s) {
    for (std::size_t iy = 0; iy < cells_y_; ++iy) {
      const PlaneCurrents::Node* south = currents_.nodes_.data() + s * slice + iy * nx;
      for (std::size_t ix = 0; ix < cells_x_; ++ix, ++south) {
        const bool covered = !std::isnan(south[0].x_m_s) && !std::isnan(south[1].x_m_s) &&
                             !std::isnan(south[nx].x_m_s) && !std::isnan(south[nx + 1].x_m_s);
        const Cover now = covered ? Cover::always : Cover::never;
        Cover& cover = covers_[iy * cells_x_ + ix];
        cover = s == 0 || cover == now ? now : Cover::sometimes;
      }
    }
  }
}

NearbyCurrents::Box NearbyCurrents::box_of(Cell cell, std::size_t slice) const {
  const auto [ix, iy] = cell;
  const Cover cover = covers_[iy * cells_x_ + ix];
  if (cover == Cover::never)
    return {{infinite, infinite, infinite, infinite}, {-infinite, -infinite, -infinite, -infinite}};
  if (cover == Cover::sometimes)
    return {{-infinite, -infinite, -infinite, -infinite}, {infinite, infinite, infinite, infinite}};

  const std::size_t nx = currents_.x_.size();
  const PlaneCurrents::Node* south = currents_.nodes_.data() + (slice * currents_.y_.size() + iy) * nx + ix;
  const PlaneCurrents::Node* north = south + nx;
  const auto per_u = static_cast<float>(currents_.x_.inverse_width(ix));
  const auto per_v = static_cast<float>(currents_.y_.inverse_width(iy));
  const std::array<float, 4> one{
      (south[1].x_m_s - south[0].x_m_s) * per_u, (south[1].y_m_s - south[0].y_m_s) * per_u,
      (north[0].x_m_s - south[0].x_m_s) * per_v, (north[0].y_m_s - south[0].y_m_s) * per_v};
  const std::array<float, 4> other{
      (north[1].x_m_s - north[0].x_m_s) * per_u, (north[1].y_m_s - north[0].y_m_s) * per_u,
      (north[1].x_m_s - south[1].x_m_s) * per_v, (north[1].y_m_s - south[1].y_m_s) * per_v};
  Box box{};
  for (std::size_t i = 0; i < 4; ++i) {
    box.low[i] = std::min(one[i], other[i]);
    box.high[i] = std::max(one[i], other[i]);
  }
  return box;
}

std::vector<NearbyCurrents::Box> NearbyCurrents::boxes_of_tile(Cell first, std::size_t slice) {
  const auto include = [](Box& box, const Box& more) {
    for (std::size_t i = 0; i < 4; ++i) {
      box.low[i] = std::min(box.low[i], more.low[i]);
      box.high[i] = std::max(box.high[i], more.high[i]);
    }
  };
  const auto before = [](std::size_t at, std::size_t reach) { return at < reach ? 0 : at - reach; };
  const Cell end{std::min(first.x + tile_side, cells_x_), std::min(first.y + tile_side, cells_y_)};
  const Cell seen_first{before(first.x, reach_x_), before(first.y, reach_y_)};
  const Cell seen_end{std::min(end.x + reach_x_, cells_x_), std::min(end.y + reach_y_, cells_y_)};

  own_.clear();
  rows_.clear();
  for (std::size_t y = seen_first.y; y < seen_end.y; ++y) {
    const std::size_t row = own_.size();
    for (std::size_t x = seen_first.x; x < seen_end.x; ++x) own_.push_back(box_of({x, y}, slice));
    for (std::size_t x = first.x; x < end.x; ++x) {
      const std::size_t from = before(x, reach_x_);
      const std::size_t to = std::min(x + reach_x_, cells_x_ - 1);
      Box box = own_[row + from - seen_first.x];
      for (std::size_t i = from + 1; i <= to; ++i) include(box, own_[row + i - seen_first.x]);
      rows_.push_back(box);
    }
  }
  const std::size_t width = end.x - first.x;
  std::vector<Box> all;
  all.reserve(width * (end.y - first.y));
  for (std::size_t y = first.y; y < end.y; ++y) {
    const std::size_t from = before(y, reach_y_);
    const std::size_t to = std::min(y + reach_y_, cells_y_ - 1);
    for (std::size_t x = 0; x < width; ++x) {
      Box box = rows_[(from - seen_first.y) * width + x];
      for (std::size_t i = from + 1; i <= to; ++i) include(box, rows_[(i - seen_first.y) * width + x]);
      all.push_back(box);
    }
  }
  return all;
}

const NearbyCurrents::Box& NearbyCurrents::box_about(Cell cell, std::size_t slice) {
  const Cell tile{cell.x / tile_side, cell.y / tile_side};
  const Cell first{tile.x * tile_side, tile.y * tile_side};
  std::vector<Box>& boxes = tiles_[(slice * tiles_y_ + tile.y) * tiles_x_ + tile.x];
  if (boxes.empty()) boxes = boxes_of_tile(first, slice);
  const std::size_t width = std::min(tile_side, cells_x_ - first.x);
  return boxes[(cell.y - first.y) * width + cell.x - first.x];
}

std::optional<NearbyCurrents::Place> NearbyCurrents::place(geo::PlanePoint point) const {
  const GridLookup::Surroundings around = currents_.lookup_.around(point);
  const auto x = currents_.x_.locate(around.at.x);
  const auto y = currents_.y_.locate(around.at.y);
  if (!x || !y) return std::nullopt;
  if (covers_[y->cell * cells_x_ + x->cell] != Cover::always) return std::nullopt;
  return Place{around, {x->cell, y->cell}, y->cell * currents_.x_.size() + x->cell, x->share, y->share};
}

motion::CurrentXy NearbyCurrents::at(const Place& place, std::size_t slice) const {
  const std::size_t nx = currents_.x_.size();
  const PlaneCurrents::Node* sw = currents_.nodes_.data() + slice * nx * currents_.y_.size() + place.first;
  const PlaneCurrents::Node* nw = sw + nx;
  const auto mix = [&](float a, float b, float c, float d) {
    const double south = static_cast<double>(a) + place.fx * static_cast<double>(b - a);
    const double north = static_cast<double>(c) + place.fx * static_cast<double>(d - c);
    return south + place.fy * (north - south);
  };
  return {mix(sw[0].x_m_s, sw[1].x_m_s, nw[0].x_m_s, nw[1].x_m_s),
          mix(sw[0].y_m_s, sw[1].y_m_s, nw[0].y_m_s, nw[1].y_m_s)};
}

bool NearbyCurrents::enclose(motion::NearbyCurrent& near, const Place& place, std::size_t first,
                             std::size_t last, float sign) {
  Box box = box_about(place.cell, first);
  for (std::size_t slice = first + 1; slice <= last; ++slice) {
    const Box& more = box_about(place.cell, slice);
    for (std::size_t i = 0; i < 4; ++i) {
      box.low[i] = std::min(box.low[i], more.low[i]);
      box.high[i] = std::max(box.high[i], more.high[i]);
    }
  }
  std::array<float, 4> centre{};
  std::array<float, 4> half{};
  for (std::size_t i = 0; i < 4; ++i) {
    centre[i] = sign * 0.5F * (box.low[i] + box.high[i]);
    half[i] = 0.5F * (box.high[i] - box.low[i]);
  }
  near.u_x = static_cast<float>(place.around.per_x_m.x);
  near.u_y = static_cast<float>(place.around.per_y_m.x);
  near.v_x = static_cast<float>(place.around.per_x_m.y);
  near.v_y = static_cast<float>(place.around.per_y_m.y);
  near.x_by_u = centre[0];
  near.y_by_u = centre[1];
  near.x_by_v = centre[2];
  near.y_by_v = centre[3];
  near.off_by_u = std::sqrt(half[0] * half[0] + half[1] * half[1]);
  near.off_by_v = std::sqrt(half[2] * half[2] + half[3] * half[3]);
  const float steepest_u = std::sqrt(centre[0] * centre[0] + centre[1] * centre[1]) + near.off_by_u;
  const float steepest_v = std::sqrt(centre[2] * centre[2] + centre[3] * centre[3]) + near.off_by_v;
  near.unseen_m_s =
      steepest_u * static_cast<float>(off_line_.x) + steepest_v * static_cast<float>(off_line_.y);
  return std::isfinite(near.unseen_m_s);
}

std::optional<motion::NearbyCurrent> NearbyCurrents::on_film(geo::PlanePoint point, core::Seconds time,
                                                             Film film) {
  const auto here = place(point);
  if (!here) return std::nullopt;
  const double sign = film == Film::forwards ? 1.0 : -1.0;
  const auto shown = [&](std::size_t slice) {
    const motion::CurrentXy c = at(*here, slice);
    return motion::CurrentXy{sign * c.x_m_s, sign * c.y_m_s};
  };
  motion::NearbyCurrent near;
  if (!currents_.times_s_) {
    const motion::CurrentXy c = shown(0);
    near.x_m_s = static_cast<float>(c.x_m_s);
    near.y_m_s = static_cast<float>(c.y_m_s);
    near.known_s = infinite;
    return enclose(near, *here, 0, 0, static_cast<float>(sign)) ? std::optional{near} : std::nullopt;
  }
  const FastAxis& times = *currents_.times_s_;
  const auto when = times.locate(time.count());
  if (!when) return std::nullopt;

  // Steps of time as the film shows them: `slice` lies at the step's beginning, `next` at its end.
  const bool forwards = film == Film::forwards;
  const std::size_t first = forwards ? when->cell : when->cell + 1;
  const std::size_t end = forwards ? times.size() - 1 : 0;
  std::size_t slice = first;
  motion::CurrentXy from = shown(slice);
  motion::CurrentXy slope{};
  double steepest = 0.0;
  for (;;) {
    const std::size_t next = forwards ? slice + 1 : slice - 1;
    const motion::CurrentXy to = shown(next);
    const double per_s = times.inverse_width(std::min(slice, next));
    const motion::CurrentXy rise{(to.x_m_s - from.x_m_s) * per_s, (to.y_m_s - from.y_m_s) * per_s};
    const double begins_s = sign * (times.nodes()[slice] - time.count());
    if (slice == first) {
      near.x_m_s = static_cast<float>(from.x_m_s - begins_s * rise.x_m_s);
      near.y_m_s = static_cast<float>(from.y_m_s - begins_s * rise.y_m_s);
      near.x_m_s2 = static_cast<float>(rise.x_m_s);
      near.y_m_s2 = static_cast<float>(rise.y_m_s);
    } else {
      near.knot_s[near.knots] = static_cast<float>(begins_s);
      near.bend_x[near.knots] = static_cast<float>(rise.x_m_s - slope.x_m_s);
      near.bend_y[near.knots] = static_cast<float>(rise.y_m_s - slope.y_m_s);
      ++near.knots;
    }
    steepest = std::max(steepest, std::hypot(rise.x_m_s, rise.y_m_s));
    slope = rise;
    from = to;
    slice = next;
    const double known_s = sign * (times.nodes()[slice] - time.count());
    near.known_s = static_cast<float>(known_s);
    if (known_s >= longest_s_ || slice == end || near.knots == motion::NearbyCurrent::most_knots) break;
  }
  near.steepest_m_s2 = static_cast<float>(steepest);
  return enclose(near, *here, std::min(first, slice), std::max(first, slice), static_cast<float>(sign))
             ? std::optional{near}
             : std::nullopt;
}

}  // namespace floeplan::planning
