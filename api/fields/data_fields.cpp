#include "api/fields/request_fields.hpp"

/// Rows for the stored data that a request uses.
namespace floeplan::fields {
namespace {

using repository::EnvironmentQuery;
using repository::TidesMode;

const std::vector<Word> newest_or_none{{"newest"}, {"none"}};

}  // namespace

const Table<EnvironmentQuery>& data_fields() {
  static const Table<EnvironmentQuery> table = in_group<EnvironmentQuery>(
      group::data,
      {
          bound<EnvironmentQuery>(
              {.name = "currents",
               .kind = Kind::datasets,
               .words = newest_or_none,
               .flag = "currents",
               .help = "Currents: an id, newest or none; several ids are the members of an ensemble",
               .details = "newest: those that cover area and departure",
               .form = {"Currents"}},
              [](auto& data) -> auto& { return data.currents; }),
          bound<EnvironmentQuery>({.name = "steady",
                                   .flag = "steady",
                                   .group = group::search,
                                   .help = "Hold the currents steady: one time step, or the mean of all",
                                   .form = {"Hold the currents at departure"}},
                                  [](auto& data) -> auto& { return data.steady; }),
          bound<EnvironmentQuery>(
              {.name = "tides",
               .kind = Kind::datasets,
               .words = newest_or_none,
               .flag = "tides",
               .help =
                   "Models of tidal currents: an id, newest or none; several ids fill the gaps of each other",
               .form = {"Tidal currents"}},
              [](auto& data) -> auto& { return data.tides.choice; }),
          worded<EnvironmentQuery>(
              {.name = "tides_mode",
               .flag = "tides-mode",
               .help = "Required with tides: add them to the currents, or use tidal currents only",
               .details = "add: to currents without tides; only: tidal currents without other currents",
               .form = {"Tides are"}},
              std::vector<Choice<std::optional<TidesMode>>>{
                  {{"add", "to currents without tides"}, TidesMode::add},
                  {{"only", "tidal currents only"}, TidesMode::only}},
              [](auto& data) -> auto& { return data.tides.mode; }),
          bound<EnvironmentQuery>({.name = "wind",
                                   .kind = Kind::dataset,
                                   .words = newest_or_none,
                                   .flag = "wind",
                                   .help = "Wind that moves icebergs: an id, newest or none",
                                   .details = "newest: the one that covers area and departure",
                                   .form = {"Wind on icebergs"}},
                                  [](auto& data) -> auto& { return data.wind; }),
          bound<EnvironmentQuery>(
              {.name = "bathymetry",
               .kind = Kind::datasets,
               .words = newest_or_none,
               .flag = "bathymetry",
               .help = "Depths: an id, newest or none; several ids in order of priority",
               .details =
                   "newest: all that overlap the area, the finest first, and of equally fine ones the newest",
               .form = {"Depths"}},
              [](auto& data) -> auto& { return data.bathymetry; }),
          bound<EnvironmentQuery>({.name = "ice",
                                   .kind = Kind::dataset,
                                   .words = newest_or_none,
                                   .flag = "ice",
                                   .help = "Sea ice: an id, newest or none",
                                   .details = "newest: the one of that time; older ones fill its gaps",
                                   .form = {"Sea ice"}},
                                  [](auto& data) -> auto& { return data.ice; }),
          bound<EnvironmentQuery>(
              {.name = "icebergs",
               .kind = Kind::datasets,
               .words = newest_or_none,
               .flag = "icebergs",
               .help = "Icebergs: an id, newest or none; with several ids the icebergs of all are avoided",
               .details = "newest: also those entered by hand",
               .form = {"Icebergs"}},
              [](auto& data) -> auto& { return data.icebergs; }),
          bound<EnvironmentQuery>({.name = "icebergs_as_of",
                                   .flag = "icebergs-as-of",
                                   .group = group::ice,
                                   .help = "Ignore sightings of icebergs after this time (default: the "
                                           "departure, or the wanted arrival)",
                                   .form = {"Icebergs as known at", "UTC", "departure"}},
                                  [](auto& data) -> auto& { return data.icebergs_as_of; }),
          bound<EnvironmentQuery>({.name = "coastline",
                                   .kind = Kind::dataset,
                                   .words = newest_or_none,
                                   .flag = "coastline",
                                   .help = "Coastline: an id, newest or none",
                                   .form = {"Coastline"}},
                                  [](auto& data) -> auto& { return data.coastline; }),
          bound<EnvironmentQuery>(
              {.name = "zones",
               .kind = Kind::datasets,
               .words = {{"all"}, {"none"}},
               .flag = "zones",
               .help = "Stored zones to obey in addition to the areas: an id, several ids, all or none",
               .form = {"Zones"}},
              [](auto& data) -> auto& { return data.zones; }),
      });
  return table;
}

}  // namespace floeplan::fields
