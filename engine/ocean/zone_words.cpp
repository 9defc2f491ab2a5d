#include "engine/ocean/zone_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/letter_case.hpp"

namespace floeplan::ocean {
namespace {

/// Meanings that a word in an attribute's name can have.
enum class Sense {
  begin,
  end,
  least,
  most,
  upper,
  lower,
  depth,
  height,
  clock,      // a date or time
  validity,   // that a rule holds for a time
  effective,  // valid from then on
  first,      // with a date or time: begin
  last,       // the same: end
  turning,    // beginning or end, depending on the other words
  rule,
  type,
  place,   // the zone itself, or an activity there
  extent,  // the limit of something
  unit,
  called,
  record,  // who wrote the data down, and when
  cut,     // beginning of several words with different meanings
  unknown
};

struct Word {
  std::string_view text;
  Sense sense;
};

constexpr auto words = std::to_array<Word>({
    {"begin", Sense::begin},
    {"begins", Sense::begin},
    {"beginning", Sense::begin},
    {"beg", Sense::begin},
    {"start", Sense::begin},
    {"starts", Sense::begin},
    {"starting", Sense::begin},
    {"from", Sense::begin},
    {"since", Sense::begin},
    {"commence", Sense::begin},
    {"commences", Sense::begin},
    {"commencement", Sense::begin},
    {"end", Sense::end},
    {"ends", Sense::end},
    {"ending", Sense::end},
    {"until", Sense::end},
    {"till", Sense::end},
    {"through", Sense::end},
    {"thru", Sense::end},
    {"to", Sense::end},
    {"stop", Sense::end},
    {"stops", Sense::end},
    {"finish", Sense::end},
    {"finishes", Sense::end},
    {"expire", Sense::end},
    {"expires", Sense::end},
    {"expired", Sense::end},
    {"expiry", Sense::end},
    {"expiration", Sense::end},
    {"exp", Sense::end},
    {"min", Sense::least},
    {"minimum", Sense::least},
    {"shallowest", Sense::least},
    {"max", Sense::most},
    {"maximum", Sense::most},
    {"deepest", Sense::most},
    {"top", Sense::upper},
    {"upper", Sense::upper},
    {"bottom", Sense::lower},
    {"lower", Sense::lower},
    {"depth", Sense::depth},
    {"depths", Sense::depth},
    {"altitude", Sense::height},
    {"elevation", Sense::height},
    {"height", Sense::height},
    {"date", Sense::clock},
    {"dates", Sense::clock},
    {"datetime", Sense::clock},
    {"time", Sense::clock},
    {"timestamp", Sense::clock},
    {"day", Sense::clock},
    {"days", Sense::clock},
    {"month", Sense::clock},
    {"mo", Sense::clock},
    {"year", Sense::clock},
    {"yr", Sense::clock},
    {"dt", Sense::clock},
    {"utc", Sense::clock},
    {"gmt", Sense::clock},
    {"valid", Sense::validity},
    {"validity", Sense::validity},
    {"active", Sense::validity},
    {"period", Sense::validity},
    {"timespan", Sense::validity},
    {"span", Sense::validity},
    {"interval", Sense::validity},
    {"force", Sense::validity},
    {"applies", Sense::validity},
    {"season", Sense::validity},
    {"months", Sense::validity},
    {"duration", Sense::validity},
    {"effective", Sense::effective},
    {"eff", Sense::effective},
    {"first", Sense::first},
    {"last", Sense::last},
    {"open", Sense::turning},
    {"opens", Sense::turning},
    {"opening", Sense::turning},
    {"closes", Sense::turning},
    {"closing", Sense::turning},
    {"kind", Sense::rule},
    {"rule", Sense::rule},
    {"type", Sense::type},
    {"class", Sense::type},
    {"category", Sense::type},
    {"restriction", Sense::type},
    {"restrictions", Sense::type},
    {"regulation", Sense::type},
    {"access", Sense::type},
    {"zone", Sense::place},
    {"area", Sense::place},
    {"region", Sense::place},
    {"polygon", Sense::place},
    {"fence", Sense::place},
    {"closure", Sense::place},
    {"closed", Sense::place},
    {"ban", Sense::place},
    {"in", Sense::place},
    {"is", Sense::place},
    {"of", Sense::place},
    {"the", Sense::place},
    {"limit", Sense::extent},
    {"bound", Sense::extent},
    {"level", Sense::extent},
    {"range", Sense::extent},
    {"m", Sense::unit},
    {"cm", Sense::unit},
    {"metres", Sense::unit},
    {"meters", Sense::unit},
    {"ft", Sense::unit},
    {"feet", Sense::unit},
    {"fathoms", Sense::unit},
    {"fm", Sense::unit},
    {"km", Sense::unit},
    {"name", Sense::called},
    {"title", Sense::called},
    {"label", Sense::called},
    {"created", Sense::record},
    {"creation", Sense::record},
    {"creator", Sense::record},
    {"edit", Sense::record},
    {"edited", Sense::record},
    {"editor", Sense::record},
    {"update", Sense::record},
    {"updated", Sense::record},
    {"modified", Sense::record},
    {"added", Sense::record},
    {"entered", Sense::record},
    {"revised", Sense::record},
    {"revision", Sense::record},
    {"published", Sense::record},
    {"publication", Sense::record},
    {"pub", Sense::record},
    {"issue", Sense::record},
    {"issued", Sense::record},
    {"survey", Sense::record},
    {"source", Sense::record},
    {"record", Sense::record},
    {"lifespan", Sense::record},
    {"version", Sense::record},
    {"designation", Sense::record},
    {"designated", Sense::record},
    {"desig", Sense::record},
    {"established", Sense::record},
    {"signed", Sense::record},
    {"approved", Sense::record},
    {"today", Sense::record},
});

/// Attributes of S-57. They are never cut short.
constexpr auto acronyms = std::to_array<Word>({
    {"datsta", Sense::begin},
    {"persta", Sense::begin},
    {"datend", Sense::end},
    {"perend", Sense::end},
    {"restrn", Sense::type},
    {"sordat", Sense::record},
});

/// Shorter parts of letters written together are not recognised: they could be anything.
constexpr std::size_t shortest_joined = 3;
constexpr std::size_t shapefile_name = 10;  // letters; dBASE III stores no more

std::optional<Word> word_of(std::string_view text) {
  const auto* const found = std::ranges::find(words, text, &Word::text);
  if (found != words.end()) return *found;
  const auto* const acronym = std::ranges::find(acronyms, text, &Word::text);
  return acronym != acronyms.end() ? std::optional{*acronym} : std::nullopt;
}

/// A word for all known words that begin with this text; empty: their meanings differ, or there are none.
std::optional<Word> word_that_begins(std::string_view text) {
  std::optional<Word> common;
  for (const Word& word : words) {
    if (!word.text.starts_with(text)) continue;
    const bool differs = common && (common->sense != word.sense || word.sense == Sense::unit);
    if (differs) return Word{"", Sense::cut};
    common = word;
  }
  return common;
}

/// The parts of a name: "ValidTo_2" gives "valid", "to".
std::vector<std::string> parts_of(std::string_view name) {
  const auto is = [&](int (*kind)(int), std::size_t i) {
    return i < name.size() && kind(static_cast<unsigned char>(name[i])) != 0;
  };
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!is(std::isalpha, i)) continue;
    const bool follows = i > 0 && is(std::isalpha, i - 1);
    const bool hump = is(std::isupper, i) && (is(std::islower, i - 1) || is(std::islower, i + 1));
    if (!follows || hump) parts.emplace_back();
    parts.back() += name[i];
  }
  for (std::string& part : parts) part = core::lower_case(part);
  return parts;
}

/// The known words that letters written together consist of, longest matches first; empty: they do not.
/// `may_be_cut`: the last word may be incomplete.
std::vector<Word> words_in(std::string_view letters, bool may_be_cut) {
  for (std::size_t length = letters.size(); length > 0; --length) {
    const std::string_view first = letters.substr(0, length);
    const std::string_view rest = letters.substr(length);
    const bool is_short = length < shortest_joined && first != "to" && first != "m";
    const auto word = is_short && !rest.empty() ? std::nullopt : word_of(first);
    if (!word) continue;
    if (rest.empty()) return {*word};
    auto others = words_in(rest, may_be_cut);
    if (others.empty()) continue;
    others.insert(others.begin(), *word);
    return others;
  }
  if (!may_be_cut) return {};
  const auto beginning = word_that_begins(letters);
  return beginning ? std::vector{*beginning} : std::vector<Word>{};
}

/// The words of a name, sorted by what they can mean.
class Senses {
 public:
  explicit Senses(std::string_view name) {
    const auto parts = parts_of(name);
    const bool may_be_cut = name.size() == shapefile_name;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto found = words_in(parts[i], may_be_cut && i + 1 == parts.size());
      words_.insert(words_.end(), found.begin(), found.end());
      if (found.empty()) words_.push_back({"", Sense::unknown});
    }
    const bool was_cut =
        may_be_cut && (name.ends_with('_') || std::isdigit(static_cast<unsigned char>(name.back())) != 0);
    if (was_cut) words_.push_back({"", Sense::cut});
  }

  [[nodiscard]] bool has(Sense sense) const { return std::ranges::count(words_, sense, &Word::sense) > 0; }
  template <class... Allowed>
  [[nodiscard]] bool are_only(Allowed... allowed) const {
    return std::ranges::all_of(words_, [&](const Word& word) { return ((word.sense == allowed) || ...); });
  }
  [[nodiscard]] std::size_t count() const { return words_.size(); }
  [[nodiscard]] std::string_view text_of(Sense sense) const {
    const auto found = std::ranges::find(words_, sense, &Word::sense);
    return found != words_.end() ? found->text : std::string_view{};
  }

 private:
  std::vector<Word> words_;
};

/// The meaning of a name about depths; `nothing` if it is not about depths.
AttributeMeaning depth_meant(const Senses& senses) {
  using enum AttributeMeaning;
  const bool known = senses.are_only(Sense::depth, Sense::upper, Sense::lower, Sense::least, Sense::most,
                                     Sense::begin, Sense::end, Sense::unit, Sense::place, Sense::extent);
  const bool of_depth = senses.has(Sense::depth);
  const bool is_top =
      senses.has(Sense::upper) || (of_depth && (senses.has(Sense::least) || senses.has(Sense::begin)));
  const bool is_bottom =
      senses.has(Sense::lower) || (of_depth && (senses.has(Sense::most) || senses.has(Sense::end)));
  if (senses.has(Sense::height) &&
      (is_top || is_bottom || senses.has(Sense::least) || senses.has(Sense::most)))
    return unclear_depth;
  if (!known) return of_depth ? unclear_depth : nothing;
  if (is_top && is_bottom)
    return of_depth && !senses.has(Sense::upper) && !senses.has(Sense::lower) ? depths : unclear_depth;
  if (is_top) return top;
  if (is_bottom) return bottom;
  if (!of_depth) return nothing;
  return senses.has(Sense::least) || senses.has(Sense::most) ? unclear_depth : depths;
}

/// The meaning of a name about times; `nothing` if it is not about times.
AttributeMeaning time_meant(const Senses& senses) {
  using enum AttributeMeaning;
  const bool holds = senses.has(Sense::validity);
  if (senses.has(Sense::record))
    return senses.has(Sense::begin) || senses.has(Sense::end) || holds ? some_date : record;
  const bool is_dated = senses.has(Sense::clock) || holds || senses.has(Sense::effective);
  const auto is_side = [&](Sense side, Sense ordinal, Sense bound) {
    return senses.has(side) || (is_dated && (senses.has(ordinal) || senses.has(bound)));
  };
  const bool begins = is_side(Sense::begin, Sense::first, Sense::least);
  const bool ends = is_side(Sense::end, Sense::last, Sense::most);
  if (senses.has(Sense::turning)) return unclear_period;
  const bool known = senses.are_only(Sense::begin, Sense::end, Sense::first, Sense::last, Sense::least,
                                     Sense::most, Sense::clock, Sense::validity, Sense::effective,
                                     Sense::rule, Sense::type, Sense::place, Sense::extent);
  if (begins && ends) return known ? period : unclear_period;
  if (begins || ends) {
    if ((!known && !is_dated) || senses.has(Sense::cut)) return unclear_period;
    return begins ? from : until;
  }
  if (!known) return holds || senses.has(Sense::effective) ? unclear_period : nothing;
  if (holds) return period;
  return senses.has(Sense::effective) ? from : senses.has(Sense::clock) ? some_date : nothing;
}

}  // namespace

AttributeMeaning meaning_of_attribute(std::string_view name) {
  using enum AttributeMeaning;
  const Senses senses{name};
  if (senses.count() == 0) return nothing;
  if (senses.has(Sense::called)) return senses.count() == 1 ? AttributeMeaning::zone_name : nothing;
  if (const AttributeMeaning meant = depth_meant(senses); meant != nothing) return meant;
  if (const AttributeMeaning meant = time_meant(senses); meant != nothing) return meant;
  if (senses.has(Sense::rule) && senses.are_only(Sense::rule, Sense::place)) return kind;
  const bool is_type = senses.has(Sense::rule) || senses.has(Sense::type);
  return is_type && senses.are_only(Sense::rule, Sense::type, Sense::place) ? perhaps_kind : nothing;
}

std::string_view unit_in_attribute(std::string_view name) { return Senses{name}.text_of(Sense::unit); }

}  // namespace floeplan::ocean
