#include "api/fields/request_fields.hpp"

/// Rows of the stored data that a request uses.
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
               .details = "Newest are those that cover area and departure",
               .form = {"Currents"}},
              [](auto& data) -> auto& { return data.currents; }),
          bound<EnvironmentQuery>(
              {.name = "steady",
               .flag = "steady",
               .group = group::search,
               .help = "Use the one time step, or the mean of all, of the currents for every time",
               .form = {"Hold the currents at departure"}},
              [](auto& data) -> auto& { return data.steady; }),
          bound<EnvironmentQuery>(
              {.name = "tides",
               .kind = Kind::datasets,
               .words = newest_or_none,
               .flag = "tides",
               .help = "Models of tidal currents: an id, newest or none; several ids complete each other",
               .form = {"Tidal currents"}},
              [](auto& data) -> auto& { return data.tides.choice; }),
          worded<EnvironmentQuery>(
              {.name = "tides_mode",
               .flag = "tides-mode",
               .help = "Required with tides: add them to the currents, or take them only",
               .details = "add: the currents must be without tides; only: tidal currents alone",
               .form = {"Tides are"}},
              std::vector<Choice<std::optional<TidesMode>>>{
                  {{"add", "to currents without tides"}, TidesMode::add},
                  {{"only", "tidal currents alone"}, TidesMode::only}},
              [](auto& data) -> auto& { return data.tides.mode; }),
          bound<EnvironmentQuery>({.name = "wind",
                                   .kind = Kind::dataset,
                                   .words = newest_or_none,
                                   .flag = "wind",
                                   .help = "Wind that moves icebergs: an id, newest or none",
                                   .details = "Newest is the one that covers area and departure",
                                   .form = {"Wind on icebergs"}},
                                  [](auto& data) -> auto& { return data.wind; }),
          bound<EnvironmentQuery>(
              {.name = "bathymetry",
               .kind = Kind::datasets,
               .words = newest_or_none,
               .flag = "bathymetry",
               .help = "Depths: an id, newest or none; several ids in order of priority",
               .details = "Newest: all that meet the area, the finest first and the newest of those alike",
               .form = {"Depths"}},
              [](auto& data) -> auto& { return data.bathymetry; }),
          bound<EnvironmentQuery>(
              {.name = "ice",
               .kind = Kind::dataset,
               .words = newest_or_none,
               .flag = "ice",
               .help = "Sea ice: an id, newest or none",
               .details = "Newest is that of the time, with older ones where it tells nothing",
               .form = {"Sea ice"}},
              [](auto& data) -> auto& { return data.ice; }),
          bound<EnvironmentQuery>(
              {.name = "icebergs",
               .kind = Kind::datasets,
               .words = newest_or_none,
               .flag = "icebergs",
               .help = "Icebergs: an id, newest or none; of several ids all icebergs are avoided",
               .details = "Beside the newest those made by hand count",
               .form = {"Icebergs"}},
              [](auto& data) -> auto& { return data.icebergs; }),
          bound<EnvironmentQuery>(
              {.name = "icebergs_as_of",
               .flag = "icebergs-as-of",
               .group = group::ice,
               .help =
                   "Use no sighting of icebergs later than this; if omitted, the departure, or the wanted "
                   "arrival of a plan that has one",
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
               .help = "Stored zones that are obeyed beside the areas: an id, several ids, all or none",
               .form = {"Zones"}},
              [](auto& data) -> auto& { return data.zones; }),
      });
  return table;
}

}  // namespace floeplan::fields
