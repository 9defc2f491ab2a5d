#include "storage/ingest/readers/velocity/velocity_hints.hpp"

#include "engine/messages/ingest_velocity_messages.hpp"
#include "storage/ingest/formats/netcdf/variable_meaning.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/velocity/velocity_meaning.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::size_t longest_title = 120;

std::string part_words(WaterPart part) {
  switch (part) {
    case WaterPart::unstated: return {};
    case WaterPart::surface: return "the surface alone";
    case WaterPart::column_mean: return "means over the water column";
    case WaterPart::bed: return "the current at the sea bed";
  }
  return {};
}

}  // namespace

std::optional<messages::Message> doubt_in_title(const std::string& title, const std::string& names,
                                                Moving what, CurrentContent content) {
  std::string words = in_words(statistic_in_words(title));
  const bool is_plain_current = what == Moving::sea && content == CurrentContent::whole;
  const CurrentContent by_title = is_plain_current ? content_in_words(lower(title)) : CurrentContent::whole;
  if (words.empty() && by_title != CurrentContent::whole) words = content_words(by_title);
  if (words.empty()) return std::nullopt;
  const bool whole = title.size() <= longest_title;
  return messages::ingest_velocity_message<"title-contradicts">(
      title.substr(0, longest_title) + (whole ? "" : "..."), words, names,
      what == Moving::sea ? "whole current" : "wind");
}

std::optional<messages::Message> statistic_in_group(std::string_view path) {
  const Statistic found = statistic_in_name(path);
  if (found == Statistic::none || found == Statistic::flag || found == Statistic::count) return std::nullopt;
  return messages::ingest_velocity_message<"group-of-statistics">(path, in_words(found));
}

std::optional<messages::Message> part_in_group(std::string_view path) {
  const CurrentContent content = content_in_name(path);
  const std::string words =
      content != CurrentContent::whole ? content_words(content) : part_words(part_in_name(path));
  if (words.empty()) return std::nullopt;
  return messages::ingest_velocity_message<"group-of-a-part">(path, words);
}

}  // namespace floeplan::ingest
