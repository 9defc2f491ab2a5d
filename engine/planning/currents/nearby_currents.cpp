#include "engine/planning/currents/nearby_currents.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floeplan::planning::currents {
namespace {

constexpr std::size_t most_reach = 16;  // in cells
constexpr std::size_t tile_side = 16;   // in cells; a choice: one search needs a few per cent of the data
constexpr std::size_t most_boxed_nodes = 1U << 23U;  // 256 MB of boxes
constexpr double beside_chord = 2.5e-4;  // of a cell: error of CurrentLine in the data's coordinates
constexpr float infinite = std::numeric_limits<float>::infinity();

double narrowest(const plane::FastAxis& axis) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < axis.size(); ++i)
    least = std::min(least, axis.nodes()[i] - axis.nodes()[i - 1]);
  return least;
}

}  // namespace

NearbyCurrents::NearbyCurrents(const PlaneCurrents& currents, core::Metres longest_edge,
                               core::Seconds longest_drive)
    : currents_{currents}, longest_s_{longest_drive.count()} {
  const plane::FastAxis& x = currents.x_;
  const plane::FastAxis& y = currents.y_;
  if (!currents.has_lines() || x.size() < 2 || y.size() < 2 || currents.nodes_.size() > most_boxed_nodes)
    return;
  if (currents.times_s_ && currents.times_s_->size() < 2) return;
  cells_x_ = x.size() - 1;
  cells_y_ = y.size() - 1;

  // The slopes of the lookup table change by its bend, over the edge's length and the table steps at its two
  // ends.
  const double edge_m = longest_edge.value;
  const geo::GridPoint bend = currents.lookup_.bend();
  const double bent_m2 = edge_m * (edge_m + currents.lookup_.step_m());
  off_line_ = {bend.x * bent_m2 + beside_chord * x.mean_step(),
               bend.y * bent_m2 + beside_chord * y.mean_step()};
  const geo::GridPoint steepest = currents.lookup_.steepest();
  narrowest_ = {narrowest(x), narrowest(y)};
  reach_ = {steepest.x * edge_m + off_line_.x, steepest.y * edge_m + off_line_.y};
  const double cells = std::max(reach_.x / narrowest_.x, reach_.y / narrowest_.y);
  if (!(cells <= static_cast<double>(most_reach))) return;
  judge_cells();
  slices_met_ = slices_met();
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

void NearbyCurrents::Box::include(const Box& more) {
  for (std::size_t i = 0; i < low.size(); ++i) {
    low[i] = std::min(low[i], more.low[i]);
    high[i] = std::max(high[i], more.high[i]);
  }
}

std::size_t NearbyCurrents::slices_met() const {
  if (!currents_.times_s_) return 1;
  const std::vector<double>& times_s = currents_.times_s_->nodes();
  std::size_t most_inside = 0;
  for (std::size_t first = 0, end = 0; first < times_s.size(); ++first) {
    while (end < times_s.size() && times_s[end] - times_s[first] < longest_s_) ++end;
    most_inside = std::max(most_inside, end - first);
  }
  return most_inside + 2;  // one more slice before and one after
}

std::vector<NearbyCurrents::Box> NearbyCurrents::boxes_of_tile(Cell first, std::size_t first_slice) const {
  const Cell end{std::min(first.x + tile_side, cells_x_), std::min(first.y + tile_side, cells_y_)};
  const std::size_t slices = currents_.times_s_ ? currents_.times_s_->size() : 1;
  const std::size_t end_slice = std::min(first_slice + slices_met_, slices);
  std::vector<Box> boxes;
  boxes.reserve((end.x - first.x) * (end.y - first.y));
  for (std::size_t y = first.y; y < end.y; ++y) {
    for (std::size_t x = first.x; x < end.x; ++x) {
      Box box = box_of({x, y}, first_slice);
      for (std::size_t slice = first_slice + 1; slice < end_slice; ++slice)
        box.include(box_of({x, y}, slice));
      boxes.push_back(box);
    }
  }
  return boxes;
}

const NearbyCurrents::Box& NearbyCurrents::box_from(Cell cell, std::size_t first_slice) {
  const Cell tile{cell.x / tile_side, cell.y / tile_side};
  const Cell first{tile.x * tile_side, tile.y * tile_side};
  std::vector<Box>& boxes = tiles_[(first_slice * tiles_y_ + tile.y) * tiles_x_ + tile.x];
  if (boxes.empty()) boxes = boxes_of_tile(first, first_slice);
  const std::size_t width = std::min(tile_side, cells_x_ - first.x);
  return boxes[(cell.y - first.y) * width + cell.x - first.x];
}

NearbyCurrents::Spans NearbyCurrents::spans(const plane::FastAxis& axis, std::size_t cell, double share,
                                            double reach, double off_line, double narrowest) {
  const double width = 1.0 / axis.inverse_width(cell);
  const auto cells_beyond = [&](double distance, double to_border) {
    return distance < to_border ? std::size_t{0}
                                : static_cast<std::size_t>((distance - to_border) / narrowest) + 1;
  };
  const auto span = [&](double down, double up) {
    const std::size_t before = cells_beyond(down, share * width);
    return Span{cell < before ? 0 : cell - before,
                std::min(cell + cells_beyond(up, (1.0 - share) * width), axis.size() - 2)};
  };
  return {.up = span(off_line, reach), .down = span(reach, off_line)};
}

NearbyCurrents::Quarters NearbyCurrents::boxes_about(const Place& place, std::size_t first_slice) {
  using motion::NearbyCurrent;
  constexpr Box none{{infinite, infinite, infinite, infinite}, {-infinite, -infinite, -infinite, -infinite}};
  const Spans x = spans(currents_.x_, place.cell.x, place.fx, reach_.x, off_line_.x, narrowest_.x);
  const Spans y = spans(currents_.y_, place.cell.y, place.fy, reach_.y, off_line_.y, narrowest_.y);
  Quarters quarters;
  quarters.fill(none);
  for (std::size_t row = y.down.from; row <= y.up.to; ++row) {
    Box down = none;
    Box up = none;
    for (std::size_t column = x.down.from; column <= x.up.to; ++column) {
      const Box& box = box_from({column, row}, first_slice);
      if (column <= x.down.to) down.include(box);
      if (column >= x.up.from) up.include(box);
    }
    if (row >= y.up.from) {
      quarters[NearbyCurrent::quarter(false, false)].include(up);
      quarters[NearbyCurrent::quarter(true, false)].include(down);
    }
    if (row <= y.down.to) {
      quarters[NearbyCurrent::quarter(false, true)].include(up);
      quarters[NearbyCurrent::quarter(true, true)].include(down);
    }
  }
  return quarters;
}

std::optional<NearbyCurrents::Place> NearbyCurrents::place(geo::PlanePoint point) const {
  const plane::GridLookup::Surroundings around = currents_.lookup_.around(point);
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

bool NearbyCurrents::enclose(motion::NearbyCurrent& near, const Place& place, std::size_t first_slice,
                             float sign) {
  near.u_x = static_cast<float>(place.around.per_x_m.x);
  near.u_y = static_cast<float>(place.around.per_y_m.x);
  near.v_x = static_cast<float>(place.around.per_x_m.y);
  near.v_y = static_cast<float>(place.around.per_y_m.y);
  const Quarters boxes = boxes_about(place, first_slice);
  for (std::size_t q = 0; q < boxes.size(); ++q) {
    std::array<float, 4> centre{};
    std::array<float, 4> half{};
    for (std::size_t i = 0; i < 4; ++i) {
      centre[i] = sign * 0.5F * (boxes[q].low[i] + boxes[q].high[i]);
      half[i] = 0.5F * (boxes[q].high[i] - boxes[q].low[i]);
    }
    near.x_by_u[q] = centre[0];
    near.y_by_u[q] = centre[1];
    near.x_by_v[q] = centre[2];
    near.y_by_v[q] = centre[3];
    near.off_by_u[q] = std::sqrt(half[0] * half[0] + half[1] * half[1]);
    near.off_by_v[q] = std::sqrt(half[2] * half[2] + half[3] * half[3]);
    const float steepest_u = std::sqrt(centre[0] * centre[0] + centre[1] * centre[1]) + near.off_by_u[q];
    const float steepest_v = std::sqrt(centre[2] * centre[2] + centre[3] * centre[3]) + near.off_by_v[q];
    const float unseen =
        steepest_u * static_cast<float>(off_line_.x) + steepest_v * static_cast<float>(off_line_.y);
    if (!std::isfinite(unseen)) return false;
    near.unseen_m_s = std::max(near.unseen_m_s, unseen);
  }
  return true;
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
    return enclose(near, *here, 0, static_cast<float>(sign)) ? std::optional{near} : std::nullopt;
  }
  const plane::FastAxis& times = *currents_.times_s_;
  const auto when = times.locate(time.count());
  if (!when) return std::nullopt;

  // Time steps in the direction of the search: it enters a step at `slice` and leaves it at `next`.
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
  return enclose(near, *here, std::min(first, slice), static_cast<float>(sign)) ? std::optional{near}
                                                                                : std::nullopt;
}

}  // namespace floeplan::planning::currents
