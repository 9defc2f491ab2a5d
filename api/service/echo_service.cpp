#include "api/service/echo_service.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace floeplan::service {

nlohmann::json echo_results(const codec::EchoInputs& inputs, const std::stop_token& stop,
                            const core::ProgressCallback& progress) {
  constexpr core::Seconds step{0.25};
  std::mutex mutex;
  std::condition_variable_any never;
  for (core::Seconds waited{}; waited < inputs.pause && !stop.stop_requested(); waited += step) {
    if (progress) progress("pausing", waited / inputs.pause);
    std::unique_lock lock{mutex};
    never.wait_for(lock, stop, step, [] { return false; });
  }
  return inputs.values;
}

}  // namespace floeplan::service
