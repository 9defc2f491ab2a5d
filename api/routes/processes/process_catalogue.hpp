#pragma once

#include <string>
#include <vector>

namespace floeplan::routes {

/// What a process gives: an object, or an input of the same name given back.
struct ProcessOutput {
  std::string name;
  std::string title;
};

/// A process as lists show it. Its inputs are described by a schema of the OpenAPI document.
struct ProcessEntry {
  std::string id;
  std::string title;
  std::string description;
  std::string inputs_schema;  // name of the component
  std::vector<ProcessOutput> outputs;
  bool shares_results{true};  // what it gives follows from its inputs and the stored data alone
};

/// Every process, in the order of the list.
[[nodiscard]] const std::vector<ProcessEntry>& all_processes();

/// Null when there is none.
[[nodiscard]] const ProcessEntry* find_process(const std::string& id);

}  // namespace floeplan::routes
