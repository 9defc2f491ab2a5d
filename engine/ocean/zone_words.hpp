#pragma once

#include <span>
#include <string_view>

namespace floeplan::ocean {

/// What a zone states beside its outline.
enum class ZoneMember { kind, name, from, until, top, bottom };

/// The names under which tables and map programs hold it, as `core::plain_word` has them; also those that a shapefile
/// cuts after ten letters.
[[nodiscard]] std::span<const std::string_view> names_of(ZoneMember member);

}  // namespace floeplan::ocean
