#include "server/cli/program/interruption.hpp"

#include <cstdlib>
#include <ctime>

namespace floeplan::cli {
namespace {

constexpr timespec look_every{.tv_sec = 0, .tv_nsec = 20'000'000};
constexpr int ended_by_signal = 128;  // shells add the number of the signal to this

}  // namespace

Interruption::Interruption() {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals_, &before_);
  waiting_ = std::jthread{[this](const std::stop_token& over) { wait(over); }};
}

Interruption::~Interruption() {
  waiting_.request_stop();
  waiting_.join();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void Interruption::wait(const std::stop_token& over) {
  while (!over.stop_requested()) {
    const int signal = sigtimedwait(&signals_, nullptr, &look_every);
    if (signal <= 0) continue;
    if (stop_.stop_requested()) std::_Exit(ended_by_signal + signal);
    stop_.request_stop();
  }
}

}  // namespace floeplan::cli
