#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "engine/messages/message.hpp"

namespace floeplan::ingest {

/// What is told of a file: its faults, or what its reader assumed, changed and left out. Rows of the catalogue.
using Messages = std::vector<messages::Message>;

/// A value, or why the file is refused: a message for each fault.
template <class T>
using Checked = tl::expected<T, Messages>;

[[nodiscard]] inline tl::unexpected<Messages> refuse(Messages faults) {
  return tl::unexpected<Messages>(std::move(faults));
}
[[nodiscard]] inline tl::unexpected<Messages> refuse(messages::Message fault) {
  Messages faults;
  faults.push_back(std::move(fault));
  return refuse(std::move(faults));
}

/// The message for a part of the file, "line 12" or "feature 3": its text begins with the part, which is one of its
/// values.
[[nodiscard]] messages::Message about(const std::string& part, messages::Message told);

/// The faults as text, for another message or for the output of a failed test.
[[nodiscard]] std::string reason_of(const Messages& faults);

}  // namespace floeplan::ingest
