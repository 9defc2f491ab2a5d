#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/messages/message.hpp"
#include "storage/ingest/readers/velocity/velocity_kind.hpp"

namespace floeplan::ingest {

/// A warning for the pilot if a file's title says something about its velocities that the variables do not;
/// empty if not.
/// `names`    names of the components, in quotation marks
/// `content`  part of the current, according to the variables
[[nodiscard]] std::optional<messages::Message> doubt_in_title(const std::string& title,
                                                              const std::string& names, Moving what,
                                                              CurrentContent content);

/// Why data in a group are not the state of the sea, the ice or the air, if names in the group's path say so
/// ("/statistics/std"); otherwise empty. A flag or a count in such names does not count: it refers to data
/// beside it.
[[nodiscard]] std::optional<messages::Message> statistic_in_group(std::string_view path);

/// A message for the pilot about the part of the current, or of the water, in the names of a group's path;
/// empty if none.
[[nodiscard]] std::optional<messages::Message> part_in_group(std::string_view path);

}  // namespace floeplan::ingest
