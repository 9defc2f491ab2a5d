#include "engine/messages/message.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace floeplan::messages {

std::string_view rank_name(Rank rank) {
  switch (rank) {
    case Rank::danger: return "danger";
    case Rank::caution: return "caution";
    case Rank::note: return "note";
  }
  throw std::logic_error{"Rank without a name"};
}

std::optional<Rank> parse_rank(std::string_view name) {
  for (const Rank rank : std::array{Rank::danger, Rank::caution, Rank::note})
    if (rank_name(rank) == name) return rank;
  return std::nullopt;
}

Message Message::at(geo::LonLat where) && {
  place = where;
  return std::move(*this);
}

bool is_grave(const Message& message) { return message.rank == Rank::danger; }

std::vector<Message> by_rank(std::vector<Message> messages) {
  std::ranges::stable_sort(messages, {}, &Message::rank);
  return messages;
}

}  // namespace floeplan::messages
