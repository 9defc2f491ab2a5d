#include "engine/mission/document/hold_order.hpp"

#include <string_view>

#include "engine/core/shown_text.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/mission/document/behavior_values.hpp"

namespace floeplan::mission {
namespace {

constexpr std::string_view comment_begin = "# hold from ";
constexpr std::string_view comment_middle = " until ";

std::optional<HoldTimes> times_of(std::string_view comment) {
  if (!comment.starts_with(comment_begin)) return std::nullopt;
  comment.remove_prefix(comment_begin.size());
  const std::size_t split = comment.find(comment_middle);
  if (split == std::string_view::npos) return std::nullopt;
  const auto from = core::parse_iso8601(comment.substr(0, split));
  const auto until = core::parse_iso8601(comment.substr(split + comment_middle.size()));
  if (!from || !until || *until < *from) return std::nullopt;
  return HoldTimes{*from, *until};
}

std::optional<HoldTimes> planned_times(const Document& document) {
  for (const SourceLine& line : document.lines)
    if (const auto times = times_of(line.comment)) return times;
  return std::nullopt;
}

}  // namespace

std::string hold_comment(const HoldTimes& times) {
  return std::string{comment_begin} + core::iso8601(times.from) + std::string{comment_middle} +
         core::iso8601(times.until) + "\n";
}

std::string hold_text(const HoldOrder& hold) {
  const std::string legs = hold.legs < 0
                               ? std::string{"without end"}
                               : "with " + core::counted(static_cast<std::size_t>(hold.legs), "leg");
  std::string text =
      "the list holds station " + legs + " between two rows " + core::distance_text(hold.apart) + " apart";
  if (hold.planned)
    text += ", planned from " + core::iso8601(hold.planned->from) + " until " +
            core::iso8601(hold.planned->until);
  return text;
}

std::optional<HoldOrder> hold_order(const Document& document) {
  const auto& rows = document.waypoints;
  const bool is_pair = document.kind == DocumentKind::arguments && document.behaviors.size() == 1 &&
                       document.behaviors.front().name == "goto_list" && rows.size() == 2;
  if (!is_pair) return std::nullopt;
  const Behavior& list = document.behaviors.front();
  const auto orders =
      list_orders(value_of(list, "num_legs_to_run"), value_of(list, "initial_wpt"), rows.size());
  if (!orders || (orders->legs != -1 && orders->legs <= static_cast<int>(rows.size()))) return std::nullopt;

  const geo::GeodesicLine line = geo::geodesic_between(rows[0].place, rows[1].place);
  const auto planned = planned_times(document);
  if (!planned && line.length > widest_hold) return std::nullopt;
  return HoldOrder{.place = geo::geodesic_destination(rows[0].place, line.course_at_start, 0.5 * line.length),
                   .axis = line.course_at_start,
                   .apart = line.length,
                   .radius = core::Metres{value_of(list, "list_when_wpt_dist").value_or(10.0)},
                   .legs = orders->legs,
                   .planned = planned};
}

}  // namespace floeplan::mission
