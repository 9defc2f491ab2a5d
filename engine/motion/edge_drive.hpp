#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tl/expected.hpp>
#include <type_traits>
#include <utility>

#include "engine/core/units.hpp"
#include "engine/motion/crabbing.hpp"
#include "engine/motion/edge_closed.hpp"
#include "engine/motion/edge_piece.hpp"
#include "engine/motion/runge_kutta.hpp"

namespace floeplan::motion {

/// One drive along one edge, integrated in steps of a Runge-Kutta pair.
/// The distance s is the independent variable, dt/ds = 1 / v(s, t). So the drive hits the end of the edge and
/// every border of the data exactly, and never asks for data beyond the end. A step ends where its stretch of
/// the current ends, in place or in time, so that no step crosses a kink.
/// Line   gives the stretches: `stretch()`, `begin(depart)`, `pass_way()` and `pass_time()`; the last three
///        return false where the data end
template <class Step, class Line>
class EdgeDrive {
 public:
  /// `line` is borrowed and must outlive the drive.
  EdgeDrive(Line& line, core::Metres length, core::MetresPerSecond through_water, double relative_tolerance)
      : line_{line},
        crabbing_{through_water},
        length_{length.value},
        shortest_{1e-6 * length.value},
        tolerance_{Step::share_for_a_step * relative_tolerance} {}

  template <EdgePieceVisitor VisitPiece>
  tl::expected<core::Seconds, EdgeClosed> run(core::Seconds depart, core::Seconds latest,
                                              const VisitPiece& visit_piece) {
    if (!line_.begin(depart)) return tl::unexpected(EdgeClosed::outside_data);
    const auto first = slowness(0.0, depart.count());
    if (!first) return tl::unexpected(first.error());
    here_ = {0.0, depart.count(), *first};

    while (here_.way_m < length_) {
      const auto tried = next_step();
      if (!tried) return tl::unexpected(tried.error());
      const bool outlasts_stretch = here_.t_s + tried->gain > line_.stretch().end_s;
      const auto step = outlasts_stretch ? cut_by_time(*tried) : tried;
      if (!step) return tl::unexpected(step.error());

      const Position end = end_of(*step);
      if (end.t_s > latest.count()) return tl::unexpected(EdgeClosed::too_late);
      if (!stays_open(*step, end)) return tl::unexpected(EdgeClosed::current_too_strong);
      if (end.t_s > here_.t_s) {  // a step that begins at a border may have no length
        const EdgePiece piece{here_.t_s, here_.way_m, 1.0 / here_.slowness_s_m,
                              end.t_s,   end.way_m,   1.0 / end.slowness_s_m};
        if (const auto closed = visit_piece(piece)) return tl::unexpected(*closed);
      }
      if (!move_to(end, outlasts_stretch)) return tl::unexpected(EdgeClosed::outside_data);
    }
    return core::Seconds{here_.t_s} - depart;
  }

 private:
  using Stretch = std::remove_cvref_t<decltype(std::declval<Line&>().stretch())>;

  struct Position {
    double way_m{};
    double t_s{};
    double slowness_s_m{};
  };

  [[gnu::always_inline]] tl::expected<double, EdgeClosed> slowness(double way_m, double t_s) {
    const auto c = line_.stretch().at(way_m, t_s);
    if (!c) return tl::unexpected(EdgeClosed::outside_data);
    if constexpr (!Stretch::is_bounded) {
      latest_room_ = crabbing_.room(*c);
      least_room_ = std::min(least_room_, latest_room_);
      most_room_ = std::max(most_room_, latest_room_);
    }
    const auto result = crabbing_.slowness(*c);
    if (!result) return tl::unexpected(EdgeClosed::current_too_strong);
    return *result;
  }

  /// The longest step within the tolerance, within the stretch's distances, and hardly beyond its times.
  tl::expected<Step, EdgeClosed> next_step() {
    constexpr double beyond_time = 1.25;  // so that a vehicle that slows by a fifth still reaches the end
    const double to_end = std::min(line_.stretch().end_way_m, length_) - here_.way_m;
    const double to_time = beyond_time * (line_.stretch().end_s - here_.t_s) / here_.slowness_s_m;
    const auto k = [this](double way_m, double t_s) { return slowness(way_m, t_s); };
    least_room_ = most_room_ = latest_room_;
    for (;;) {
      const double h = std::min(std::max(std::min(wish_m_, to_time), shortest_), to_end);
      const auto step = Step::step(k, here_.way_m, here_.t_s, h, here_.slowness_s_m);
      if (!step || !(step->gain > 0.0)) {
        // The tested points lie ahead of the vehicle. Only if they fail at the shortest step is the edge
        // closed.
        if (h <= shortest_) return tl::unexpected(step ? EdgeClosed::current_too_strong : step.error());
        wish_m_ = 0.25 * h;
        continue;
      }
      const double allowed = tolerance_ * step->gain;
      if (step->error > allowed && h > shortest_) {
        wish_m_ = h * std::clamp(0.9 * Step::lengthening(allowed / step->error), 0.2, 0.9);
        continue;
      }
      if (h >= wish_m_) {
        // For an error below a hundredth of the allowed one the step quadruples in any case, so no root is
        // needed.
        const bool is_easy = 100.0 * step->error <= allowed;
        wish_m_ = h * (is_easy ? 4.0 : std::clamp(0.9 * Step::lengthening(allowed / step->error), 0.5, 4.0));
      }
      return step;
    }
  }

  /// Shortens the step to the end of the stretch's time, if that comes before the step's end.
  tl::expected<Step, EdgeClosed> cut_by_time(const Step& tried) {
    const double left_s = line_.stretch().end_s - here_.t_s;
    double h = tried.h * share_with_gain(tried, left_s);
    if constexpr (Step::is_its_cubic) {
      const auto k_end = slowness(here_.way_m + h, here_.t_s + left_s);
      if (!k_end) return tl::unexpected(k_end.error());
      return Step{{h, left_s, here_.slowness_s_m, *k_end}, tried.error};
    } else {
      // An end close to the border suffices: the kink there adds an error of second order only.
      const auto k = [this](double way_m, double t_s) { return slowness(way_m, t_s); };
      const double near_enough_s = 0.01 * std::sqrt(tolerance_) * left_s;
      for (int tries = 0;; ++tries) {
        const auto step = Step::step(k, here_.way_m, here_.t_s, h, here_.slowness_s_m);
        if (!step || tries == 5 || std::abs(left_s - step->gain) <= near_enough_s) return step;
        h = std::clamp(h + (left_s - step->gain) / step->k_end, 0.0, tried.h);
      }
    }
  }

  Position end_of(const Step& step) const {
    const double end_way = std::min(line_.stretch().end_way_m, length_);
    const bool reaches_end = step.h >= end_way - here_.way_m;
    return {reaches_end ? end_way : here_.way_m + step.h, here_.t_s + step.gain, step.k_end};
  }

  /// Whether the current leaves the edge open all the way from here to `end`, also between the tested points.
  bool stays_open(const Step& step, const Position& end) const {
    if constexpr (!Stretch::is_bounded) {
      // The current is smooth on this scale: between the tested points its room differs by less than between
      // them.
      if (2.0 * least_room_ > most_room_) return true;
    }
    constexpr int halvings = 12;
    return stays_open(step, here_.way_m, here_.t_s, end.way_m, end.t_s, halvings);
  }

  bool stays_open(const Step& step, double way0_m, double t0_s, double way1_m, double t1_s,
                  int halvings) const {
    constexpr double resolution_m_s = 1e-7;  // far below the accuracy of any current
    const double least = line_.stretch().least_room(crabbing_, way0_m, t0_s, way1_m, t1_s);
    if (least > 0.0) return true;
    const double way_m = 0.5 * (way0_m + way1_m);
    const double t_s = here_.t_s + step.gain_at((way_m - here_.way_m) / step.h);
    const auto c = line_.stretch().at(way_m, t_s);
    const double room = c ? crabbing_.room(*c) : 0.0;
    if (!(room > 0.0)) return false;
    if (halvings == 0 || room - least < resolution_m_s) return true;
    return stays_open(step, way0_m, t0_s, way_m, t_s, halvings - 1) &&
           stays_open(step, way_m, t_s, way1_m, t1_s, halvings - 1);
  }

  bool move_to(const Position& end, bool outlasts_stretch) {
    const double end_way_m = line_.stretch().end_way_m;
    here_ = end;
    if (end.way_m >= length_) return true;
    if (outlasts_stretch && !line_.pass_time()) return false;
    return end.way_m < end_way_m || line_.pass_way();
  }

  Line& line_;
  Crabbing crabbing_;
  double length_;
  double shortest_;  // shortest step, on the ground
  double tolerance_;
  Position here_;
  double wish_m_{std::numeric_limits<double>::infinity()};  // next step that the tolerance would allow

  // For a current known point by point: its room at the last point, and its least and largest room in the
  // tested step.
  double latest_room_{};
  double least_room_{};
  double most_room_{};
};

}  // namespace floeplan::motion
