#pragma once

#include "engine/messages/kind.hpp"

/// What a pilot is told of the data that something is computed in: what is missing, stretched or left out.
/// Ranks    danger: hazards that are known and that nobody avoids. Caution: something is assumed in the place of data,
///          or a hazard was left out, whoever wanted that: who flies the plan is often not who made it. Note: where the
///          data come from, and wishes that hide no hazard
namespace floeplan::messages {

inline constexpr auto data_kinds = std::to_array<Kind>({
    // Nothing stored, or left out.
    {.code = "bathymetry-left-out",
     .rank = Rank::caution,
     .text = "bathymetry left out as requested: the depth of the water is not checked"},
    {.code = "bathymetry-missing",
     .rank = Rank::caution,
     .text = "no stored bathymetry for {area}: the depth of the water is not checked",
     .slots = {{{"area", "60 W to 58 W, 69 N to 70 N"}}}},
    {.code = "coastline-left-out",
     .rank = Rank::caution,
     .text = "coastline left out as requested: land is known from depths and currents only"},
    {.code = "coastline-missing",
     .rank = Rank::caution,
     .text = "no stored coastline for {area}: land is known from depths and currents only",
     .slots = {{{"area", "60 W to 58 W, 69 N to 70 N"}}}},
    {.code = "currents-left-out",
     .rank = Rank::caution,
     .text = "currents left out as requested: planned in still water"},
    {.code = "currents-missing",
     .rank = Rank::caution,
     .text = "no stored currents for {area}: planned in still water",
     .slots = {{{"area", "60 W to 58 W, 69 N to 70 N"}}}},
    {.code = "ice-left-out",
     .rank = Rank::caution,
     .text = "ice left out as requested: open water is assumed"},
    {.code = "ice-missing",
     .rank = Rank::caution,
     .text = "no stored ice for {area}: open water is assumed",
     .slots = {{{"area", "60 W to 58 W, 69 N to 70 N"}}}},
    {.code = "icebergs-left-out",
     .rank = Rank::caution,
     .text = "icebergs left out as requested: no iceberg is avoided"},
    {.code = "icebergs-missing",
     .rank = Rank::caution,
     .text = "no stored icebergs for {area}: no iceberg is avoided",
     .slots = {{{"area", "60 W to 58 W, 69 N to 70 N"}}}},
    {.code = "zones-left-out",
     .rank = Rank::caution,
     .text = "zones of {dataset} left out as requested: they are not obeyed",
     .slots = {{{"dataset", "reserves (zones-1)"}}}},

    // Icebergs.
    {.code = "sightings-too-old",
     .rank = Rank::danger,
     .text = "{ignored} of {known} {known:iceberg|icebergs} of {datasets} ignored: not seen since {oldest}. "
             "Each may still be near the route, and the plan avoids none of them",
     .hint = "Ingest newer sightings, or raise the maximum sighting age (--max-sighting-age). Ignored: "
             "{names}",
     .slots = {{{"ignored", 2},
                {"known", 60},
                {"datasets", "Ice Patrol (icebergs-1)"},
                {"oldest", "2027-01-05T06:00:00Z"},
                {"names", "B-17, B-18"}}}},
    {.code = "sightings-after-departure",
     .rank = Rank::danger,
     .text = "{ignored} {ignored:iceberg|icebergs} ignored: seen only after the departure at {departure}. "
             "Each may be near the route, and the plan avoids none of them",
     .hint = "Let them count (--icebergs-as-of {last}), or depart later. Ignored: {names}",
     .slots = {{{"ignored", 1},
                {"departure", "2027-01-12T06:00:00Z"},
                {"last", "2027-01-12T18:00:00Z"},
                {"names", "B-17 at 2027-01-12T18:00:00Z"}}}},
    {.code = "sightings-after-window",
     .rank = Rank::danger,
     .text = "{ignored} {ignored:iceberg|icebergs} ignored: seen only after the last departure asked for, "
             "{departure}. Each may be near the route, and the plan avoids none of them",
     .hint = "Let them count (--icebergs-as-of {last}), or depart later. Ignored: {names}",
     .slots = {{{"ignored", 1},
                {"departure", "2027-01-12T06:00:00Z"},
                {"last", "2027-01-12T18:00:00Z"},
                {"names", "B-17 at 2027-01-12T18:00:00Z"}}}},
    {.code = "sightings-left-out",
     .rank = Rank::caution,
     .text = "{ignored} {ignored:iceberg|icebergs} left out as requested: seen only after {as_of} "
             "({names}). The plan avoids none of them",
     .slots =
         {{{"ignored", 1}, {"as_of", "2027-01-12T06:00:00Z"}, {"names", "B-17 at 2027-01-12T18:00:00Z"}}}},
    {.code = "icebergs-joined",
     .rank = Rank::note,
     .text = "icebergs are joined from several datasets, the newest sighting of each: {datasets}",
     .slots = {{{"datasets", "40 of Ice Patrol (icebergs-1), 3 of satellites (icebergs-2)"}}}},
    {.code = "icebergs-on-land",
     .rank = Rank::caution,
     .text = "{on_land} {on_land:iceberg lies|icebergs lie} on land of the coastline ({names}): a position "
             "or the coastline is wrong there",
     .slots = {{{"on_land", 2}, {"names", "B-17, B-18"}}}},
    {.code = "sightings-before-currents",
     .rank = Rank::caution,
     .text = "{before} of {icebergs} {icebergs:iceberg|icebergs} {before:was|were} last seen before the "
             "currents begin, at {begin}. Until "
             "then each keeps its last observed drift, drifts with the wind, or stays put",
     .slots = {{{"before", 60}, {"icebergs", 60}, {"begin", "2027-01-12T00:00:00Z"}}}},
    {.code = "earlier-sightings-before-currents",
     .rank = Rank::caution,
     .text = "{before} of {icebergs} {icebergs:iceberg|icebergs} {before:was|were} first seen before the "
             "currents begin, at {begin}: their "
             "forecast follows current and wind, and not the observed drift",
     .slots = {{{"before", 3}, {"icebergs", 60}, {"begin", "2027-01-12T00:00:00Z"}}}},
    {.code = "icebergs-beyond-currents",
     .rank = Rank::caution,
     .text = "{unknown} of {icebergs} {icebergs:iceberg|icebergs} {unknown:drifts|drift} beyond the current "
             "data ({names}). From then on each "
             "keeps its last observed drift, drifts with the wind, or stays put",
     .slots = {{{"unknown", 3}, {"icebergs", 60}, {"names", "B-17, B-18, B-19"}}}},
    {.code = "wind-not-at-departure",
     .rank = Rank::caution,
     .text = "no stored wind for the time of departure ({periods}): icebergs drift with the water alone",
     .slots = {{{"periods", "wind (wind-1) covers 2027-01-01T00:00:00Z to 2027-01-03T00:00:00Z"}}}},

    // Sea ice.
    {.code = "ice-not-at-departure",
     .rank = Rank::caution,
     .text = "no stored ice for the time of departure ({periods}): open water is assumed",
     .slots = {{{"periods", "chart (ice-1) covers 2027-01-01T00:00:00Z to 2027-01-03T00:00:00Z"}}}},
    {.code = "ice-not-begun",
     .rank = Rank::caution,
     .text = "the stored ice begins at {begin}. Open water is assumed until {held_from}; from then on the "
             "first ice is held",
     .slots = {{{"begin", "2027-01-16T00:00:00Z"}, {"held_from", "2027-01-13T00:00:00Z"}}}},
    {.code = "ice-unknown-at-departure",
     .rank = Rank::caution,
     .text = "the ice at the departure is unknown: the nearest of {dataset} is at {step}, and ice is held "
             "for at most 3 days. Dives keep below the last known keels, and the plan counts on no surfacing",
     .slots = {{{"dataset", "chart (ice-1)"}, {"step", "2027-01-08T00:00:00Z"}}}},
    {.code = "ice-held",
     .rank = Rank::caution,
     .text = "ice of {dataset} is held as at {step}, its step nearest to the departure",
     .slots = {{{"dataset", "chart (ice-1)"}, {"step", "2027-01-11T00:00:00Z"}}}},
    {.code = "ice-without-thickness",
     .rank = Rank::caution,
     .text = "ice of {dataset} has no thickness: a draft is assumed wherever there is ice",
     .slots = {{{"dataset", "chart (ice-1)"}}}},
    {.code = "ice-with-thickness-of-others",
     .rank = Rank::caution,
     .text = "ice of {dataset} has no thickness: where other datasets show dense ice, theirs is used; "
             "elsewhere a draft is assumed",
     .slots = {{{"dataset", "chart (ice-1)"}}}},
    {.code = "ice-areas-not-used",
     .rank = Rank::caution,
     .text = "{dataset} holds areas of ice and nothing outside them: it is not used beside {used}",
     .hint = "Import it as zones, or name it (--ice) to plan with it alone",
     .slots = {{{"dataset", "fast ice (ice-2)"}, {"used", "chart (ice-1)"}}}},
    {.code = "ice-joined",
     .rank = Rank::note,
     .text = "ice is joined from several datasets. Each place and time uses the data nearest in time, and of "
             "equals the first: {datasets}",
     .slots = {{{"datasets", "chart (ice-1), then model (ice-2)"}}}},
    {.code = "old-ice-not-asked",
     .rank = Rank::note,
     .text = "more than {most} ice datasets cover this area and time: the oldest are not used",
     .slots = {{{"most", 40}}}},

    // Depths.
    {.code = "bathymetry-coarse",
     .rank = Rank::caution,
     .text = "bathymetry {datasets} is coarse (one depth every {spacing}): shoals and islands between its "
             "nodes are not seen",
     .slots = {{{"datasets", "globe (bathymetry-1)"}, {"spacing", "20 km"}}}},
    {.code = "bathymetry-joined",
     .rank = Rank::note,
     .text =
         "bathymetry is joined from several datasets in this order: {datasets}; one depth every {spacing}",
     .slots = {{{"datasets", "bay (bathymetry-2), then globe (bathymetry-1)"}, {"spacing", "500 m"}}}},

    // Currents.
    {.code = "currents-without-depth",
     .rank = Rank::caution,
     .text = "currents {dataset} state no depth: used at every depth",
     .slots = {{{"dataset", "bay model (currents-1)"}}}},
    {.code = "currents-of-one-level",
     .rank = Rank::caution,
     .text = "currents {dataset} have one level ({level}): used at every depth",
     .slots = {{{"dataset", "bay model (currents-1)"}, {"level", "1 m"}}}},
    {.code = "currents-above-dives",
     .rank = Rank::caution,
     .text =
         "the currents of {dataset} end at a depth of {deepest}, but dives go to {dives}: the water below is "
         "assumed to move with the mean of the water above",
     .slots = {{{"dataset", "bay model (currents-1)"}, {"deepest", "50 m"}, {"dives", "200 m"}}}},
    {.code = "currents-without-time",
     .rank = Rank::caution,
     .text = "currents held steady: {dataset} state no time",
     .slots = {{{"dataset", "bay model (currents-1)"}}}},
    {.code = "currents-held-steady",
     .rank = Rank::note,
     .text = "currents held steady: {dataset} as at {time}",
     .slots = {{{"dataset", "bay model (currents-1)"}, {"time", "2027-01-12T00:00:00Z"}}}},
    {.code = "currents-held-at-mean",
     .rank = Rank::note,
     .text = "currents held steady: {dataset}, the mean of {steps} {steps:step|steps} from {period}",
     .slots = {{{"dataset", "bay model (currents-1)"},
                {"steps", 24},
                {"period", "2027-01-12T00:00:00Z to 2027-01-13T00:00:00Z"}}}},
    {.code = "runs-joined",
     .rank = Rank::note,
     .text = "{kind} are joined in time, the newest run first in each: {parts}",
     .slots = {{{"kind", "currents"},
                {"parts", "bay model (currents-1) from 2027-01-12T00:00:00Z to 2027-01-13T00:00:00Z"}}}},

    // Tides.
    {.code = "tides-alone",
     .rank = Rank::note,
     .text = "currents are the tidal currents of {tides} alone, the same at every depth",
     .slots = {{{"tides", "bay tides (tides-1)"}}}},
    {.code = "tides-added",
     .rank = Rank::note,
     .text = "tides of {tides} are added to the currents {currents}",
     .slots = {{{"tides", "bay tides (tides-1)"}, {"currents", "bay model, detided (currents-1)"}}}},
    {.code = "tides-may-count-twice",
     .rank = Rank::caution,
     .text = "tides of {tides} are added to the currents {currents}. If these currents include the tide "
             "already, it counts twice",
     .slots = {{{"tides", "bay tides (tides-1)"}, {"currents", "bay model (currents-1)"}}}},
    {.code = "tides-unknown",
     .rank = Rank::caution,
     .text = "tides of {tides} have no value at any node of the currents: no current is known",
     .slots = {{{"tides", "bay tides (tides-1)"}}}},
    {.code = "tides-unknown-at-nodes",
     .rank = Rank::caution,
     .text = "tides of {tides} have no value at {unknown} of {nodes} nodes of the currents: these nodes "
             "count as land",
     .slots = {{{"tides", "bay tides (tides-1)"}, {"unknown", 14}, {"nodes", 900}}}},
    {.code = "tides-in-coarse-steps",
     .rank = Rank::caution,
     .text = "tides are computed every {step}, too coarse for their changes",
     .hint = "A smaller area allows finer steps",
     .slots = {{{"step", "30 min"}}}},
    {.code = "tides-end-early",
     .rank = Rank::caution,
     .text = "tides are computed until {end} only",
     .hint = "A smaller area allows a longer time",
     .slots = {{{"end", "2027-01-20T00:00:00Z"}}}},
    {.code = "drift-tides-end-early",
     .rank = Rank::caution,
     .text = "the tides that carry icebergs are computed until {end} only",
     .hint = "A smaller area allows a longer time",
     .slots = {{{"end", "2027-01-20T00:00:00Z"}}}},
});

/// The message of this code; it is told its values in the order of the catalogue.
template <Code code, class... Given>
[[nodiscard]] Message data_message(const Given&... given) {
  return make_message<data_kinds, code>(given...);
}

}  // namespace floeplan::messages
