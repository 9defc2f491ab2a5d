#pragma once

/// Limits that the inputs of several processes share.
namespace floeplan::fields {

/// Depth limit of inputs. The Challenger Deep is 10,935 m deep (Greenaway et al. 2021,
/// doi:10.1016/j.dsr.2021.103644).
inline constexpr double deepest_m = 11'000.0;
/// Largest seed; all clients represent integers of this size exactly.
inline constexpr int largest_seed = 2'000'000'000;

}  // namespace floeplan::fields
