#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.hpp"

namespace floeplan::support {

/// The output and the exit code of a run of the program.
struct Outcome {
  int exit_code{};
  std::string out;
  std::string err;

  [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out, nullptr, false); }
};

/// The real program on a store of its own.
class Program {
 public:
  Program() { std::filesystem::create_directory(store()); }

  [[nodiscard]] Outcome run(const std::vector<std::string>& arguments) const;
  /// The program with exactly these words, which name the store if it needs one.
  [[nodiscard]] Outcome run_alone(std::vector<std::string> words) const;
  [[nodiscard]] std::filesystem::path folder() const { return folder_.path(); }
  [[nodiscard]] std::filesystem::path store() const { return folder_.path() / "store"; }

 private:
  TemporaryFolder folder_;
};

/// A file of the shared samples; tests that need one skip where it is not there.
[[nodiscard]] std::filesystem::path shared_sample(const std::string& name);

}  // namespace floeplan::support
