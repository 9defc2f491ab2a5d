#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/core/units.hpp"
#include "storage/repository/datasets/dataset_choice.hpp"

namespace floeplan::fields {

/// What the value of a field is. How it is read, written, typed on the command line and described follows from it.
enum class Kind {
  number,        // within a range
  whole_number,  // within a range
  boolean,
  word,       // one of a few
  text,       // at most 200 bytes
  time,       // ISO 8601 with its zone
  duration,   // ISO 8601
  place,      // [longitude, latitude]
  places,     // an array of them
  dataset,    // the id of a stored dataset, or a word in its place
  datasets,   // the same, or an array of ids
  structure,  // a shape of its own, which has a reader and a schema of its own
};

/// A value as requests write it: numbers in the unit that the field's name ends with.
using Value = std::variant<bool, int, double, std::string, core::UtcTime, repository::DatasetChoice>;

struct Word {
  std::string_view name;
  std::string_view meaning{};  // where the name does not tell; for messages
};

/// How a form asks for a field.
struct Form {
  std::string_view label{};
  std::string_view unit{};   // shown beside the label; numbers are typed in it where it is a unit
  std::string_view blank{};  // what an empty field means where nothing is usual
  std::string_view hint{};
};

/// Parts of a form and headings of the help. What has none comes first in both.
namespace group {
inline constexpr std::string_view places{"Places and areas"};
inline constexpr std::string_view window{"Departure window"};
inline constexpr std::string_view vehicle{"Vehicle"};
inline constexpr std::string_view ice{"Icebergs and sea ice"};
inline constexpr std::string_view uncertainty{"Uncertainty of currents"};
inline constexpr std::string_view search{"Advanced"};
inline constexpr std::string_view data{"Data"};
}  // namespace group

/// One member of the inputs of a process: all that is said of it anywhere.
struct Field {
  std::string_view name;
  std::string_view
      object{};  // the member of the inputs that has it as a member; empty: the inputs themselves
  Kind kind{Kind::structure};
  std::string_view unit{};  // of a number
  double least{};           // of a number, both included
  double most{};
  std::vector<Word> words{};     // that may stand there; of datasets: the server's own choice, and none
  std::optional<Value> usual{};  // what counts where the field is left out
  std::string_view
      flag{};  // of the command line, without its dashes; a boolean's sets the opposite of `usual`
  std::string_view flag_sets{};    // the word that the flag stands for, where it takes no value
  std::string_view former_flag{};  // another name of the flag, for scripts that were written before
  std::string_view none_flag{};    // a flag without a value that stands for the least number
  std::string_view group{};
  std::string_view help{};     // one sentence without its full stop, unit and default
  std::string_view details{};  // further sentences, for the OpenAPI document
  std::string_view example{};  // as a request has it
  Form form{};
};

/// "/under_ice/escape_plan": the JSON pointer of the field in the inputs.
[[nodiscard]] std::string pointer_of(const Field& field);

/// "metres" for "m": the unit of a number in a sentence, or nothing where it is plain without one.
[[nodiscard]] std::string_view unit_in_words(const Field& field);

}  // namespace floeplan::fields
