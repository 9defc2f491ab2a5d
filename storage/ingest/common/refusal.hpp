#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "engine/messages/message.hpp"

namespace floeplan::ingest {

/// Messages about a file: its faults, or what its reader assumed, changed and ignored. All come from the
/// message catalogue.
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

/// The message `told` with the part of the file that it is about ("line 12", "feature 3"). The part begins
/// the text and is one of the message's values.
[[nodiscard]] messages::Message about(const std::string& part, messages::Message told);

/// The faults as text, for another message or for the output of a failed test.
[[nodiscard]] std::string reason_of(const Messages& faults);

}  // namespace floeplan::ingest
