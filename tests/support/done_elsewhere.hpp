#pragma once

#include <map>
#include <string>
#include <utility>

#include "engine/core/executor.hpp"

namespace floeplan::support {

/// The results of the parts of a job, stage by stage, as another process had them.
using KeptParts = std::map<std::pair<std::size_t, std::size_t>, std::string>;  // by stage and part

/// Does all parts itself and keeps their results.
class KeepsParts final : public core::Executor {
 public:
  explicit KeepsParts(KeptParts& kept) : kept_{kept} {}

  void run(std::size_t count, const Piece& piece) const override { core::in_order().run(count, piece); }
  void run_parts(const Parts& parts) const override {
    ++stage_;
    for (std::size_t i = 0; i < parts.count; ++i) {
      const auto result = parts.work(i, true);
      if (!result) continue;
      kept_[{stage_, i}] = *result;
      parts.take(i, *result);
    }
  }

 private:
  KeptParts& kept_;
  mutable std::size_t stage_{0};
};

/// Does no part: passes on the kept results, the last part first.
class DoneElsewhere final : public core::Executor {
 public:
  explicit DoneElsewhere(const KeptParts& kept) : kept_{kept} {}

  void run(std::size_t count, const Piece& piece) const override { core::in_order().run(count, piece); }
  void run_parts(const Parts& parts) const override {
    ++stage_;
    for (std::size_t i = parts.count; i-- > 0;) parts.take(i, kept_.at({stage_, i}));
  }

 private:
  const KeptParts& kept_;
  mutable std::size_t stage_{0};
};

}  // namespace floeplan::support
