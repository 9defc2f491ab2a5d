#include "storage/sandbox/confinement.hpp"

#include <iterator>
#include <stdexcept>

#include "storage/sandbox/system_call_filter.hpp"

namespace floeplan::sandbox {
namespace {

constexpr int least_landlock = 2;

/// Landlock confines only the calling thread and threads that it starts later.
void refuse_other_threads() {
#if !defined(__SANITIZE_THREAD__)
  const std::filesystem::directory_iterator threads{"/proc/self/task"};
  if (std::distance(begin(threads), end(threads)) != 1)
    throw std::runtime_error{"the process that reads files runs several threads before it is confined"};
#endif
}

}  // namespace

bool is_enough(const Layers& layers) { return layers.system_calls && layers.landlock >= least_landlock; }

std::string to_text(const Layers& layers) {
  const std::string landlock =
      layers.landlock > 0 ? "Landlock " + std::to_string(layers.landlock) : "no Landlock";
  return (layers.system_calls ? "seccomp, " : "no seccomp, ") + landlock;
}

Layers confine(const FileNeeds& needs) {
  refuse_other_threads();
  const int landlock = restrict_files(needs);  // first, because the filter forbids the calls for it
  return {.system_calls = restrict_system_calls(), .landlock = landlock};
}

}  // namespace floeplan::sandbox
