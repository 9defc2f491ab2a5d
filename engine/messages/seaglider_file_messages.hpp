#pragma once

#include "engine/messages/kind.hpp"

/// What is found in the targets, science file and cmdfile of a Seaglider by themselves.
/// Ranks    danger: an error, the file is not to be flown; caution: a warning; note: good to know
/// Codes    those that scripts know, with underscores; a word behind a slash tells rows of one code apart
namespace floeplan::messages {

inline constexpr auto seaglider_file_kinds = std::to_array<Kind>({
    // Of any file.
    {.code = "not_ascii", .rank = Rank::danger, .text = "the vehicle's shore station takes ASCII alone"},
    {.code = "not_ascii/comment", .text = "the vehicle's shore station takes ASCII alone"},
    {.code = "malformed_field",
     .rank = Rank::danger,
     .text = "a word that is not FIELD=VALUE; no blanks around the equals sign"},
    {.code = "field_twice",
     .rank = Rank::danger,
     .text = "{field} is given twice",
     .slots = {{{"field", "radius"}}}},

    // The cmdfile.
    {.code = "unknown_line/cmdfile", .rank = Rank::danger, .text = "neither $NAME,number nor a directive"},
    {.code = "value_not_a_number/cmdfile",
     .rank = Rank::danger,
     .text = "the value of ${name} is not a number",
     .slots = {{{"name", "D_TGT"}}}},
    {.code = "unknown_parameter",
     .rank = Rank::note,
     .text = "${name} is not among the parameters that are known here",
     .slots = {{{"name", "D_TARGET"}}}},
    {.code = "not_whole",
     .rank = Rank::danger,
     .text = "${name} must be a whole number",
     .slots = {{{"name", "N_DIVES"}}}},
    {.code = "out_of_range/parameter",
     .rank = Rank::danger,
     .text = "${name} lies outside of what the vehicle takes",
     .slots = {{{"name", "D_TGT"}}}},
    {.code = "out_of_range/advice",
     .text = "${name} lies outside of what the vehicle takes",
     .slots = {{{"name", "MAX_BUOY"}}}},
    {.code = "parameter_twice",
     .rank = Rank::danger,
     .text = "${name} is given again, first in line {first}",
     .slots = {{{"name", "D_TGT"}, {"first", 2}}}},
    {.code = "parameter_twice/same",
     .text = "${name} is given again, first in line {first}",
     .slots = {{{"name", "D_TGT"}, {"first", 2}}}},
    {.code = "beyond_limit",
     .rank = Rank::danger,
     .text = "${name} must be less than ${limit}, at which the dive is aborted",
     .slots = {{{"name", "D_TGT"}, {"limit", "D_ABORT"}}}},
    {.code = "after_directive",
     .text = "a line after the directive of line {directive}, which comes last",
     .slots = {{{"directive", 4}}}},
    {.code = "no_directive", .rank = Rank::danger, .text = "$GO, $RESUME, $QUIT or $EXIT_TO_MENU is missing"},

    // Targets.
    {.code = "unknown_field/target",
     .text = "{field} is no field of a target",
     .slots = {{{"field", "colour"}}}},
    {.code = "value_not_a_number/target",
     .rank = Rank::danger,
     .text = "the value of {field} is not a number",
     .slots = {{{"field", "radius"}}}},
    {.code = "out_of_range/target",
     .rank = Rank::danger,
     .text = "lat lies beyond 90 degrees or lon beyond 180; they are written as DDMM.MMMM and DDDMM.MMMM"},
    {.code = "fields_missing",
     .rank = Rank::danger,
     .text = "{target} needs goto, and lat, lon and radius or else head",
     .slots = {{{"target", "W1"}}}},
    {.code = "bad_radius", .rank = Rank::danger, .text = "radius must be more than 0 m"},
    {.code = "out_of_range/heading", .rank = Rank::danger, .text = "head must be between 0 and 360 degrees"},
    {.code = "unknown_target",
     .rank = Rank::danger,
     .text = "{field}={target} names no target",
     .slots = {{{"field", "goto"}, {"target", "W9"}}}},
    {.code = "targets_go_round",
     .rank = Rank::note,
     .text =
         "after {last} the vehicle goes on to {next} again, round and round; it is followed to {last} once",
     .slots = {{{"last", "W4"}, {"next", "W1"}}}},
    {.code = "target_without_place",
     .text = "{target} is steered to by its heading: where the vehicle goes from there cannot be followed",
     .slots = {{{"target", "W2"}}}},
    {.code = "target_off_the_way",
     .rank = Rank::note,
     .text = "{target} does not follow from the first target",
     .slots = {{{"target", "W7"}}}},
    {.code = "too_many_waypoints/targets",
     .rank = Rank::danger,
     .text = "more than {most} targets",
     .slots = {{{"most", 1000}}}},
    {.code = "no_name", .rank = Rank::danger, .text = "the line begins without the target's name"},
    {.code = "target_twice",
     .rank = Rank::danger,
     .text = "target {target} is there twice",
     .slots = {{{"target", "W1"}}}},
    {.code = "no_target", .rank = Rank::danger, .text = "the file holds no target"},

    // The science file.
    {.code = "malformed_band",
     .rank = Rank::danger,
     .text = "a band has four columns (depth, seconds, sensors, gc), or the last three by name"},
    {.code = "unknown_field/band", .text = "{field} is no field of a band", .slots = {{{"field", "colour"}}}},
    {.code = "bad_band",
     .rank = Rank::danger,
     .text = "{field} must be given, as a number of seconds above 0",
     .slots = {{{"field", "seconds"}}}},
    {.code = "bad_depth",
     .rank = Rank::danger,
     .text = "a band begins with its depth in metres, more than 0, or with the word loiter"},
    {.code = "bad_sensors", .rank = Rank::danger, .text = "sensors must be given, one digit for each sensor"},
    {.code = "no_band", .rank = Rank::danger, .text = "the file holds no depth band"},
    {.code = "sensor_count_differs",
     .rank = Rank::danger,
     .text = "this band is for another number of sensors than the first one"},
    {.code = "depths_not_increasing", .text = "the bands must be listed from the surface down"},
});

/// The message of this code; it is told its values in the order of the catalogue.
template <Code code, class... Given>
[[nodiscard]] Message seaglider_file_message(const Given&... given) {
  return make_message<seaglider_file_kinds, code>(given...);
}

}  // namespace floeplan::messages
