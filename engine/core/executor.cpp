#include "engine/core/executor.hpp"

namespace floeplan::core {
namespace {

class InOrder : public Executor {
 public:
  void run(std::size_t count, const Piece& piece) const override {
    for (std::size_t i = 0; i < count; ++i) piece(i, true);
  }
};

}  // namespace

const Executor& in_order() {
  static const InOrder executor;
  return executor;
}

}  // namespace floeplan::core
