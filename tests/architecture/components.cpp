#include "tests/architecture/components.hpp"

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>

namespace floeplan::support {
namespace {

namespace fs = std::filesystem;
using Graph = std::map<std::string, std::set<std::string>>;

std::vector<fs::path> code_files(const fs::path& root, const std::vector<std::string>& layers) {
  std::vector<fs::path> files;
  for (const std::string& layer : layers) {
    for (const auto& entry : fs::recursive_directory_iterator{root / layer}) {
      const fs::path ending = entry.path().extension();
      if (ending == ".hpp" || ending == ".cpp") files.push_back(entry.path().lexically_relative(root));
    }
  }
  std::ranges::sort(files);
  return files;
}

std::string component_of(fs::path file) { return file.replace_extension().generic_string(); }

Graph includes_of_components(const fs::path& root) {
  static const std::regex include_line{R"(\s*#\s*include\s*"([^"]+)\.hpp".*)"};
  Graph graph;
  const std::vector<fs::path> files = code_files(root, {"engine", "storage", "api", "server"});
  for (const fs::path& file : files) graph[component_of(file)];
  for (const fs::path& file : files) {
    std::ifstream lines{root / file};
    for (std::string line; std::getline(lines, line);) {
      std::smatch parts;
      if (!std::regex_match(line, parts, include_line)) continue;
      if (parts[1] != component_of(file) && graph.contains(parts[1]))
        graph[component_of(file)].insert(parts[1]);
    }
  }
  return graph;
}

/// Finds the strongly connected components of a graph (Tarjan).
class Rings {
 public:
  explicit Rings(const Graph& graph) : graph_{graph} {
    for (const auto& [component, includes] : graph) {
      if (!number_.contains(component)) visit(component);
    }
    std::ranges::sort(rings_);
  }
  [[nodiscard]] const std::vector<std::string>& found() const { return rings_; }

 private:
  void visit(const std::string& component) {
    const auto number = number_.size();
    number_[component] = lowest_[component] = number;
    open_.push_back(component);
    for (const std::string& next : graph_.at(component)) {
      if (!number_.contains(next)) {
        visit(next);
        lowest_[component] = std::min(lowest_[component], lowest_[next]);
      } else if (std::ranges::find(open_, next) != open_.end()) {
        lowest_[component] = std::min(lowest_[component], number_[next]);
      }
    }
    if (lowest_[component] == number) close(component);
  }

  void close(const std::string& first) {
    const auto begin = std::ranges::find(open_, first);
    std::vector<std::string> ring(begin, open_.end());
    open_.erase(begin, open_.end());
    if (ring.size() < 2) return;
    std::ranges::sort(ring);
    std::string line;
    for (const std::string& component : ring) line += (line.empty() ? "" : " ") + component;
    rings_.push_back(std::move(line));
  }

  const Graph& graph_;
  std::map<std::string, std::size_t> number_{};  // index of each component, in the order of the visits
  std::map<std::string, std::size_t> lowest_{};  // lowest index that can be reached from it
  std::vector<std::string> open_{};
  std::vector<std::string> rings_{};
};

}  // namespace

std::vector<std::string> include_rings(const fs::path& root) {
  return Rings{includes_of_components(root)}.found();
}

std::map<std::string, int> code_files_by_folder(const fs::path& root) {
  std::map<std::string, int> counts;
  for (const fs::path& file : code_files(root, {"engine", "storage", "api", "server", "tests"}))
    ++counts[file.parent_path().generic_string()];
  return counts;
}

}  // namespace floeplan::support
