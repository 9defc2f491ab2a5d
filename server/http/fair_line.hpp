#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <string>
#include <utility>

namespace floeplan::http {

/// Decides which request gets a handler thread next, if there are fewer threads than requests. Of the waiting
/// clients, the one with the fewest running requests comes first; of several such clients, the one whose last
/// turn is longest ago. No client gets all threads, so another client always finds one free, however long the
/// requests of the first take.
/// Threads  the I/O thread alone
class FairLine {
 public:
  explicit FairLine(std::size_t threads);
  FairLine(const FairLine&) = delete;
  FairLine& operator=(const FairLine&) = delete;

  /// The place of a request in the line. From its turn until it is destroyed, the request occupies a thread.
  class Place {
   public:
    /// `begin`  called at the request's turn; not called if the turn comes immediately
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
  using Rank = std::pair<std::size_t, std::uint64_t>;  // number of running requests, number of the last turn

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
  std::map<std::string, Client> clients_;  // clients with waiting or running requests
  std::map<Rank, Client*> next_;           // clients with waiting requests that may get another thread
};

}  // namespace floeplan::http
