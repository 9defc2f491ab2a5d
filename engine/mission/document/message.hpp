#pragma once

#include <string>
#include <vector>

#include "engine/messages/message.hpp"

namespace floeplan::mission {

enum class Severity { note, warning, error };

/// A message about a line of a file. `line` counts from 1; 0 is the whole file. `code` is stable, for
/// scripts.
struct Message {
  int line{};
  Severity severity{};
  std::string code;
  std::string text;

  friend bool operator==(const Message&, const Message&) = default;
};

using Messages = std::vector<Message>;

/// The message of the catalogue for a line: a danger becomes an error, a caution a warning. The code is cut
/// at the slash, which only distinguishes variants of one message.
[[nodiscard]] Message finding(int line, const messages::Message& message);

/// Whether a file may be used for a plan: notes alone leave it `ok`, a warning makes it `warn`, an error
/// `reject`.
enum class Verdict { ok, warn, reject };

[[nodiscard]] Verdict verdict_of(const Messages& messages);
[[nodiscard]] std::string severity_name(Severity severity);
[[nodiscard]] std::string verdict_name(Verdict verdict);

}  // namespace floeplan::mission
