#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace floeplan::http {

/// Counts objects, for each client and in all.
/// Threads  the I/O thread alone
class ClientCounts {
 public:
  [[nodiscard]] std::size_t all() const { return all_; }
  [[nodiscard]] std::size_t of(const std::string& client) const {
    const auto found = of_client_.find(client);
    return found == of_client_.end() ? 0 : found->second;
  }

  /// Counts as one object while it lives.
  class One {
   public:
    One(ClientCounts& counts, const std::string& client)
        : counts_{counts}, own_{counts.of_client_.try_emplace(client, 0).first} {
      ++counts_.all_;
      ++own_->second;
    }
    One(const One&) = delete;
    One& operator=(const One&) = delete;
    ~One() {
      --counts_.all_;
      if (--own_->second == 0) counts_.of_client_.erase(own_);
    }

   private:
    ClientCounts& counts_;  // borrowed
    std::map<std::string, std::size_t>::iterator own_;
  };

 private:
  std::size_t all_{0};
  std::map<std::string, std::size_t> of_client_;
};

}  // namespace floeplan::http
