#pragma once

namespace floeplan::bench {

/// Processor time of a fixed piece of work that no change of the product touches: Dijkstra's search over a million
/// vertices with a binary heap, edge costs from sines and roots, as a plan's search takes the processor and the memory.
/// What takes so many times as long as this on one machine should do so on another.
/// Returns  seconds; the least of two runs
[[nodiscard]] double calibration_seconds();

}  // namespace floeplan::bench
