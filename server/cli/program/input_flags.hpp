#pragma once

#include <CLI/CLI.hpp>
#include <deque>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "api/fields/field.hpp"
#include "storage/json/json.hpp"

namespace floeplan::cli {

/// The flags of `plan`, `evaluate`, `check` and `reach` that are fields of a process's inputs. They follow from the table of
/// request fields (api/fields) and win over the members of a request file.
class InputFlags {
 public:
  /// The file of which flags are members; `inputs` says whose inputs it holds.
  void add_request(CLI::App& command, const std::string& inputs);
  /// The flag of every field that has one.
  void add(CLI::App& command, const std::vector<fields::Field>& list);

  /// The inputs. Throws CLI::ValidationError (wrong usage) for a flag whose text cannot be read; for a request file
  /// throws what `read_object` does.
  [[nodiscard]] nlohmann::json inputs() const;

 private:
  struct Flag {
    fields::Field field;
    std::variant<bool, std::optional<int>, std::optional<double>, std::optional<std::string>,
                 std::vector<std::string>>
        given;
  };

  std::optional<std::string> request_file_;
  std::deque<Flag> flags_;  // the parser holds on to them
};

/// The JSON object that a file holds; `what` names the file in a message. Throws std::runtime_error when it cannot be
/// read, and BadDataError where the server would not take its text and when it is longer than 16 MB.
[[nodiscard]] nlohmann::json read_object(const std::string& file, const std::string& what);

/// A file as the inputs take it: {"name": ..., "text": ...}. Throws std::runtime_error when it cannot be read.
[[nodiscard]] nlohmann::json file_member(const std::string& file);

}  // namespace floeplan::cli
