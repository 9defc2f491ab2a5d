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

/// The flags of `plan`, `evaluate`, `check` and `reach` that set fields of a process's inputs. They are
/// derived from the table of request fields (api/fields) and have priority over the members of a request
/// file.
class InputFlags {
 public:
  /// Adds the flag for a request file; `inputs` names the process whose inputs it contains, for the help.
  void add_request(CLI::App& command, const std::string& inputs);
  /// Adds the flags of all fields that have one.
  void add(CLI::App& command, const std::vector<fields::Field>& list);

  /// The inputs. Throws CLI::ValidationError (wrong usage) for a flag with an invalid text, and the errors of
  /// `read_object` for a request file.
  [[nodiscard]] nlohmann::json inputs() const;

 private:
  struct Flag {
    fields::Field field;
    std::variant<bool, std::optional<int>, std::optional<double>, std::optional<std::string>,
                 std::vector<std::string>>
        given;
  };

  std::optional<std::string> request_file_;
  std::deque<Flag> flags_;  // a deque, because the parser keeps references to its elements
};

/// Reads a JSON object from a file; `what` names the file in messages. Throws std::runtime_error when the
/// file cannot be read, and BadDataError when it is longer than 16 MB or the server would refuse its text.
[[nodiscard]] nlohmann::json read_object(const std::string& file, const std::string& what);

/// A file in the form of an input: {"name": ..., "text": ...}. Throws std::runtime_error when it cannot be
/// read.
[[nodiscard]] nlohmann::json file_member(const std::string& file);

}  // namespace floeplan::cli
