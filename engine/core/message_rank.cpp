#include "engine/core/message_rank.hpp"

#include <algorithm>
#include <iterator>

namespace floeplan::core {

std::string as_danger(std::string_view text) { return std::string{danger_mark} + std::string{text}; }

bool is_danger(std::string_view sentence) { return sentence.starts_with(danger_mark); }

std::string without_mark(std::string_view sentence) {
  return std::string{is_danger(sentence) ? sentence.substr(danger_mark.size()) : sentence};
}

std::vector<std::string> dangers_among(const std::vector<std::string>& sentences) {
  std::vector<std::string> dangers;
  std::ranges::copy_if(sentences, std::back_inserter(dangers), is_danger);
  return dangers;
}

std::vector<std::string> by_rank(std::vector<std::string> sentences) {
  std::ranges::stable_partition(sentences, is_danger);
  return sentences;
}

}  // namespace floeplan::core
