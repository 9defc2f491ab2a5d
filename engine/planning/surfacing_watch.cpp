#include "engine/planning/surfacing_watch.hpp"

#include "engine/motion/drive_looks.hpp"

namespace floeplan::planning {

std::optional<motion::EdgeClosed> SurfacingWatch::operator()(const motion::EdgePiece& piece) {
  std::optional<motion::EdgeClosed> closed;
  const auto longest = sea_.longest_without_surfacing();
  double now_s = piece.t0_s;
  motion::look_along(edge_, piece, sea_.surfacing_look(), [&](geo::PlanePoint point, core::Seconds time) {
    const UnderIce::Leave leave = sea_.leave(point, time);
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

}  // namespace floeplan::planning
