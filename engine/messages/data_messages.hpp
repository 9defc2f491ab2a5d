#pragma once

#include "engine/messages/kind.hpp"

/// Messages to the pilot about the data of a computation: what is missing, extrapolated or left out.
/// Ranks    danger: known hazards that the plan does not avoid. Caution: an assumption replaces data, or a
///          hazard was left out, even on request, because the pilot of a plan often did not make it. Note:
///          the origin of data, and requests that hide no hazard
namespace floeplan::messages {

inline constexpr auto data_kinds = std::to_array<Kind>({
    // Nothing stored, or left out.
    {.code = "bathymetry-left-out",
     .rank = Rank::caution,
     .text = "bathymetry was left out as requested, so the depth of the water is not checked"},
    {.code = "bathymetry-missing",
     .rank = Rank::caution,
     .text = "no bathymetry is stored for {area}, so the depth of the water is not checked",
     .hint = "Ingest bathymetry of this area",
     .slots = {{{"area", "60° W to 58° W, 69° N to 70° N"}}}},
    {.code = "coastline-left-out",
     .rank = Rank::caution,
     .text = "the coastline was left out as requested, so land is known only from depths and currents"},
    {.code = "coastline-missing",
     .rank = Rank::caution,
     .text = "no coastline is stored for {area}, so land is known only from depths and currents",
     .hint = "Ingest a coastline of this area",
     .slots = {{{"area", "60° W to 58° W, 69° N to 70° N"}}}},
    {.code = "currents-left-out",
     .rank = Rank::caution,
     .text = "currents were left out as requested, so the plan is made in still water"},
    {.code = "currents-missing",
     .rank = Rank::caution,
     .text = "no currents are stored for {area}, so the plan is made in still water",
     .hint = "Ingest currents of this area",
     .slots = {{{"area", "60° W to 58° W, 69° N to 70° N"}}}},
    {.code = "ice-left-out",
     .rank = Rank::caution,
     .text = "sea ice was left out as requested, so open water is assumed"},
    {.code = "ice-missing",
     .rank = Rank::caution,
     .text = "no sea ice is stored for {area}, so open water is assumed",
     .hint = "Ingest sea ice of this area",
     .slots = {{{"area", "60° W to 58° W, 69° N to 70° N"}}}},
    {.code = "icebergs-left-out",
     .rank = Rank::caution,
     .text = "icebergs were left out as requested, so the plan avoids none"},
    {.code = "icebergs-missing",
     .rank = Rank::caution,
     .text = "no icebergs are stored for {area}, so the plan avoids none",
     .hint = "Ingest sightings of icebergs in this area",
     .slots = {{{"area", "60° W to 58° W, 69° N to 70° N"}}}},
    {.code = "zones-left-out",
     .rank = Rank::caution,
     .text = "the zones of {dataset} were left out as requested, so the plan does not obey them",
     .slots = {{{"dataset", "reserves (zones-1)"}}}},

    // Icebergs.
    // Ignored for each reason, and used: these counts of the four messages add up to {known}.
    {.code = "sightings-too-old",
     .rank = Rank::danger,
     .text = "{ignored} of {known} {known:iceberg|icebergs} {ignored:was|were} ignored, not seen since "
             "{oldest} (in {datasets}). {ignored:The iceberg|Each} may still be near the route, and the plan "
             "{ignored:does not avoid it|avoids none of them}. The plan uses the sightings of {used} "
             "{used:iceberg|icebergs}",
     .hint =
         "Ingest newer sightings, or raise the maximum sighting age (--max-sighting-age). Ignored: {names}",
     .slots = {{{"ignored", 2},
                {"known", 60},
                {"used", 57},
                {"datasets", "Ice Patrol (icebergs-1)"},
                {"oldest", "2027-01-05T06:00:00Z"},
                {"names", "B-17, B-18"}}}},
    // No request may ask for sightings as old as these.
    {.code = "sightings-too-old-for-any-plan",
     .rank = Rank::danger,
     .text = "{ignored} of {known} {known:iceberg|icebergs} {ignored:was|were} ignored, not seen since "
             "{oldest} (in {datasets}). {ignored:The iceberg|Each} may still be near the route, and the plan "
             "{ignored:does not avoid it|avoids none of them}. The plan uses the sightings of {used} "
             "{used:iceberg|icebergs}",
     .hint = "Ingest newer sightings. Ignored: {names}",
     .slots = {{{"ignored", 2},
                {"known", 60},
                {"used", 57},
                {"datasets", "Ice Patrol (icebergs-1)"},
                {"oldest", "2026-12-13T00:00:00Z"},
                {"names", "B-17, B-18"}}}},
    {.code = "sightings-after-departure",
     .rank = Rank::danger,
     .text = "{ignored} of {known} {known:iceberg|icebergs} {ignored:was|were} ignored, because {ignored:its|"
             "their} only recent sightings are later than the departure at "
             "{departure}. {ignored:The iceberg|Each} may be near the route, and the plan {ignored:does not "
             "avoid it|avoids none of them}. The plan uses the sightings of {used} {used:iceberg|icebergs}",
     .hint = "Use these sightings too (--icebergs-as-of {last}), or depart later. Ignored: {names}",
     .slots = {{{"ignored", 1},
                {"known", 60},
                {"used", 57},
                {"departure", "2027-01-12T06:00:00Z"},
                {"last", "2027-01-12T18:00:00Z"},
                {"names", "B-17 at 2027-01-12T18:00:00Z"}}}},
    {.code = "sightings-after-window",
     .rank = Rank::danger,
     .text = "{ignored} of {known} {known:iceberg|icebergs} {ignored:was|were} ignored, because {ignored:its|"
             "their} only recent sightings are later than the last departure of "
             "the window, {departure}. {ignored:The iceberg|Each} may be near the route, and the plan "
             "{ignored:does not avoid it|avoids none of them}. The plan uses the sightings of {used} "
             "{used:iceberg|icebergs}",
     .hint = "Use these sightings too (--icebergs-as-of {last}), or depart later. Ignored: {names}",
     .slots = {{{"ignored", 1},
                {"known", 60},
                {"used", 57},
                {"departure", "2027-01-12T06:00:00Z"},
                {"last", "2027-01-12T18:00:00Z"},
                {"names", "B-17 at 2027-01-12T18:00:00Z"}}}},
    {.code = "sightings-left-out",
     .rank = Rank::caution,
     .text =
         "{ignored} of {known} {known:iceberg|icebergs} {ignored:was|were} left out as requested, because "
         "{ignored:its|their} only recent sightings are later than {as_of} ({names}). The plan {ignored:does "
         "not avoid it|avoids none of them}. It uses the sightings of "
         "{used} {used:iceberg|icebergs}",
     .slots = {{{"ignored", 1},
                {"known", 60},
                {"used", 57},
                {"as_of", "2027-01-12T06:00:00Z"},
                {"names", "B-17 at 2027-01-12T18:00:00Z"}}}},
    {.code = "icebergs-joined",
     .rank = Rank::note,
     .text = "the icebergs come from several datasets: {datasets}. The newest sighting of each "
             "iceberg counts",
     .slots = {{{"datasets", "40 of Ice Patrol (icebergs-1), 3 of satellites (icebergs-2)"}}}},
    {.code = "icebergs-on-land",
     .rank = Rank::caution,
     .text = "{on_land} {on_land:iceberg lies|icebergs lie} on land of the stored coastline ({names}). "
             "Either a position or the coastline is wrong there",
     .hint = "Check the positions",
     .slots = {{{"on_land", 2}, {"names", "B-17, B-18"}}}},
    {.code = "sightings-before-currents",
     .rank = Rank::caution,
     .text = "{before} of {icebergs} {icebergs:iceberg|icebergs} {before:was|were} last seen before "
             "the currents begin at {begin}. Until then the plan assumes that each iceberg keeps its "
             "last observed drift. An iceberg without such a drift is assumed to drift with the wind, "
             "or to stay in place if the wind is unknown",
     .hint = "Ingest currents that begin earlier, or newer sightings",
     .slots = {{{"before", 60}, {"icebergs", 60}, {"begin", "2027-01-12T00:00:00Z"}}}},
    {.code = "earlier-sightings-before-currents",
     .rank = Rank::caution,
     .text = "{before} of {icebergs} {icebergs:iceberg|icebergs} {before:was|were} first seen before the "
             "currents begin at {begin}. Their forecast follows the current and the wind. It cannot use "
             "the drift that was observed between the sightings",
     .hint = "Ingest currents that begin earlier",
     .slots = {{{"before", 3}, {"icebergs", 60}, {"begin", "2027-01-12T00:00:00Z"}}}},
    {.code = "icebergs-beyond-currents",
     .rank = Rank::caution,
     .text = "{unknown} of {icebergs} {icebergs:iceberg|icebergs} {unknown:drifts|drift} beyond the "
             "current data ({names}). From then on the plan assumes that each iceberg keeps its last "
             "observed drift. An iceberg without such a drift is assumed to drift with the wind, or to "
             "stay in place if the wind is unknown",
     .hint = "Ingest currents that cover a wider area and a longer time",
     .slots = {{{"unknown", 3}, {"icebergs", 60}, {"names", "B-17, B-18, B-19"}}}},
    {.code = "wind-not-at-departure",
     .rank = Rank::caution,
     .text =
         "no stored wind covers the time of departure ({periods}), so icebergs drift with the water alone",
     .hint = "Ingest wind for this time",
     .slots = {{{"periods", "wind (wind-1) covers 2027-01-01T00:00:00Z to 2027-01-03T00:00:00Z"}}}},

    // Sea ice.
    {.code = "ice-not-at-departure",
     .rank = Rank::caution,
     .text = "no stored sea ice covers the time of departure ({periods}), so open water is assumed",
     .hint = "Ingest sea ice for this time",
     .slots = {{{"periods", "chart (ice-1) covers 2027-01-01T00:00:00Z to 2027-01-03T00:00:00Z"}}}},
    {.code = "ice-not-begun",
     .rank = Rank::caution,
     .text = "the stored sea ice begins at {begin}. Until {held_from} open water is assumed, and from then "
             "on the first stored ice",
     .hint = "Ingest sea ice for the departure",
     .slots = {{{"begin", "2027-01-16T00:00:00Z"}, {"held_from", "2027-01-13T00:00:00Z"}}}},
    {.code = "ice-unknown-at-departure",
     .rank = Rank::caution,
     .text = "the sea ice at the departure is unknown. The nearest state of the ice in {dataset} is "
             "that of {step}, and a plan uses ice data for at most 3 days before and after their time. "
             "Dives keep below the last known keels, and the plan includes no surfacing",
     .hint = "Ingest newer sea ice",
     .slots = {{{"dataset", "chart (ice-1)"}, {"step", "2027-01-08T00:00:00Z"}}}},
    {.code = "ice-held",
     .rank = Rank::caution,
     .text = "the plan uses one state of the sea ice at all times: that of {dataset} at {step}, the time "
             "nearest to the departure. The true ice moves during the plan",
     .hint = "Ingest newer sea ice shortly before the departure, and plan again",
     .slots = {{{"dataset", "chart (ice-1)"}, {"step", "2027-01-11T00:00:00Z"}}}},
    {.code = "ice-without-thickness",
     .rank = Rank::caution,
     .text = "the sea ice of {dataset} has no thickness, so a draft is assumed wherever the data show "
             "ice",
     .hint = "Ingest sea ice with a thickness if you have it",
     .slots = {{{"dataset", "chart (ice-1)"}}}},
    {.code = "ice-with-thickness-of-others",
     .rank = Rank::caution,
     .text = "the sea ice of {dataset} has no thickness. Where other datasets show dense ice, their "
             "thickness is used. Elsewhere a draft is assumed",
     .slots = {{{"dataset", "chart (ice-1)"}}}},
    {.code = "ice-areas-not-used",
     .rank = Rank::caution,
     .text = "{dataset} holds areas of sea ice, but does not say whether the water outside them is open. "
             "It is therefore not used together with {used}",
     .hint = "Import the areas as zones, or name this dataset (--ice) to plan with it alone",
     .slots = {{{"dataset", "fast ice (ice-2)"}, {"used", "chart (ice-1)"}}}},
    {.code = "ice-joined",
     .rank = Rank::note,
     .text = "sea ice comes from several datasets. For each place and time the plan uses the data "
             "nearest in time. Where two are equally near, the first in this list counts: {datasets}",
     .slots = {{{"datasets", "chart (ice-1), then model (ice-2)"}}}},
    {.code = "old-ice-not-asked",
     .rank = Rank::note,
     .text = "more than {most} datasets of sea ice cover this area and time. The oldest are not used",
     .hint = "Name the datasets to use (--ice), or remove old ones",
     .slots = {{{"most", 40}}}},

    // Depths.
    {.code = "bathymetry-coarse",
     .rank = Rank::caution,
     .text = "the bathymetry {datasets} is coarse, with one depth every {spacing}. It does not show shoals "
             "and islands between these depths",
     .hint = "Ingest finer bathymetry, or keep well clear of shoals and islands",
     .slots = {{{"datasets", "globe (bathymetry-1)"}, {"spacing", "20 km"}}}},
    {.code = "bathymetry-joined",
     .rank = Rank::note,
     .text = "bathymetry comes from several datasets with this priority: {datasets}. The plan uses "
             "one depth every {spacing}",
     .slots = {{{"datasets", "bay (bathymetry-2), then globe (bathymetry-1)"}, {"spacing", "500 m"}}}},

    // Currents.
    {.code = "currents-without-depth",
     .rank = Rank::caution,
     .text = "the currents {dataset} state no depth, so they are used at every depth. At some depths the "
             "true current may be different",
     .hint = "Ingest currents with depths if you have them",
     .slots = {{{"dataset", "bay model (currents-1)"}}}},
    {.code = "currents-of-one-level",
     .rank = Rank::caution,
     .text = "the currents {dataset} have only one level ({level}), so they are used at every depth. At "
             "other depths the true current may be different",
     .hint = "Ingest currents with more levels if you have them",
     .slots = {{{"dataset", "bay model (currents-1)"}, {"level", "1 m"}}}},
    {.code = "currents-above-dives",
     .rank = Rank::caution,
     .text = "the currents {dataset} end at a depth of {deepest}, but dives go to {dives}. Below that "
             "depth the plan uses the mean of the currents above, and the true current may differ",
     .hint = "Ingest currents that reach deeper, or dive less deep (--dive-depth)",
     .slots = {{{"dataset", "bay model (currents-1)"}, {"deepest", "50 m"}, {"dives", "200 m"}}}},
    {.code = "currents-without-time",
     .rank = Rank::caution,
     .text = "the currents {dataset} state no time, so they are held steady",
     .hint = "Check that they are the currents of the time of the mission",
     .slots = {{{"dataset", "bay model (currents-1)"}}}},
    {.code = "currents-held-steady",
     .rank = Rank::note,
     .text = "the currents {dataset} are held steady. The plan uses the currents of {time} at all times",
     .slots = {{{"dataset", "bay model (currents-1)"}, {"time", "2027-01-12T00:00:00Z"}}}},
    {.code = "currents-held-at-mean",
     .rank = Rank::note,
     .text = "the currents {dataset} are held steady. At all times the plan uses the mean of {steps} "
             "{steps:time step|time steps} from {period}",
     .slots = {{{"dataset", "bay model (currents-1)"},
                {"steps", 24},
                {"period", "2027-01-12T00:00:00Z to 2027-01-13T00:00:00Z"}}}},
    {.code = "currents-of-another-time",
     .rank = Rank::caution,
     .text = "the currents {dataset} are held steady. They are the currents of {period}, but the "
             "departure lies {gap_d:.1f} days from that time. The true currents of the mission may be "
             "quite different",
     .hint = "Ingest currents of the time of the mission",
     .slots = {{{"dataset", "bay model (currents-1)"},
                {"period", "2027-01-12T00:00:00Z to 2027-01-13T00:00:00Z"},
                {"gap_d", 2.5}}}},
    {.code = "runs-joined",
     .rank = Rank::note,
     .text = "the {kind} come from several forecast runs, and at each time the newest run counts: {parts}",
     .slots = {{{"kind", "currents"},
                {"parts", "bay model (currents-1) from 2027-01-12T00:00:00Z to 2027-01-13T00:00:00Z"}}}},

    // Tides.
    {.code = "tides-alone",
     .rank = Rank::note,
     .text = "the plan uses the tidal currents of {tides} alone, the same at every depth",
     .slots = {{{"tides", "bay tides (tides-1)"}}}},
    {.code = "tides-added",
     .rank = Rank::note,
     .text = "the tidal currents of {tides} are added to the currents {currents}",
     .slots = {{{"tides", "bay tides (tides-1)"}, {"currents", "bay model, detided (currents-1)"}}}},
    {.code = "tides-may-count-twice",
     .rank = Rank::caution,
     .text = "the tidal currents of {tides} are added to the currents {currents}. If those currents already "
             "include the tide, it counts twice",
     .hint = "Ask the producer of the currents. If they include the tide, plan without the tides (--tides none)",
     .slots = {{{"tides", "bay tides (tides-1)"}, {"currents", "bay model (currents-1)"}}}},
    {.code = "tides-unknown",
     .rank = Rank::caution,
     .text = "the tides {tides} have no value at any node of the currents, so no current is known",
     .hint = "Name another tide model (--tides), or plan without tides (--tides none)",
     .slots = {{{"tides", "bay tides (tides-1)"}}}},
    {.code = "tides-unknown-at-nodes",
     .rank = Rank::caution,
     .text = "the tides {tides} have no value at {unknown} of {nodes} nodes of the currents. These nodes "
             "count as land, so no route passes there",
     .hint = "To open this water to routes, name another tide model (--tides)",
     .slots = {{{"tides", "bay tides (tides-1)"}, {"unknown", 14}, {"nodes", 900}}}},
    {.code = "tides-in-coarse-steps",
     .rank = Rank::caution,
     .text = "the plan computes the tides only every {step}, so it misses some of their changes",
     .hint = "Plan in a smaller area, which allows finer steps",
     .slots = {{{"step", "30 min"}}}},
    {.code = "tides-end-early",
     .rank = Rank::caution,
     .text = "the tides are computed only until {end}, and after that time no current is known",
     .hint = "Plan in a smaller area, which allows a longer time",
     .slots = {{{"end", "2027-01-20T00:00:00Z"}}}},
    {.code = "drift-tides-end-early",
     .rank = Rank::caution,
     .text = "the tides that carry icebergs are computed only until {end}. After that time the plan "
             "assumes that each iceberg keeps its last observed drift, drifts with the wind, or stays "
             "in place",
     .hint = "Plan in a smaller area, which allows a longer time",
     .slots = {{{"end", "2027-01-20T00:00:00Z"}}}},
});

/// Makes the message with this code. `given`: its values, in the order of its slots in the table above.
template <Code code, class... Given>
[[nodiscard]] Message data_message(const Given&... given) {
  return make_message<data_kinds, code>(given...);
}

}  // namespace floeplan::messages
