#pragma once

namespace floeplan::bench {

/// Processor time of a fixed task that does not depend on the product: Dijkstra's search over a million
/// vertices with a binary heap and edge costs from sines and roots, which uses processor and memory like the
/// search of a plan. The ratio of another time to this one should be the same on every machine.
/// Returns  seconds; the smaller of two runs
[[nodiscard]] double calibration_seconds();

}  // namespace floeplan::bench
