#include <algorithm>
#include <exception>
#include <iostream>
#include <set>
#include <string>
#include <vector>

#include "storage/ingest/reader_main.hpp"
#include "tests/bench/benchmarks.hpp"

namespace {

using floeplan::bench::Row;

constexpr const char* usage =
    "usage: floeplan_bench [--json] [search | plan | window | avoidance | flight | store]...\n";

struct Group {
  std::string name;
  std::vector<Row> (*measure)();
};

/// In the order of the table.
const std::vector<Group> groups{
    {"search", floeplan::bench::search_rows}, {"plan", floeplan::bench::plan_rows},
    {"window", floeplan::bench::window_rows}, {"avoidance", floeplan::bench::avoidance_rows},
    {"flight", floeplan::bench::flight_rows}, {"store", floeplan::bench::store_rows}};

}  // namespace

/// usage: floeplan_bench [--json] [GROUP...]      without a group all of them
int main(int argc, char** argv) {
  using namespace floeplan::bench;
  std::set<std::string> wanted{argv + 1, argv + argc};
  if (argc > 3 && std::string{argv[1]} == "read-files")  // as the benchmark of ingest starts this program
    return floeplan::ingest::read_foreign_files(argv[2], {argv + 3, argv + argc});
  const bool as_json = wanted.erase("--json") > 0;
  const bool known = std::ranges::all_of(wanted, [](const std::string& name) {
    return std::ranges::find(groups, name, &Group::name) != groups.end();
  });
  if (!known) {
    std::cerr << usage;
    return 2;
  }
  try {
    std::vector<Row> rows;
    for (const Group& group : groups) {
      if (!wanted.empty() && !wanted.contains(group.name)) continue;
      for (Row& row : group.measure()) rows.push_back(std::move(row));
    }
    std::cout << (as_json ? json_text(rows) : table_text(rows));
  } catch (const std::exception& error) {
    std::cerr << "floeplan_bench: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
