#include "server/http/fair_line.hpp"

#include <algorithm>

namespace floeplan::http {

FairLine::FairLine(std::size_t threads)
    : free_{threads}, most_of_client_{std::max<std::size_t>(threads, 2) - 1} {}

FairLine::Place::Place(FairLine& line, const std::string& client, std::function<void()> begin)
    : line_{line}, client_{client}, begin_{std::move(begin)} {
  const auto [found, is_new] = line_.clients_.try_emplace(client_);
  Client& own = found->second;
  if (is_new) own.rank = {0, ++line_.turns_};
  if (own.waiting.empty() && own.rank.first < line_.most_of_client_ && line_.free_ > 0) {
    line_.begin(own, *this);
    return;
  }
  waiting_ = own.waiting.insert(own.waiting.end(), this);
  line_.rank_anew(own, own.rank);
}

FairLine::Place::~Place() {
  const auto found = line_.clients_.find(client_);
  Client& own = found->second;
  Rank rank = own.rank;
  if (has_begun_) {
    ++line_.free_;
    --rank.first;
  } else {
    own.waiting.erase(waiting_);
  }
  line_.rank_anew(own, rank);
  if (own.waiting.empty() && rank.first == 0) line_.clients_.erase(found);
  line_.serve();
}

void FairLine::begin(Client& client, Place& place) {
  --free_;
  place.has_begun_ = true;
  rank_anew(client, {client.rank.first + 1, ++turns_});
}

void FairLine::rank_anew(Client& client, const Rank& rank) {
  next_.erase(client.rank);
  client.rank = rank;
  if (!client.waiting.empty() && rank.first < most_of_client_) next_.emplace(rank, &client);
}

void FairLine::serve() {
  while (free_ > 0 && !next_.empty()) {
    Client& client = *next_.begin()->second;
    Place& place = *client.waiting.front();
    client.waiting.pop_front();
    begin(client, place);
    place.begin_();
  }
}

}  // namespace floeplan::http
