#include "engine/core/executor.hpp"

#include <vector>

namespace floeplan::core {
namespace {

class InOrder : public Executor {
 public:
  void run(std::size_t count, const Piece& piece) const override {
    for (std::size_t i = 0; i < count; ++i) piece(i, true);
  }
};

}  // namespace

void Executor::run_parts(const Parts& parts) const {
  std::vector<std::optional<std::string>> results(parts.count);
  run(parts.count, [&](std::size_t index, bool is_caller) { results[index] = parts.work(index, is_caller); });
  for (std::size_t i = 0; i < parts.count; ++i)
    if (results[i]) parts.take(i, *results[i]);
}

const Executor& in_order() {
  static const InOrder executor;
  return executor;
}

}  // namespace floeplan::core
