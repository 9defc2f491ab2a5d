#include "storage/ingest/sigma_levels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "storage/ingest/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr double max_bed_depth_m = 12000.0;

class SigmaLevels : public BedLevels {
 public:
  struct Parts {
    std::shared_ptr<const NetcdfFile> file;  // kept open
    std::vector<double> sigma;               // [level] or [level][node], in the file's order
    std::size_t levels{};
    std::vector<double> bed_m;  // below the mean surface, of each node
    const NetcdfVariable* surface{nullptr};
    AxisNodes times;
  };

  explicit SigmaLevels(Parts parts) : parts_{std::move(parts)} {
    const std::size_t stride = parts_.sigma.size() / parts_.levels;
    upwards_ = parts_.sigma.front() < parts_.sigma[(parts_.levels - 1) * stride];
  }

  [[nodiscard]] std::size_t file_level(std::size_t level) const override {
    return upwards_ ? parts_.levels - 1 - level : level;
  }

  [[nodiscard]] Checked<std::vector<float>> depths(std::size_t time, std::size_t level) const override {
    std::vector<double> surface_m(parts_.bed_m.size(), 0.0);
    if (parts_.surface != nullptr) {
      std::vector<std::uint64_t> start;
      std::vector<std::size_t> count;
      if (parts_.surface->dimensions().size() == 2) {
        start.push_back(parts_.surface->dimensions()[0].size == 1 ? 0 : parts_.times.source[time]);
        count.push_back(1);
      }
      start.push_back(0);
      count.push_back(surface_m.size());
      const auto packed = parts_.surface->read_packed(start, count);
      if (!packed) return refuse(packed.error());
      for (std::size_t i = 0; i < surface_m.size(); ++i) {
        const double value = parts_.surface->unpacked((*packed)[i]);
        if (std::isfinite(value)) surface_m[i] = value;
      }
    }
    const bool per_node = parts_.sigma.size() > parts_.levels;
    std::vector<float> result(surface_m.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
      const std::size_t row = level == parts_.levels ? 0 : file_level(level);
      const double sigma =
          level == parts_.levels ? -1.0 : parts_.sigma[per_node ? row * result.size() + i : row];
      result[i] = static_cast<float>(-sigma * (parts_.bed_m[i] + surface_m[i]));
    }
    return result;
  }

 private:
  Parts parts_;
  bool upwards_{false};
};

const NetcdfVariable* find_first(const NetcdfFile& file, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const NetcdfVariable* variable = file.find(name)) return variable;
  return nullptr;
}

}  // namespace

Checked<std::shared_ptr<const BedLevels>> sigma_levels(const std::shared_ptr<const NetcdfFile>& file,
                                                       const NetcdfVariable& variable,
                                                       const NetcdfLayout& layout,
                                                       const std::string& node_dimension,
                                                       std::vector<std::string>& warnings) {
  const std::string& level_name = variable.dimensions()[layout.depth_dimension.value()].name;
  const NetcdfVariable* sigma = find_first(*file, {level_name.c_str(), "siglay", "sigma"});
  const NetcdfVariable* bed = find_first(*file, {"h", "depth"});
  const auto along_nodes = [&](const NetcdfVariable* table) {
    return table != nullptr && !table->dimensions().empty() &&
           table->dimensions().back().name == node_dimension;
  };
  if (sigma == nullptr || !along_nodes(bed) || bed->dimensions().size() != 1)
    return refuse(
        "the levels of \"" + variable.name() +
        "\" follow the sea bed, but the file does not tell where they lie (siglay) and how deep the sea "
        "is at the nodes (h); the depths of its currents are not known; ask the producer for a complete "
        "file");
  auto values = sigma->read_all();
  if (!values) return refuse(values.error());
  auto bed_m = bed->read_all();
  if (!bed_m) return refuse(bed_m.error());
  const std::size_t levels = layout.bed_levels;
  const bool fits =
      values->size() == levels || (along_nodes(sigma) && values->size() == levels * bed_m->size());
  const bool possible =
      std::ranges::all_of(*values, [](double value) { return value >= -1.0 - 1e-4 && value <= 1e-4; });
  if (!fits || !possible)
    return refuse(
        "the levels \"" + sigma->name() +
        "\" are no shares from 0 at the surface to -1 at the bed; they cannot be placed; ask the producer "
        "for the model's own output");
  for (double& depth : *bed_m) {
    if (depth > max_bed_depth_m)
      return refuse("the sea in \"" + bed->name() + "\" is " + number(depth) +
                    " m deep; no ocean is; its unit is wrong or the file is damaged");
    if (!(depth > 0.0)) depth = 0.0;  // tidal flats
  }
  const NetcdfVariable* surface = file->find("zeta");
  const bool usable =
      along_nodes(surface) && (surface->dimensions().size() == 1 ||
                               (surface->dimensions().size() == 2 &&
                                (surface->dimensions()[0].size == 1 ||
                                 surface->dimensions()[0].size == layout.times_s->nodes.size())));
  if (!usable)
    warnings.push_back(
        "the file does not give the surface of the sea; its levels were placed below the mean surface");
  return std::make_shared<const SigmaLevels>(SigmaLevels::Parts{.file = file,
                                                                .sigma = std::move(*values),
                                                                .levels = levels,
                                                                .bed_m = std::move(*bed_m),
                                                                .surface = usable ? surface : nullptr,
                                                                .times = *layout.times_s});
}

}  // namespace floeplan::ingest
