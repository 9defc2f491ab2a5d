#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/messages/message.hpp"
#include "storage/ingest/readers/velocity/velocity_kind.hpp"

namespace floeplan::ingest {

/// What the title of a file says of its velocities that their own words do not say, for the pilot; empty: nothing.
/// `names`    of the components, in quotation marks
/// `content`  of the current, by its own words
[[nodiscard]] std::optional<messages::Message> doubt_in_title(const std::string& title,
                                                              const std::string& names, Moving what,
                                                              CurrentContent content);

/// Why data that lie in a group alone are no state of the sea, the ice or the air by the names in its path
/// ("/statistics/std"); empty: the names do not say so. A flag or a count in such names is of the data beside it.
[[nodiscard]] std::optional<messages::Message> statistic_in_group(std::string_view path);

/// Which part of the current, or of the water, those names speak of, for the pilot; empty: of none.
[[nodiscard]] std::optional<messages::Message> part_in_group(std::string_view path);

}  // namespace floeplan::ingest
