#pragma once

#include <vector>

#include "tests/bench/report.hpp"

namespace floeplan::bench {

/// The search alone: edges; all arrivals on a million vertices compared with the Boost Graph Library; memory;
/// growth.
std::vector<Row> search_rows();
/// The planner: its edge cost, and whole plans by each method.
std::vector<Row> plan_rows();
/// A window of departures compared with separate plans for each of them.
std::vector<Row> window_rows();
/// Whole requests of the command line on the demonstration data, each in its own process, compared with the
/// calibration loop. The program `floeplan` must be in the same folder as this one.
std::vector<Row> request_rows();
/// Steps of the obstacle avoidance system on board: the longest, and a typical one.
std::vector<Row> avoidance_rows();
/// Simulation of a glider, without and with all its sensors, and a batch of flights on all cores.
std::vector<Row> flight_rows();
/// Writing a gigabyte of currents to the store and reading it, compared with GDAL. The program must be its
/// own reader process for foreign files.
std::vector<Row> store_rows();

}  // namespace floeplan::bench
