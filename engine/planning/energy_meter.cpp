#include "engine/planning/energy_meter.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace floeplan::planning {

EnergyMeter::EnergyMeter(const Sea& sea, const motion::PlaneEdge& edge, core::Seconds depart,
                         vehicle::Drive drive)
    : sea_{sea},
      edge_{edge},
      drive_{drive},
      looks_up_{(sea.ice() && sea.ice()->may_be_dense_along(edge.from, edge.to)) ||
                sea.icebergs().may_pass_under()},
      is_even_{!looks_up_ && sea.energy().is_even_along(edge.from, edge.to)},
      here_{edge.from},
      now_s_{depart.count()} {}

void EnergyMeter::add(const motion::EdgePiece& piece) {
  if (is_even_) return;
  const double most_deviation_m = 0.002 * sea_.energy().cell().value;
  motion::follow_piece(edge_, piece, most_deviation_m,
                       [&](const motion::EvenMove& move, double) -> std::optional<motion::EdgeClosed> {
                         drawn_ += use(move);
                         here_ = move.to;
                         now_s_ = move.t1_s;
                         return std::nullopt;
                       });
}

EnergyUse EnergyMeter::until(core::Seconds end) const {
  EnergyUse drawn = drawn_;
  drawn += use({here_, edge_.to, now_s_, end.count()});
  return drawn;
}

EnergyUse EnergyMeter::use(const motion::EvenMove& move) const {
  constexpr double most_looks = 4096.0;
  const core::Seconds time{move.t1_s - move.t0_s};
  if (!looks_up_) return sea_.energy().use(move.from, move.to, time, drive_);
  const double wanted = std::ceil(geo::distance_m(move.from, move.to) / sea_.surfacing_look().value);
  const int looks = static_cast<int>(std::clamp(wanted, 1.0, most_looks));
  const auto at = [&](double share) {
    return geo::PlanePoint{move.from.x_m + share * (move.to.x_m - move.from.x_m),
                           move.from.y_m + share * (move.to.y_m - move.from.y_m)};
  };
  EnergyUse drawn;
  for (int i = 0; i < looks; ++i) {
    const double middle = (i + 0.5) / looks;
    const core::Metres upper_turn =
        sea_.least_upper_turn(at(middle), core::Seconds{move.t0_s} + middle * time);
    drawn += sea_.energy().use(at(static_cast<double>(i) / looks), at((i + 1.0) / looks),
                               (1.0 / looks) * time, drive_, upper_turn);
  }
  return drawn;
}

}  // namespace floeplan::planning
