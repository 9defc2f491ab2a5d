#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <string>
#include <utility>

namespace floeplan::http {

/// Who has a thread of the handlers next, when there are fewer threads than requests: of the clients that wait the one with
/// the fewest requests at work, of several the one that has waited longest since its last turn. No client has all threads,
/// so that another one finds a free thread at once, however long the requests of the first take.
/// Threads  the I/O thread alone
class FairLine {
 public:
  explicit FairLine(std::size_t threads);
  FairLine(const FairLine&) = delete;
  FairLine& operator=(const FairLine&) = delete;

  /// A request's place in the line and, from its turn on, its thread, until it is destroyed.
  class Place {
   public:
    /// `begin`  is called when the turn comes; not at all when it has come already
    Place(FairLine& line, const std::string& client, std::function<void()> begin);
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;
    ~Place();

    [[nodiscard]] bool has_begun() const { return has_begun_; }

   private:
    friend class FairLine;

    FairLine& line_;  // borrowed
    std::string client_;
    std::function<void()> begin_;
    bool has_begun_{false};
    std::list<Place*>::iterator waiting_{};
  };

 private:
  using Rank = std::pair<std::size_t, std::uint64_t>;  // requests at work, number of the last turn

  struct Client {
    std::list<Place*> waiting;  // borrowed
    Rank rank;
  };

  void begin(Client& client, Place& place);
  void rank_anew(Client& client, const Rank& rank);
  void serve();

  std::size_t free_;
  std::size_t most_of_client_;
  std::uint64_t turns_{0};
  std::map<std::string, Client> clients_;  // that wait or are at work
  std::map<Rank, Client*> next_;           // those that wait and may have a thread more
};

}  // namespace floeplan::http
