#include "storage/ingest/formats/grib/grib_messages.hpp"

#include <chrono>
#include <cmath>
#include <fstream>
#include <optional>

#include "engine/messages/ingest_grib_messages.hpp"
#include "storage/ingest/formats/grib/grib_section.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::uint64_t max_header_section = 1'000'000;  // octets of a section that holds no values
constexpr std::size_t max_fields = 200'000;

double seconds_of_date(const GribSection& section, std::size_t first) {
  const std::chrono::year_month_day date{std::chrono::year{static_cast<int>(section.at(first, 2))},
                                         std::chrono::month{static_cast<unsigned>(section.at(first + 2, 1))},
                                         std::chrono::day{static_cast<unsigned>(section.at(first + 3, 1))}};
  if (!date.ok()) fail_grib(messages::ingest_grib_message<"grib-date-impossible">());
  return static_cast<double>(std::chrono::sys_days{date}.time_since_epoch().count()) * 86400.0 +
         static_cast<double>(section.at(first + 4, 1)) * 3600.0 +
         static_cast<double>(section.at(first + 5, 1)) * 60.0 + static_cast<double>(section.at(first + 6, 1));
}

double seconds_of_unit(std::uint64_t unit) {
  switch (unit) {
    case 0: return 60.0;
    case 1: return 3600.0;
    case 2: return 86400.0;
    case 10: return 3.0 * 3600.0;
    case 11: return 6.0 * 3600.0;
    case 12: return 12.0 * 3600.0;
    case 13: return 1.0;
    default: fail_grib(messages::ingest_grib_message<"grib-time-unit-without-length">());
  }
}

/// Whether vectors point along the grid's axes; the resolution and component flags of its template say so.
bool is_along_grid(const GribSection& grid, int grid_template) {
  const bool latitude_longitude = grid_template == 0 || grid_template == 1;
  const bool projected = grid_template == 10 || grid_template == 20 || grid_template == 30;
  if (!latitude_longitude && !projected)
    fail_grib(messages::ingest_grib_message<"grib-grid-template-not-read">(grid_template));
  const std::uint64_t flags = grid.at(latitude_longitude ? 55 : 47, 1);
  return (flags & 8U) != 0;
}

/// Value of a surface: scale factor at octet `first`, scaled value behind it; empty if missing.
std::optional<double> surface_value(const GribSection& product, std::size_t first) {
  if (product.is_missing(first, 1) && product.is_missing(first + 1, 4)) return std::nullopt;
  return static_cast<double>(product.signed_at(first + 1, 4)) *
         std::pow(10.0, -static_cast<double>(product.signed_at(first, 1)));
}

/// Describes the second surface of a layer. A field has none if its type is 255, the reserved 0, or that of the first
/// surface.
void describe_end_of_layer(GribField& field, const GribSection& product) {
  const auto type = static_cast<int>(product.at(29, 1));
  const auto value = surface_value(product, 30);
  const bool same_again = type == field.surface_type && (!value || *value == field.surface_value);
  field.second_surface_type = type == 0 || same_again ? 255 : type;
  field.second_surface_value = value.value_or(0.0);
}

void describe_product(GribField& field, const GribSection& product, double reference_s) {
  const std::uint64_t product_template = product.at(8, 2);
  if (product_template != 0 && product_template != 8 && product_template != 1 && product_template != 11)
    fail_grib(messages::ingest_grib_message<"grib-product-not-read">(product_template));
  field.category = static_cast<int>(product.at(10, 1));
  field.number = static_cast<int>(product.at(11, 1));
  field.valid_s =
      reference_s + seconds_of_unit(product.at(18, 1)) * static_cast<double>(product.signed_at(19, 4));
  field.surface_type = static_cast<int>(product.at(23, 1));
  field.surface_value = surface_value(product, 24).value_or(0.0);
  describe_end_of_layer(field, product);
  if (product_template != 8 && product_template != 11) return;
  const std::size_t end_of_period = product_template == 8 ? 35 : 38;
  const double begins_s = field.valid_s;
  field.valid_s = seconds_of_date(product, end_of_period);
  const auto statistic = static_cast<int>(product.at(end_of_period + 12, 1));
  field.statistic = statistic == 255 ? 0 : statistic;  // 255: not stated
  if (statistic == 0 && begins_s < field.valid_s) field.valid_s = (begins_s + field.valid_s) / 2.0;
}

class Walker {
 public:
  explicit Walker(const std::filesystem::path& file)
      : in_{file, std::ios::binary}, size_{std::filesystem::file_size(file)} {}

  std::vector<GribField> fields() {
    while (at_ < size_) read_message();
    return std::move(fields_);
  }

 private:
  std::string take(std::uint64_t count) {
    if (count > size_ - at_) fail_cut_grib();
    std::string octets(static_cast<std::size_t>(count), '\0');
    in_.seekg(static_cast<std::streamoff>(at_));
    in_.read(octets.data(), static_cast<std::streamsize>(count));
    if (!in_) fail_cut_grib();
    at_ += count;
    return octets;
  }

  void read_message() {
    const GribSection indicator{take(16)};
    if (indicator.octets().substr(0, 4) != "GRIB") fail_cut_grib();
    if (indicator.at(8, 1) != 2)
      fail_grib(messages::ingest_grib_message<"grib-edition-not-read">(indicator.at(8, 1)));
    const std::uint64_t length = indicator.at(9, 8);
    const std::uint64_t start = at_ - 16;
    if (length < 20 || length > size_ - start) fail_cut_grib();
    const std::uint64_t end = start + length - 4;

    GribField field;
    field.discipline = static_cast<int>(indicator.at(7, 1));
    std::optional<double> reference_s;
    while (at_ < end) read_section(field, reference_s, end);
    if (at_ != end || take(4) != "7777") fail_cut_grib();
  }

  void read_section(GribField& field, std::optional<double>& reference_s, std::uint64_t end) {
    const GribSection head{take(5)};
    const std::uint64_t length = head.at(1, 4);
    const std::uint64_t kind = head.at(5, 1);
    if (length < 5 || length - 5 > end - at_) fail_cut_grib();
    if (kind < 1 || kind > 7) fail_cut_grib();
    if (kind == 2 || kind >= 5) {  // section 2 is for local use; GDAL decodes sections 5 and later
      at_ += length - 5;
      if (kind == 7) add(field, reference_s);
      return;
    }
    if (length > max_header_section) fail_cut_grib();
    const GribSection section{head.octets() + take(length - 5)};
    if (kind == 1) {
      reference_s = seconds_of_date(section, 13);
      const bool is_run = section.at(12, 1) <= 1;  // code table 1.2: 0 analysis, 1 start of forecast
      field.run_s = is_run ? reference_s : std::nullopt;
    }
    if (kind == 3) {
      field.grid_template = static_cast<int>(section.at(13, 2));
      field.grid = section.octets();
      field.along_grid = is_along_grid(section, field.grid_template);
    }
    if (kind == 4) {
      if (!reference_s) fail_cut_grib();
      describe_product(field, section, *reference_s);
    }
  }

  void add(const GribField& field, const std::optional<double>& reference_s) {
    if (!reference_s || field.grid.empty()) fail_cut_grib();
    if (fields_.size() == max_fields)
      fail_grib(messages::ingest_grib_message<"grib-with-too-many-fields">(max_fields));
    fields_.push_back(field);
  }

  std::ifstream in_;
  std::uint64_t size_{};
  std::uint64_t at_{};
  std::vector<GribField> fields_;
};

}  // namespace

Checked<std::vector<GribField>> grib_fields(const std::filesystem::path& file) {
  try {
    return Walker{file}.fields();
  } catch (const BadGrib& fault) {
    return refuse(fault.reason);
  }
}

}  // namespace floeplan::ingest
