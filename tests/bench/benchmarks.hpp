#pragma once

#include <vector>

#include "tests/bench/report.hpp"

namespace floeplan::bench {

/// The search itself: edges, all arrivals on a million vertices beside the Boost Graph Library's, memory, growth.
std::vector<Row> search_rows();
/// What the product does: its edge cost, and whole plans by each method.
std::vector<Row> plan_rows();
/// A window of departures beside plans for each of them alone.
std::vector<Row> window_rows();
/// Whole requests of the command line on the demonstration data, each a process of its own, beside the calibration loop.
/// The program `floeplan` must lie beside this one.
std::vector<Row> request_rows();
/// Steps of the obstacle avoidance system on board: the longest, and the usual one.
std::vector<Row> avoidance_rows();
/// A glider in the simulator, bare and with all its sensors, and a batch of flights on all cores.
std::vector<Row> flight_rows();
/// A gigabyte of currents on its way into the store and out of it, beside GDAL. The program must be its own reader of
/// foreign files.
std::vector<Row> store_rows();

}  // namespace floeplan::bench
