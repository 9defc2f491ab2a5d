#include "engine/planning/cost/energy_meter.hpp"

#include <algorithm>
#include <cmath>

#include "engine/planning/plane/plane_lines.hpp"

namespace floeplan::planning::cost {
namespace {

std::optional<energy::DiveLine> dives_by(Dives dives, const energy::EnergyMap& energy,
                                         const motion::PlaneEdge& edge) {
  if (dives == Dives::over_map) return std::nullopt;
  return energy.dives_along(edge.from, edge.to);
}

/// Largest allowed error in the position of the vehicle along the edge: 1/500 of a cell of the data for the
/// dives.
core::Metres most_deviation(const energy::EnergyMap& energy, Dives dives) {
  constexpr double of_cell = 0.002;
  const core::Metres cell = energy.cell();
  return of_cell * (dives == Dives::over_map ? cell : std::min(cell, energy.look()));
}

}  // namespace

EnergyMeter::EnergyMeter(const energy::EnergyMap& energy, const Overhead& overhead,
                         const motion::PlaneEdge& edge, core::Seconds depart, vehicle::Drive drive,
                         Dives dives)
    : energy_{energy},
      overhead_{overhead},
      edge_{edge},
      length_m_{geo::distance_m(edge.from, edge.to)},
      drive_{drive},
      looks_up_{overhead.may_be_above(edge.from, edge.to)},
      dives_{dives_by(dives, energy, edge)},
      is_even_{!looks_up_ && (dives_ ? dives_->is_even() : energy.is_even_along(edge.from, edge.to))},
      most_deviation_m_{most_deviation(energy, dives).value},
      here_{edge.from},
      now_s_{depart.count()} {}

void EnergyMeter::add(const motion::EdgePiece& piece) {
  if (is_even_) return;
  motion::follow_piece(edge_, piece, most_deviation_m_,
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

double EnergyMeter::share(geo::PlanePoint place) const {
  if (length_m_ == 0.0) return 0.0;
  return std::min(geo::distance_m(edge_.from, place) / length_m_, 1.0);
}

EnergyUse EnergyMeter::use(const motion::EvenMove& move, core::Metres upper_turn) const {
  const core::Seconds time{move.t1_s - move.t0_s};
  if (!dives_) return energy_.use(move.from, move.to, time, drive_, upper_turn);
  const double from = share(move.from);
  const vehicle::DiveBand band = dives_->mean_band(from, std::max(from, share(move.to)), upper_turn);
  return energy_.use(band, time, drive_);
}

EnergyUse EnergyMeter::use(const motion::EvenMove& move) const {
  constexpr double most_looks = 4096.0;
  if (!looks_up_) return use(move, {});
  const core::Seconds time{move.t1_s - move.t0_s};
  const double wanted = std::ceil(geo::distance_m(move.from, move.to) / overhead_.look().value);
  const int looks = static_cast<int>(std::clamp(wanted, 1.0, most_looks));
  const auto at = [&](double part) { return plane::place_between(move.from, move.to, part); };
  EnergyUse drawn;
  for (int i = 0; i < looks; ++i) {
    const double middle = (i + 0.5) / looks;
    const core::Metres upper_turn =
        overhead_.least_upper_turn(at(middle), core::Seconds{move.t0_s} + middle * time);
    const double begins_s = move.t0_s + static_cast<double>(i) / looks * time.count();
    const double ends_s = move.t0_s + (i + 1.0) / looks * time.count();
    drawn += use({at(static_cast<double>(i) / looks), at((i + 1.0) / looks), begins_s, ends_s}, upper_turn);
  }
  return drawn;
}

}  // namespace floeplan::planning::cost
