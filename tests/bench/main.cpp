#include <exception>
#include <iostream>
#include <string_view>

#include "tests/bench/benchmarks.hpp"

/// usage: floeplan_bench [--json]
int main(int argc, char** argv) {
  using namespace floeplan::bench;
  const bool as_json = argc == 2 && std::string_view{argv[1]} == "--json";
  if (argc > 2 || (argc == 2 && !as_json)) {
    std::cerr << "usage: floeplan_bench [--json]\n";
    return 2;
  }
  try {
    std::vector<Row> rows = search_rows();
    for (const auto& more : {plan_rows(), window_rows(), avoidance_rows(), flight_rows()})
      rows.insert(rows.end(), more.begin(), more.end());
    std::cout << (as_json ? json_text(rows) : table_text(rows));
  } catch (const std::exception& error) {
    std::cerr << "floeplan_bench: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
