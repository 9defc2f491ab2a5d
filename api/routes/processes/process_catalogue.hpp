#pragma once

#include <string>
#include <vector>

namespace floeplan::routes {

/// An output of a process: an object, or an input that is returned under its name.
struct ProcessOutput {
  std::string name;
  std::string title;
};

/// A process in lists. A schema of the OpenAPI document describes its inputs.
struct ProcessEntry {
  std::string id;
  std::string title;
  std::string description;
  std::string inputs_schema;  // name of the schema component
  std::vector<ProcessOutput> outputs;
  // the result depends only on the inputs and the stored data, so that jobs can share it
  bool shares_results{true};
};

/// All processes, in the order in which they are listed.
[[nodiscard]] const std::vector<ProcessEntry>& all_processes();

/// The process with this id; null if there is none.
[[nodiscard]] const ProcessEntry* find_process(const std::string& id);

}  // namespace floeplan::routes
