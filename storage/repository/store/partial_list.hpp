#pragma once

#include <cstdint>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "storage/repository/store/stored_things.hpp"

namespace floeplan::repository {

/// A part of a list of things, and the things that cannot be read of what it would hold. Only for things of which one says
/// nothing of another, such as plans: a list of icebergs that lacks one would pass for open water.
template <class Record>
struct PartialList {
  std::vector<Record> whole;
  std::vector<StoredThing> damaged;  // whether a filter would have let them through is not known
};

/// Which part of a table a list has.
struct ListPart {
  std::int64_t behind{};  // row of the last thing of the part before; of a descending list 0: from the newest
  int limit{};            // most whole things
  bool descending{false};
};

/// A thing that a list comes across, in the list's order.
struct MetThing {
  StoredThing thing;
  bool is_damaged{false};  // known without reading it to its end
};
[[nodiscard]] std::vector<MetThing> things_behind(sql::Connection& db, const ThingTable& table,
                                                  const ListPart& part);

/// Reads a list at once, and where that meets damage row by row.
/// Parameters  at_once  reads the whole part with one query
///             of_row   the record of one row; nothing for one that the list does not want
/// Errors      sql::Failure for other trouble than damage
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
