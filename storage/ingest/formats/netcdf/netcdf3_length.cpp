#include "storage/ingest/formats/netcdf/netcdf3_length.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "engine/messages/ingest_netcdf_messages.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::uint64_t max_count =
    1'000'000;  // of dimensions, variables or attributes: far above any real file
constexpr std::uint32_t tag_dimension = 10;
constexpr std::uint32_t tag_variable = 11;
constexpr std::uint32_t tag_attribute = 12;

struct BadHeader : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
  if (b != 0 && a > std::numeric_limits<std::uint64_t>::max() / 2 / b) throw BadHeader{"a size is absurd"};
  return a * b;
}

std::uint64_t size_of_type(std::uint32_t type) {
  switch (type) {
    case 1:
    case 2:
    case 7: return 1;  // byte, char, ubyte
    case 3:
    case 8: return 2;  // short, ushort
    case 4:
    case 5:
    case 9: return 4;  // int, float, uint
    case 6:
    case 10:
    case 11: return 8;  // double, int64, uint64
    default: throw BadHeader{"a type is unknown"};
  }
}

std::uint64_t padded(std::uint64_t bytes) { return (bytes + 3) / 4 * 4; }

/// Reads big-endian numbers from the beginning of the file.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : in_{file, std::ios::binary} {}

  std::uint64_t integer(int bytes) {
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) {
      const int byte = in_.get();
      if (byte == std::char_traits<char>::eof()) throw BadHeader{"the header is cut short"};
      value = value << 8U | static_cast<std::uint64_t>(byte);
    }
    return value;
  }
  std::uint32_t word() { return static_cast<std::uint32_t>(integer(4)); }
  void skip(std::uint64_t bytes) {
    if (bytes > (std::uint64_t{1} << 40U)) throw BadHeader{"a size is absurd"};
    in_.seekg(static_cast<std::streamoff>(bytes), std::ios::cur);
  }

 private:
  std::ifstream in_;
};

/// The parts of the header from which the end of the values follows.
class Header {
 public:
  explicit Header(const std::filesystem::path& file) : in_{file} {
    const std::uint32_t magic = in_.word();
    const std::uint32_t version = magic & 0xFFU;
    if (magic >> 8U != 0x434446U || (version != 1 && version != 2 && version != 5))
      throw BadHeader{"it is no NetCDF"};
    count_bytes_ = version == 5 ? 8 : 4;
    offset_bytes_ = version == 1 ? 4 : 8;

    records_ = in_.integer(count_bytes_);
    const bool streaming = records_ == (version == 5 ? ~std::uint64_t{0} : 0xFFFFFFFFU);
    if (streaming) records_ = 0;
    read_dimensions();
    read_attributes();
    read_variables();
  }

  [[nodiscard]] std::uint64_t length() const {
    std::uint64_t end = 0;
    std::uint64_t record_size = 0;
    for (const Variable& variable : variables_)
      if (variable.is_record)
        record_size += variables_in_records_ == 1 ? variable.bytes : padded(variable.bytes);
    for (const Variable& variable : variables_) {
      if (variable.is_record && records_ == 0) continue;
      const std::uint64_t skipped = variable.is_record ? product(records_ - 1, record_size) : 0;
      end = std::max(end, variable.begin + skipped + variable.bytes);
    }
    return end;
  }

 private:
  struct Variable {
    std::uint64_t begin{};
    std::uint64_t bytes{};  // bytes of all values, or of one record, without padding
    bool is_record{};
  };

  std::uint64_t list(std::uint32_t expected_tag) {
    const std::uint32_t tag = in_.word();
    const std::uint64_t count = in_.integer(count_bytes_);
    if ((tag != expected_tag && !(tag == 0 && count == 0)) || count > max_count)
      throw BadHeader{"a list is damaged"};
    return count;
  }
  void skip_name() { in_.skip(padded(in_.integer(count_bytes_))); }

  void read_dimensions() {
    for (std::uint64_t n = list(tag_dimension); n > 0; --n) {
      skip_name();
      dimensions_.push_back(in_.integer(count_bytes_));
    }
  }
  void read_attributes() {
    for (std::uint64_t n = list(tag_attribute); n > 0; --n) {
      skip_name();
      const std::uint64_t size = size_of_type(in_.word());
      in_.skip(padded(product(in_.integer(count_bytes_), size)));
    }
  }
  void read_variables() {
    for (std::uint64_t n = list(tag_variable); n > 0; --n) {
      skip_name();
      Variable variable;
      const std::uint64_t rank = in_.integer(count_bytes_);
      if (rank > dimensions_.size() + 1024) throw BadHeader{"a variable is damaged"};
      std::uint64_t values = 1;
      for (std::uint64_t i = 0; i < rank; ++i) {
        const std::uint64_t id = in_.integer(count_bytes_);
        if (id >= dimensions_.size()) throw BadHeader{"a variable is damaged"};
        const std::uint64_t size = dimensions_[id];
        if (size == 0 && i == 0) {
          variable.is_record = true;
        } else {
          values = product(values, size);
        }
      }
      read_attributes();
      variable.bytes = product(values, size_of_type(in_.word()));
      in_.integer(count_bytes_);  // vsize is redundant, and too small for large variables
      variable.begin = in_.integer(offset_bytes_);
      if (variable.begin > std::numeric_limits<std::uint64_t>::max() / 4)
        throw BadHeader{"an offset is absurd"};
      variables_in_records_ += variable.is_record ? 1 : 0;
      variables_.push_back(variable);
    }
  }

  Reader in_;
  int count_bytes_{4};
  int offset_bytes_{4};
  std::uint64_t records_{};
  std::uint64_t variables_in_records_{};
  std::vector<std::uint64_t> dimensions_;
  std::vector<Variable> variables_;
};

}  // namespace

Checked<std::uint64_t> netcdf3_length(const std::filesystem::path& file) {
  try {
    return Header{file}.length();
  } catch (const BadHeader& fault) {
    return refuse(messages::ingest_netcdf_message<"netcdf-header-damaged">(std::string{fault.what()}));
  }
}

}  // namespace floeplan::ingest
