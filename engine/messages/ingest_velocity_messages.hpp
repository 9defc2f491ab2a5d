#pragma once

#include "engine/messages/kind.hpp"

/// Messages to the pilot about the choice of a file's variables for current or wind, and about their units.
namespace floeplan::messages {

inline constexpr auto ingest_velocity_kinds = std::to_array<Kind>({
    {.code = "speed-without-unit",
     .rank = Rank::note,
     .text = "the variable \"{variable}\" states no unit. It was read as m/s, which fits the size of its "
             "values",
     .hint = "Check the currents on the map",
     .slots = {{{"variable", "uo"}}}},
    {.code = "speed-unit-unknown",
     .rank = Rank::caution,
     .text = "the variable \"{variable}\" has the unit \"{unit}\", which is not a known speed. A wrong "
             "guess would put the glider off course",
     .hint = "Ask for data in m/s",
     .slots = {{{"variable", "uo"}, {"unit", "furlong"}}}},
    {.code = "currents-hold-the-tide",
     .rank = Rank::note,
     .text = "these currents already include {what}{advice}",
     .slots = {{{"what", "the tide"}, {"advice", "; add no tide to them"}}}},
    {.code = "currents-without-the-tide",
     .rank = Rank::caution,
     .text = "these currents do not include the tide",
     .hint = "For a plan, add the tide from a dataset of tides"},
    {.code = "geostrophic-currents",
     .rank = Rank::caution,
     .text = "these are geostrophic currents, computed from the sea level. They include no tide and no "
             "wind drift, and hold only near the surface",
     .hint = "Ingest currents of an ocean model if you have them"},
    {.code = "part-of-the-current",
     .rank = Rank::caution,
     .text = "{variables} hold {content}, {why}. A plan with them ignores the rest of the current",
     .slots = {{{"variables", "\"uo\" and \"vo\""},
                {"content", "the tide alone"},
                {"why", "as --variable asks for"}}}},
    {.code = "one-pair-of-several",
     .rank = Rank::note,
     .text = "the file holds several pairs of components. {taken} were stored, but {others} were not{advice}",
     .slots = {{{"taken", "\"uo\" and \"vo\""},
                {"others", "\"uo_tide\" and \"vo_tide\""},
                {"advice", "; name one component with --variable to store its pair instead"}}}},
    {.code = "climatology",
     .rank = Rank::caution,
     .text = "{variables} are means over many years (a climatology). The current on any single day "
             "differs from them",
     .hint = "Ingest a forecast before you plan a real mission",
     .slots = {{{"variables", "\"uo\" and \"vo\""}}}},
    {.code = "taken-as-currents-by-name",
     .rank = Rank::caution,
     .text = "the variables {variables} have no standard name and no long name. They were read as currents "
             "because of their names",
     .hint = "Check that they are currents",
     .slots = {{{"variables", "\"uo\" and \"vo\""}}}},
    {.code = "taken-by-standard-name",
     .rank = Rank::caution,
     .text =
         "\"{variable}\" was read as {component}, as its standard name says, but its {other} says otherwise",
     .hint = "Check which of them is right",
     .slots = {{{"variable", "uo"}, {"component", "the eastward component"}, {"other", "long name"}}}},
    {.code = "taken-by-long-name",
     .rank = Rank::caution,
     .text = "\"{variable}\" was read as {component}, as its long name says, but its own name says otherwise",
     .hint = "Check which of them is right",
     .slots = {{{"variable", "uo"}, {"component", "the eastward component"}}}},
    {.code = "component-contradicts-itself",
     .rank = Rank::caution,
     .text = "\"{variable}\" contradicts itself. By its standard name ({standard_name}) it is {one}, by its "
             "long name ({long_name}) it is {other}. A wrong guess would turn the drift by 90 degrees",
     .hint = "Ask the producer, or correct the wrong attribute",
     .slots = {{{"variable", "uo"},
                {"standard_name", "eastward_sea_water_velocity"},
                {"one", "the eastward component"},
                {"long_name", "northward velocity"},
                {"other", "the northward component"}}}},
    {.code = "counts-the-other-way",
     .rank = Rank::caution,
     .text = "\"{variable}\" counts {direction}, as its long name (\"{long_name}\") says, but this "
             "program reads components towards east and north. The drift would be reversed",
     .hint = "Ask for components towards east and north",
     .slots = {{{"variable", "uo"}, {"direction", "westwards"}, {"long_name", "westward velocity"}}}},
    {.code = "not-the-current",
     .rank = Rank::caution,
     .text = "{held}, which is not the current that a vehicle meets",
     .hint = "Give the file of the current itself{part}",
     .slots = {{{"held", "\"uo_std\" and \"vo_std\" hold a standard deviation"}, {"part", ""}}}},
    {.code = "not-the-wind",
     .rank = Rank::caution,
     .text = "{held}, which is not the wind 10 m above the sea that moves icebergs",
     .hint = "Give the file of that wind",
     .slots = {{{"held", "\"u10_std\" holds a standard deviation"}}}},
    {.code = "same-component-twice",
     .rank = Rank::caution,
     .text = "\"{first}\" and \"{second}\" both say that they are the {component} component, and it is not "
             "known which of them is the other component. A wrong guess would turn the drift",
     .hint = "Correct the attributes of the wrong one",
     .slots = {{{"first", "u"}, {"second", "v"}, {"component", "eastward"}}}},
    {.code = "components-described-differently",
     .rank = Rank::caution,
     .text = "the components {variables} are described differently, {how}. Used together, {consequence}",
     .hint = "Ask the producer for a file that describes both alike",
     .slots = {{{"variables", "\"u\" and \"v\""},
                {"how", "one along the model's grid, the other not"},
                {"consequence", "the drift would be turned"}}}},
    {.code = "components-do-not-belong",
     .rank = Rank::caution,
     .text = "the names of the components {variables} do not fit together, and the file holds no other "
             "components. Components of two models or times do not make one current",
     .hint = "If they are one pair nevertheless, name both with --variable, with a comma between",
     .slots = {{{"variables", "\"u1\" and \"v2\""}}}},
    {.code = "component-missing",
     .rank = Rank::caution,
     .text = "the file holds only one component of the {what} (\"{present}\"), and the {missing} component "
             "is missing",
     .hint = "{advice}",
     .slots = {{{"what", "current"},
                {"present", "uo"},
                {"missing", "northward"},
                {"advice", "Give the file of the other component in the same command"}}}},
    {.code = "velocity-not-found",
     .rank = Rank::caution,
     .text = "the file holds no velocity of sea water, so nothing was stored",
     .hint = "Give a file with, for example, the variables uo and vo"},
    {.code = "wind-not-found",
     .rank = Rank::caution,
     .text = "the file holds no wind at 10 m above the sea, so nothing was stored",
     .hint = "Give a file with the eastward and the northward wind at that height, for example the "
             "variables u10 and v10"},
    {.code = "several-pairs",
     .rank = Rank::caution,
     .text =
         "the file holds several pairs of components, {pairs}, and it is not known which of them to store",
     .hint = "{advice}",
     .slots = {{{"pairs", "\"u1\" and \"v1\", or \"u2\" and \"v2\""},
                {"advice", "Name one component with --variable, for example --variable u1"}}}},
    {.code = "title-contradicts",
     .rank = Rank::caution,
     .text =
         "the title of the file (\"{title}\") names {what}, but the attributes of {variables} do not. They "
         "were stored as the {stored}. If the title is right, every plan takes {what} for the "
         "{stored}",
     .hint = "Ask the producer what they are before you plan",
     .slots = {{{"title", "Monthly standard deviation"},
                {"what", "a standard deviation"},
                {"variables", "\"uo\" and \"vo\""},
                {"stored", "current"}}}},
    {.code = "group-of-statistics",
     .rank = Rank::caution,
     .text = "the data lie in the group {group} of the file. By its name the group holds {what}, which no "
             "vehicle or iceberg meets",
     .hint = "Give the file of the data themselves. If the name of the group misleads, rename the group",
     .slots = {{{"group", "/stdev"}, {"what", "a standard deviation"}}}},
    {.code = "group-of-a-part",
     .rank = Rank::caution,
     .text = "the data lie in the group {group} of the file. By its name the group holds {what}, but the "
             "data do not say so and were stored as they describe themselves",
     .hint = "Check that this is the current that you want",
     .slots = {{{"group", "/tide"}, {"what", "the tide alone"}}}},
});

/// Makes the message with this code. `given`: its values, in the order of its slots in the table above.
template <Code code, class... Given>
[[nodiscard]] Message ingest_velocity_message(const Given&... given) {
  return make_message<ingest_velocity_kinds, code>(given...);
}

}  // namespace floeplan::messages
