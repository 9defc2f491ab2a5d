#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/core/units.hpp"
#include "storage/repository/datasets/dataset_choice.hpp"

namespace floeplan::fields {

/// Type of a field's value. It determines how the field is read, written, given on the command line and
/// described.
enum class Kind {
  number,        // within a range
  whole_number,  // within a range
  boolean,
  word,       // one of several words
  text,       // at most 200 bytes
  time,       // ISO 8601 with its zone
  duration,   // ISO 8601
  place,      // [longitude, latitude]
  places,     // an array of them
  dataset,    // the id of a stored dataset, or one of several words
  datasets,   // the same, or an array of ids
  structure,  // another structure, with its own reader and schema
};

/// A value in the form of a request: numbers are in the unit in the field's name.
using Value = std::variant<bool, int, double, std::string, core::UtcTime, repository::DatasetChoice>;

struct Word {
  std::string_view name;
  std::string_view meaning{};  // explanation for messages, if the name is not enough
};

/// How a form presents a field.
struct Form {
  std::string_view label{};
  std::string_view unit{};   // shown beside the label; a unit in which numbers are entered
  std::string_view blank{};  // text for an empty field that has no default
  std::string_view hint{};
};

/// Groups of a form, and headings in the help. Fields without a group come first in both.
namespace group {
inline constexpr std::string_view places{"Places and areas"};
inline constexpr std::string_view window{"Departure window"};
inline constexpr std::string_view vehicle{"Vehicle"};
inline constexpr std::string_view ice{"Icebergs and sea ice"};
inline constexpr std::string_view uncertainty{"Uncertainty of currents"};
inline constexpr std::string_view search{"Advanced"};
inline constexpr std::string_view data{"Data"};
}  // namespace group

/// One member of the inputs of a process, with all descriptions of it.
struct Field {
  std::string_view name;
  std::string_view
      object{};  // name of the object in the inputs that contains the field; empty: the inputs themselves
  Kind kind{Kind::structure};
  std::string_view unit{};  // unit of a number
  double least{};           // smallest number, included
  double most{};
  std::vector<Word> words{};     // allowed words; for datasets the words for automatic choice and for none
  std::optional<Value> usual{};  // default
  std::string_view
      // name of the command line flag, without dashes; the flag of a boolean sets the opposite of `usual`
      flag{};
  std::string_view flag_sets{};    // the word that the flag sets, if it takes no value
  std::string_view former_flag{};  // older name of the flag, for existing scripts
  std::string_view none_flag{};    // name of a flag without a value that sets the smallest number
  std::string_view group{};
  std::string_view help{};     // one sentence without its full stop, with unit and default
  std::string_view details{};  // further sentences for the OpenAPI document
  std::string_view example{};  // in JSON
  Form form{};
};

/// The JSON pointer of the field in the inputs: "/under_ice/escape_plan".
[[nodiscard]] std::string pointer_of(const Field& field);

/// The unit of a number in words for a sentence, "metres" for "m"; empty if the number is clear without one.
[[nodiscard]] std::string_view unit_in_words(const Field& field);

}  // namespace floeplan::fields
