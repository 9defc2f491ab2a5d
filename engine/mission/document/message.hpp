#pragma once

#include <string>
#include <vector>

#include "engine/messages/message.hpp"

namespace floeplan::mission {

enum class Severity { note, warning, error };

/// What a reader noticed. `line` counts from 1; 0 means the file as a whole. `code` is stable, for scripts.
struct Message {
  int line{};
  Severity severity{};
  std::string code;
  std::string text;

  friend bool operator==(const Message&, const Message&) = default;
};

using Messages = std::vector<Message>;

/// What the catalogue says of a line: a danger is an error, a caution a warning. A code ends before the slash that tells
/// rows of the same code apart.
[[nodiscard]] Message finding(int line, const messages::Message& message);

/// Whether a file may become a plan: notes alone leave it `ok`, a warning makes it `warn`, an error `reject`.
enum class Verdict { ok, warn, reject };

[[nodiscard]] Verdict verdict_of(const Messages& messages);
[[nodiscard]] std::string severity_name(Severity severity);
[[nodiscard]] std::string verdict_name(Verdict verdict);

}  // namespace floeplan::mission
