#include "api/codec/bytes/netcdf_classic.hpp"

#include <bit>
#include <stdexcept>
#include <utility>

namespace floeplan::codec {
namespace {

constexpr std::uint32_t dimension_list = 0x0A;
constexpr std::uint32_t variable_list = 0x0B;
constexpr std::uint32_t attribute_list = 0x0C;
constexpr std::uint32_t type_char = 2;
constexpr std::uint32_t type_int = 4;
constexpr std::uint32_t type_double = 6;

template <class Bits>
std::string big_endian(Bits bits) {
  std::string text(sizeof bits, '\0');
  for (std::size_t i = 0; i < sizeof bits; ++i)
    text[i] = static_cast<char>((bits >> (8 * (sizeof bits - 1 - i))) & 0xFFU);
  return text;
}

std::string written_count(std::size_t count) { return big_endian(static_cast<std::uint32_t>(count)); }

std::string filled_up(std::string text) {
  text.resize((text.size() + 3) / 4 * 4, '\0');
  return text;
}

std::string name_of(const std::string& name) { return written_count(name.size()) + filled_up(name); }

std::string list_head(std::uint32_t tag, std::size_t count) {
  return count == 0 ? written_count(0) + written_count(0) : written_count(tag) + written_count(count);
}

std::string integers(std::span<const std::int32_t> values) {
  std::string text;
  text.reserve(4 * values.size());
  for (const std::int32_t value : values) text += big_endian(std::bit_cast<std::uint32_t>(value));
  return text;
}

}  // namespace

NetcdfClassic::Dimension NetcdfClassic::add_dimension(std::string name, std::size_t length) {
  dimensions_.emplace_back(std::move(name), length);
  return dimensions_.size() - 1;
}

void NetcdfClassic::add_text(std::string name, std::string text) {
  const std::size_t length = text.size();
  attributes_.push_back({std::move(name), type_char, length, filled_up(std::move(text))});
}

std::vector<NetcdfClassic::Attribute> NetcdfClassic::text_attributes(const Texts& texts) {
  std::vector<Attribute> attributes;
  for (const auto& [name, text] : texts)
    attributes.push_back({name, type_char, text.size(), filled_up(text)});
  return attributes;
}

void NetcdfClassic::add(Variable variable, std::size_t values) {
  std::size_t size = 1;
  for (const Dimension dimension : variable.shape) size *= dimensions_.at(dimension).second;
  if (size != values) throw std::invalid_argument{variable.name + " does not fill its dimensions"};
  variable.values = filled_up(std::move(variable.values));
  variables_.push_back(std::move(variable));
}

void NetcdfClassic::add_doubles(const std::string& name, const std::vector<Dimension>& shape,
                                std::span<const double> values, const Texts& attributes) {
  std::string text;
  text.reserve(8 * values.size());
  for (const double value : values) text += big_endian(std::bit_cast<std::uint64_t>(value));
  add({name, shape, text_attributes(attributes), type_double, std::move(text)}, values.size());
}

void NetcdfClassic::add_integers(const std::string& name, const std::vector<Dimension>& shape,
                                 std::span<const std::int32_t> values, const Texts& attributes) {
  add({name, shape, text_attributes(attributes), type_int, integers(values)}, values.size());
}

void NetcdfClassic::add_flags(const std::string& name, const std::vector<Dimension>& shape,
                              std::span<const std::int32_t> values, const std::vector<std::string>& meanings,
                              const Texts& attributes) {
  std::vector<std::int32_t> numbers;
  std::string words;
  for (const std::string& meaning : meanings) {
    numbers.push_back(static_cast<std::int32_t>(numbers.size()));
    words += (words.empty() ? "" : " ") + meaning;
  }
  std::vector<Attribute> all = text_attributes(attributes);
  all.push_back({"flag_values", type_int, numbers.size(), integers(numbers)});
  all.push_back({"flag_meanings", type_char, words.size(), filled_up(words)});
  add({name, shape, std::move(all), type_int, integers(values)}, values.size());
}

void NetcdfClassic::add_characters(const std::string& name, const std::vector<Dimension>& shape,
                                   const std::vector<std::string>& texts, const Texts& attributes) {
  const std::size_t length = dimensions_.at(shape.back()).second;
  std::string characters;
  for (std::string text : texts) {
    text.resize(length, ' ');
    characters += text;
  }
  const std::size_t count = characters.size();
  add({name, shape, text_attributes(attributes), type_char, std::move(characters)}, count);
}

std::string NetcdfClassic::attributes_text(const std::vector<Attribute>& attributes) {
  std::string text = list_head(attribute_list, attributes.size());
  for (const Attribute& attribute : attributes)
    text += name_of(attribute.name) + written_count(attribute.type) + written_count(attribute.count) +
            attribute.values;
  return text;
}

/// The header of the file. `begin` is the offset of the first variable's values, bytes.
std::string NetcdfClassic::header(std::size_t begin) const {
  std::string text{"CDF\x02"};
  text += written_count(0) + list_head(dimension_list, dimensions_.size());
  for (const auto& [name, length] : dimensions_) text += name_of(name) + written_count(length);
  text += attributes_text(attributes_) + list_head(variable_list, variables_.size());
  for (const Variable& variable : variables_) {
    text += name_of(variable.name) + written_count(variable.shape.size());
    for (const Dimension dimension : variable.shape) text += written_count(dimension);
    text += attributes_text(variable.attributes) + written_count(variable.type) +
            written_count(variable.values.size()) + big_endian(static_cast<std::uint64_t>(begin));
    begin += variable.values.size();
  }
  return text;
}

std::string NetcdfClassic::bytes() const {
  std::string text = header(header(0).size());
  for (const Variable& variable : variables_) text += variable.values;
  return text;
}

}  // namespace floeplan::codec
