#pragma once

#include <cstdint>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "storage/repository/store/stored_things.hpp"

namespace floeplan::repository {

/// Part of a list of things, and the damaged things that may belong to it. Only for things that are
/// independent of each other, such as plans. Not for icebergs: a missing one would look like open water.
template <class Record>
struct PartialList {
  std::vector<Record> whole;
  std::vector<StoredThing> damaged;  // whether they meet the filter is not known
};

/// The part of a table that a list shows.
struct ListPart {
  // row of the last thing of the part before; in a descending list 0 means: from the newest
  std::int64_t behind{};
  int limit{};  // largest number of undamaged things
  bool descending{false};
};

/// A thing in a list, in the list's order.
struct MetThing {
  StoredThing thing;
  bool is_damaged{false};  // true: known to be damaged before reading all of it
};
[[nodiscard]] std::vector<MetThing> things_behind(sql::Connection& db, const ThingTable& table,
                                                  const ListPart& part);

/// Reads a list with one query; if the query meets damage, row by row.
/// Parameters  at_once: reads the whole part with one query; of_row: returns the record of one row, nullopt
///             if the row does not meet the filter
/// Errors      sql::Failure for trouble other than damage
template <class AtOnce, class OfRow>
[[nodiscard]] auto list_past_damage(sql::Connection& db, const ThingTable& table, const ListPart& part,
                                    const AtOnce& at_once, const OfRow& of_row) {
  using Record = typename std::invoke_result_t<AtOnce>::value_type;
  PartialList<Record> list;
  if (sql::meets_no_damage([&] { list.whole = at_once(); })) return list;
  for (const MetThing& met : things_behind(db, table, part)) {
    if (std::ssize(list.whole) >= part.limit) break;
    std::optional<Record> record;
    const bool whole = !met.is_damaged && sql::meets_no_damage([&] { record = of_row(met.thing.row); });
    if (!whole) list.damaged.push_back(met.thing);
    if (record) list.whole.push_back(std::move(*record));
  }
  return list;
}

}  // namespace floeplan::repository
