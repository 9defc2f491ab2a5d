#pragma once

#include <optional>
#include <string_view>

#include "engine/messages/message.hpp"

namespace floeplan::ingest {

/// Why a file is refused whose format this program knows but does not read; empty when it may be readable.
[[nodiscard]] std::optional<messages::Message> refusal_of_foreign(std::string_view head);

}  // namespace floeplan::ingest
