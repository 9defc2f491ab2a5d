#include "storage/ingest/readers/velocity/velocity_hints.hpp"

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

std::string doubt_in_title(const std::string& title, const std::string& names, Moving what,
                           CurrentContent content) {
  std::string words = in_words(statistic_in_words(title));
  const bool is_plain_current = what == Moving::sea && content == CurrentContent::whole;
  const CurrentContent by_title = is_plain_current ? content_in_words(lower(title)) : CurrentContent::whole;
  if (words.empty() && by_title != CurrentContent::whole) words = content_words(by_title);
  if (words.empty()) return {};
  return "the title of the file (\"" + title.substr(0, longest_title) +
         (title.size() > longest_title ? "..." : "") + "\") speaks of " + words + ", but " + names +
         " do not say so and were stored as the " + (what == Moving::sea ? "whole current" : "wind") +
         "; if the title is right, they are something else; ask the producer before you plan";
}

std::string statistic_in_group(std::string_view path) {
  const Statistic found = statistic_in_name(path);
  if (found == Statistic::none || found == Statistic::flag || found == Statistic::count) return {};
  return "the data lie in the group " + std::string{path} + " of the file, which by its name holds " +
         in_words(found) +
         "; this is no state that a vehicle or an iceberg meets; give the file of the data themselves, or "
         "give the group another name if its name misleads";
}

std::string part_in_group(std::string_view path) {
  const CurrentContent content = content_in_name(path);
  const std::string words =
      content != CurrentContent::whole ? content_words(content) : part_words(part_in_name(path));
  if (words.empty()) return {};
  return "by its name the group " + std::string{path} + " holds " + words +
         "; its data were stored as they describe themselves; check that this is the current that you want";
}

}  // namespace floeplan::ingest
