#pragma once

#include <array>
#include <cstdint>

namespace floeplan::sql {

/// What a connection sees: while it has the same version, it reads the same. Versions of two connections say nothing of
/// each other. What the numbers mean is the driver's own.
struct Version {
  std::array<std::uint32_t, 12> numbers{};

  friend bool operator==(const Version&, const Version&) = default;
};

}  // namespace floeplan::sql
