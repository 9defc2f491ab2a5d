#include "engine/planning/refinement/thinning.hpp"

namespace floeplan::planning::refinement {

std::vector<int> count_pieces(const cost::Itinerary& timed, std::size_t wanted) {
  std::vector<int> pieces(timed.route.legs(), 1);
  for (std::size_t count = pieces.size(); count < wanted; ++count) {
    std::size_t longest = 0;
    core::Seconds longest_piece{-1.0};
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const core::Seconds piece = (timed.times[i + 1] - timed.times[i]) / pieces[i];
      if (piece > longest_piece) {
        longest = i;
        longest_piece = piece;
      }
    }
    ++pieces[longest];
  }
  return pieces;
}

}  // namespace floeplan::planning::refinement
