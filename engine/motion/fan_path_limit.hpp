#pragma once

#include "engine/motion/edge_fan.hpp"

namespace floeplan::motion {

/// From now on and in the whole process fan_paths() ends with this path, as on a processor that has no wider one: so it
/// can be shown that plans do not depend on it.
/// Errors   std::invalid_argument for a path that this processor cannot take
/// Threads  to be called before anything is planned
void limit_fan_paths(FanPath widest);

}  // namespace floeplan::motion
