#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/messages/message.hpp"
#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/grid/open_grid.hpp"
#include "engine/planning/search/grid/search_outcome.hpp"

namespace floeplan::planning::search {

/// A part of a route that is longer than it need be, only because something further on opens later: the vehicle could
/// as well stay at its beginning and then go straight to its end.
struct TimeKilled {
  std::size_t from{};  // points of the route
  std::size_t to{};
  core::Seconds time{};  // that it could have stayed
};

/// The part that kills most time, where that is ten minutes at least; empty without one, and where nothing opens later.
/// A part leads past no fixed point, which is visited for its own sake. A way round something that stays closed is
/// none, nor is one at whose beginning the vehicle cannot stay.
[[nodiscard]] std::optional<TimeKilled> longest_killing_of_time(const cost::Sea& sea,
                                                                const cost::Route& route,
                                                                const cost::Schedule& schedule);

/// When a place that is closed at some time opens again; empty where it is open then, and where it stays closed.
[[nodiscard]] std::optional<core::Seconds> opens_at(const cost::Sea& sea, geo::PlanePoint place,
                                                    core::Seconds when);

/// Whether a pilot would let a vehicle that could be there at once circle until the end of its way opens.
[[nodiscard]] bool is_bearable(core::Seconds depart, core::Seconds at_once, core::Seconds opens);

/// For how long a vehicle that may not wait would have to circle until the end of its way opens, if that is too long
/// for any way there that a pilot would fly: then none need be looked for.
/// `at_once`: when it could be there if nothing closed and opened
[[nodiscard]] std::optional<core::Seconds> end_opens_too_late(const cost::Sea& sea, geo::PlanePoint end,
                                                              core::Seconds depart, core::Seconds at_once);

/// For how long a way over a grid circles, if that makes it none that a pilot would fly: for more than an hour and more
/// than half of its time. Either its end opens so much later than the vehicle could be there, or the way leads where
/// something has opened since the departure and who leaves so much later is at its end at the same time. Waits at one
/// place, which the request allows, do not count. Empty for a way that may be flown, and for none.
/// `at_once`: when the vehicle is at the end of the best way there is if nothing closes and opens, where that is known
[[nodiscard]] std::optional<core::Seconds> circles_too_long(const cost::Sea& sea, const OpenGrid& open,
                                                            const std::vector<geo::PlanePoint>& way,
                                                            core::Seconds depart,
                                                            std::optional<core::Seconds> at_once,
                                                            const std::stop_token& stop);

/// What it means, for a pilot; `from` is the place where the part begins.
[[nodiscard]] messages::Message message_of(const TimeKilled& killed, geo::LonLat from);

}  // namespace floeplan::planning::search
