#pragma once

#include "engine/messages/kind.hpp"

/// Findings in single files of a Seaglider: targets, science file and cmdfile.
/// Ranks    danger: an error, the file must not be flown; caution: a warning; note: good to know
/// Codes    with underscores, known to scripts; a word after a slash distinguishes rows with the same code
namespace floeplan::messages {

inline constexpr auto seaglider_file_kinds = std::to_array<Kind>({
    // Of any file.
    {.code = "not_ascii",
     .rank = Rank::danger,
     .text =
         "the line holds a character that is not ASCII, but the vehicle's shore station accepts only ASCII"},
    {.code = "not_ascii/comment",
     .text = "the comment holds a character that is not ASCII, but the vehicle's shore station accepts only "
             "ASCII"},
    {.code = "malformed_field",
     .rank = Rank::danger,
     .text = "a word does not have the form FIELD=VALUE",
     .hint = "write no blanks around the equals sign"},
    {.code = "field_twice",
     .rank = Rank::danger,
     .text = "{field} is given twice",
     .hint = "leave one of them out",
     .slots = {{{"field", "radius"}}}},

    // The cmdfile.
    {.code = "unknown_line/cmdfile",
     .rank = Rank::danger,
     .text = "the line is neither $NAME,number nor a directive such as $GO"},
    {.code = "value_not_a_number/cmdfile",
     .rank = Rank::danger,
     .text = "the value of ${name} is not a number",
     .slots = {{{"name", "D_TGT"}}}},
    {.code = "unknown_parameter",
     .rank = Rank::note,
     .text = "${name} is not a known Seaglider parameter",
     .hint = "check its name",
     .slots = {{{"name", "D_TARGET"}}}},
    {.code = "not_whole",
     .rank = Rank::danger,
     .text = "${name} must be a whole number",
     .slots = {{{"name", "N_DIVES"}}}},
    {.code = "out_of_range/parameter",
     .rank = Rank::danger,
     .text = "${name} lies outside the range that the vehicle accepts",
     .slots = {{{"name", "D_TGT"}}}},
    {.code = "out_of_range/advice",
     .text = "${name} lies outside the range that the vehicle's manual advises",
     .slots = {{{"name", "MAX_BUOY"}}}},
    {.code = "parameter_twice",
     .rank = Rank::danger,
     .text = "${name} is given in line {first} already, with another value",
     .hint = "leave one of them out",
     .slots = {{{"name", "D_TGT"}, {"first", 2}}}},
    {.code = "parameter_twice/same",
     .text = "${name} is given in line {first} already, with the same value",
     .slots = {{{"name", "D_TGT"}, {"first", 2}}}},
    {.code = "beyond_limit",
     .rank = Rank::danger,
     .text = "${name} must be less than ${limit}, the depth at which the vehicle aborts the dive",
     .slots = {{{"name", "D_TGT"}, {"limit", "D_ABORT"}}}},
    {.code = "after_directive",
     .text = "this line stands after the directive of line {directive}, which must come last",
     .slots = {{{"directive", 4}}}},
    {.code = "no_directive",
     .rank = Rank::danger,
     .text = "the file has no directive",
     .hint = "end it with $GO, $RESUME, $QUIT or $EXIT_TO_MENU"},

    // Targets.
    {.code = "unknown_field/target",
     .text = "a target has no field {field}",
     .slots = {{{"field", "colour"}}}},
    {.code = "value_not_a_number/target",
     .rank = Rank::danger,
     .text = "the value of {field} is not a number",
     .slots = {{{"field", "radius"}}}},
    {.code = "out_of_range/target",
     .rank = Rank::danger,
     .text = "lat lies beyond 90 degrees or lon beyond 180 degrees",
     .hint = "write them as DDMM.MMMM and DDDMM.MMMM"},
    {.code = "fields_missing",
     .rank = Rank::danger,
     .text = "the target {target} needs the field goto, and either lat, lon and radius or head",
     .slots = {{{"target", "W1"}}}},
    {.code = "bad_radius", .rank = Rank::danger, .text = "radius must be more than 0 m"},
    {.code = "out_of_range/heading", .rank = Rank::danger, .text = "head must be between 0 and 360 degrees"},
    {.code = "unknown_target",
     .rank = Rank::danger,
     .text = "{field}={target} names a target that the file does not hold",
     .slots = {{{"field", "goto"}, {"target", "W9"}}}},
    {.code = "targets_go_round",
     .rank = Rank::note,
     .text = "after {last} the vehicle goes on to {next} again, round and round. This check follows it once, "
             "to {last}",
     .slots = {{{"last", "W4"}, {"next", "W1"}}}},
    {.code = "target_without_place",
     .text = "the vehicle steers to the target {target} by a heading, so its route from there is not known",
     .slots = {{{"target", "W2"}}}},
    {.code = "target_off_the_way",
     .rank = Rank::note,
     .text =
         "no chain of goto fields leads from the first target to {target}, so the vehicle does not fly to it",
     .slots = {{{"target", "W7"}}}},
    {.code = "too_many_waypoints/targets",
     .rank = Rank::danger,
     .text = "the file has more than {most} targets",
     .slots = {{{"most", 1000}}}},
    {.code = "no_name", .rank = Rank::danger, .text = "the line must begin with the name of the target"},
    {.code = "target_twice",
     .rank = Rank::danger,
     .text = "the file holds the target {target} twice",
     .hint = "leave one of them out",
     .slots = {{{"target", "W1"}}}},
    {.code = "no_target", .rank = Rank::danger, .text = "the file holds no target"},

    // The science file.
    {.code = "malformed_band",
     .rank = Rank::danger,
     .text = "a depth band must have four columns (depth, seconds, sensors, gc), or its depth and the last "
             "three by name"},
    {.code = "unknown_field/band",
     .text = "a depth band has no field {field}",
     .slots = {{{"field", "colour"}}}},
    {.code = "bad_band",
     .rank = Rank::danger,
     .text = "{field} must be given, as a number of seconds above 0",
     .slots = {{{"field", "seconds"}}}},
    {.code = "bad_depth",
     .rank = Rank::danger,
     .text = "a depth band must begin with its depth in metres, more than 0, or with the word loiter"},
    {.code = "bad_sensors", .rank = Rank::danger, .text = "sensors must be given, one digit for each sensor"},
    {.code = "no_band", .rank = Rank::danger, .text = "the file holds no depth band"},
    {.code = "sensor_count_differs",
     .rank = Rank::danger,
     .text = "this depth band has another number of sensors than the first band"},
    {.code = "depths_not_increasing", .text = "the depth bands must be listed from the surface down"},
});

/// Makes the message with this code. `given`: its values, in the order of its slots in the table above.
template <Code code, class... Given>
[[nodiscard]] Message seaglider_file_message(const Given&... given) {
  return make_message<seaglider_file_kinds, code>(given...);
}

}  // namespace floeplan::messages
