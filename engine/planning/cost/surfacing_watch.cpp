#include "engine/planning/cost/surfacing_watch.hpp"

#include <algorithm>

#include "engine/motion/drive_looks.hpp"

namespace floeplan::planning::cost {

std::optional<core::Seconds> since_surfacing_after_wait(const Overhead& overhead, geo::PlanePoint place,
                                                        core::Seconds from, core::Seconds until,
                                                        core::Seconds since_surfacing) {
  constexpr core::Seconds between_looks{900.0};
  constexpr core::Seconds just_now{0.0};
  if (!overhead.bounds_surfacing()) return just_now;
  const core::Seconds longest = *overhead.longest_without_surfacing();
  while (from < until) {
    const core::Seconds now = std::min(from + between_looks, until);
    const bool open = overhead.may_surface(place, now);
    const bool open_all_along = open && since_surfacing == just_now;
    if (!open_all_along) since_surfacing += now - from;
    if (since_surfacing > longest) return std::nullopt;
    if (open) since_surfacing = just_now;
    from = now;
  }
  return since_surfacing;
}

std::optional<motion::EdgeClosed> SurfacingWatch::operator()(const motion::EdgePiece& piece) {
  std::optional<motion::EdgeClosed> closed;
  const auto longest = overhead_.longest_without_surfacing();
  double now_s = piece.t0_s;
  if (overhead_.ice() && !ice_)
    ice_.emplace(*overhead_.ice(), motion::place_along(edge_, piece.way0_m), core::Seconds{piece.t0_s});
  motion::look_along(edge_, piece, overhead_.look(), [&](geo::PlanePoint point, core::Seconds time) {
    const ice::UnderIce::Leave leave = overhead_.leave(ice_, point, time);
    const bool open_all_along = leave.to_surface && since_s_ == 0.0;
    if (!open_all_along) since_s_ += time.count() - now_s;
    if (!leave.to_transit) {
      closed = motion::EdgeClosed::under_ice;
    } else if (longest && since_s_ > longest->count()) {
      closed = motion::EdgeClosed::no_surfacing;
    }
    if (leave.to_surface) since_s_ = 0.0;
    now_s = time.count();
    return !closed;
  });
  return closed;
}

SurfacingOutlook::SurfacingOutlook(const Overhead& overhead, const motion::PlaneEdge& edge,
                                   core::Seconds depart)
    : overhead_{overhead}, edge_{edge}, looks_{{depart.count(), overhead.may_surface(edge.from, depart)}} {
  if (overhead.ice()) ice_.emplace(*overhead.ice(), edge.from, depart);
}

std::optional<motion::EdgeClosed> SurfacingOutlook::operator()(const motion::EdgePiece& piece) {
  std::optional<motion::EdgeClosed> closed;
  motion::look_along(edge_, piece, overhead_.look(), [&](geo::PlanePoint point, core::Seconds time) {
    const ice::UnderIce::Leave leave = overhead_.leave(ice_, point, time);
    looks_.push_back({time.count(), leave.to_surface});
    if (!leave.to_transit) closed = motion::EdgeClosed::under_ice;
    return !closed;
  });
  return closed;
}

tl::expected<core::Seconds, motion::EdgeClosed> SurfacingOutlook::until_surfacing(
    core::Seconds at_end) const {
  const auto longest = overhead_.longest_without_surfacing();
  double until_s = at_end.count();
  for (std::size_t i = looks_.size() - 1; i-- > 0;) {
    const Look& look = looks_[i];
    const bool open_all_along = look.may_surface && until_s == 0.0;
    if (!open_all_along) until_s += looks_[i + 1].time_s - look.time_s;
    if (longest && until_s > longest->count()) return tl::unexpected(motion::EdgeClosed::no_surfacing);
    if (look.may_surface) until_s = 0.0;
  }
  return core::Seconds{until_s};
}

}  // namespace floeplan::planning::cost
