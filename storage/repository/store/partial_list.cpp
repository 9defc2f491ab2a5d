#include "storage/repository/store/partial_list.hpp"

#include <algorithm>

namespace floeplan::repository {

std::vector<MetThing> things_behind(sql::Connection& db, const ThingTable& table, const ListPart& part) {
  const ThingList things = things_in(db, "main", table, sql::RowReading::number);
  std::vector<MetThing> met;
  const auto meet = [&](const std::vector<StoredThing>& some, bool damaged) {
    for (const StoredThing& thing : some) {
      const bool is_behind =
          part.descending ? part.behind == 0 || thing.row < part.behind : thing.row > part.behind;
      if (is_behind) met.push_back({thing, damaged});
    }
  };
  meet(things.readable, false);
  meet(things.damaged, true);
  std::ranges::sort(met, [&](const MetThing& a, const MetThing& b) {
    return part.descending ? a.thing.row > b.thing.row : a.thing.row < b.thing.row;
  });
  return met;
}

}  // namespace floeplan::repository
