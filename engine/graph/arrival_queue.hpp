#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "engine/graph/grid_graph.hpp"

namespace floeplan::graph {

/// Priority queue of vertices: ascending by key, equal keys by vertex number, so that every run has the same
/// order. Offers INSERT, EXTRACT-MIN and DECREASE-KEY of the paper's Table I. A heap with four children per
/// node: it is flatter than a binary heap and has fewer cache misses.
class ArrivalQueue {
 public:
  explicit ArrivalQueue(std::size_t vertices) : slot_(vertices, absent) {}

  [[nodiscard]] bool empty() const { return heap_.empty(); }
  [[nodiscard]] bool holds(Vertex v) const { return slot_[v] != absent; }
  [[nodiscard]] double smallest_key() const { return heap_.front().key; }

  void insert(Vertex v, double key) {
    heap_.push_back({key, v});
    rise(heap_.size() - 1);
  }

  void decrease_key(Vertex v, double key) {
    heap_[slot_[v]].key = key;
    rise(slot_[v]);
  }

  Vertex extract_min() {
    const Vertex top = heap_.front().vertex;
    slot_[top] = absent;
    const Entry last = heap_.back();
    heap_.pop_back();
    if (!heap_.empty()) sink(last);
    return top;
  }

 private:
  struct Entry {
    double key;
    Vertex vertex;
  };
  static constexpr std::uint32_t absent = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::size_t children = 4;

  static bool before(const Entry& a, const Entry& b) {
    return a.key < b.key || (a.key == b.key && a.vertex < b.vertex);
  }

  void put(std::size_t slot, const Entry& entry) {
    heap_[slot] = entry;
    slot_[entry.vertex] = static_cast<std::uint32_t>(slot);
  }

  void rise(std::size_t slot) {
    const Entry entry = heap_[slot];
    while (slot > 0) {
      const std::size_t parent = (slot - 1) / children;
      if (!before(entry, heap_[parent])) break;
      put(slot, heap_[parent]);
      slot = parent;
    }
    put(slot, entry);
  }

  void sink(const Entry& entry) {
    std::size_t slot = 0;
    for (;;) {
      const std::size_t first = slot * children + 1;
      if (first >= heap_.size()) break;
      std::size_t least = first;
      const std::size_t end = first + children < heap_.size() ? first + children : heap_.size();
      for (std::size_t child = first + 1; child < end; ++child) {
        if (before(heap_[child], heap_[least])) least = child;
      }
      if (!before(heap_[least], entry)) break;
      put(slot, heap_[least]);
      slot = least;
    }
    put(slot, entry);
  }

  std::vector<Entry> heap_;
  std::vector<std::uint32_t> slot_;
};

}  // namespace floeplan::graph
