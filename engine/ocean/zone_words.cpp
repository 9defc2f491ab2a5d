#include "engine/ocean/zone_words.hpp"

#include <array>
#include <stdexcept>

namespace floeplan::ocean {
namespace {

constexpr auto kind_names = std::to_array<std::string_view>({"kind", "rule", "zonekind"});
constexpr auto name_names = std::to_array<std::string_view>({"name", "title", "label"});
constexpr auto from_names =
    std::to_array<std::string_view>({"from", "validfrom", "start", "begin", "starttime"});
constexpr auto until_names = std::to_array<std::string_view>(
    {"until", "validuntil", "validunti", "validto", "to", "end", "stop", "endtime", "expires"});
constexpr auto top_names =
    std::to_array<std::string_view>({"topm", "top", "mindepth", "mindepthm", "depthmin", "depthminm"});
constexpr auto bottom_names =
    std::to_array<std::string_view>({"bottomm", "bottom", "maxdepth", "maxdepthm", "depthmax", "depthmaxm"});

}  // namespace

std::span<const std::string_view> names_of(ZoneMember member) {
  switch (member) {
    case ZoneMember::kind: return kind_names;
    case ZoneMember::name: return name_names;
    case ZoneMember::from: return from_names;
    case ZoneMember::until: return until_names;
    case ZoneMember::top: return top_names;
    case ZoneMember::bottom: return bottom_names;
  }
  throw std::logic_error{"ZoneMember without names"};
}

}  // namespace floeplan::ocean
