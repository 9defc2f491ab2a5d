#include "engine/graph/search_tree.hpp"

#include <algorithm>

namespace floeplan::graph {

std::vector<Vertex> path_to(const GridGraph& graph, const SearchTree& tree, Vertex goal) {
  std::vector<Vertex> path;
  if (!tree.is_reached(goal)) return path;
  Vertex v = goal;
  path.push_back(v);
  while (tree.has_predecessor(v)) {
    v = graph.tail_of(v, tree.step(v));
    path.push_back(v);
  }
  std::ranges::reverse(path);
  return path;
}

}  // namespace floeplan::graph
