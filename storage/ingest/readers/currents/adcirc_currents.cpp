#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "engine/messages/ingest_current_messages.hpp"
#include "storage/ingest/common/missing_value.hpp"
#include "storage/ingest/files/first_bytes.hpp"
#include "storage/ingest/readers/currents/adcirc_file.hpp"
#include "storage/ingest/readers/currents/current_dataset.hpp"
#include "storage/ingest/readers/currents/current_readers.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::uintmax_t head_bytes = 4096;  // enough for the first three lines

class AdcircSource : public VelocitySource {
 public:
  AdcircSource(AdcircOutput currents, std::optional<AdcircOutput> elevations, std::vector<geo::LonLat> nodes,
               core::UtcTime start)
      : currents_{std::move(currents)}, elevations_{std::move(elevations)}, nodes_{std::move(nodes)} {
    shape_.columns = nodes_.size();
    for (const double seconds : currents_.seconds())
      shape_.times_s.push_back(core::unix_seconds(start) + seconds);
  }

  [[nodiscard]] const SourceShape& shape() const override { return shape_; }
  [[nodiscard]] geo::LonLat place(std::size_t point) const override { return nodes_[point]; }
  [[nodiscard]] Checked<VelocitySlice> read(std::size_t time, std::size_t /*level*/) const override {
    auto components = currents_.read(time);
    if (!components) return refuse(components.error());
    VelocitySlice slice{std::move((*components)[0]), std::move((*components)[1])};
    std::vector<float> surface;
    if (elevations_) {
      auto read = elevations_->read(time);
      if (!read) return refuse(read.error());
      surface = std::move((*read)[0]);
    }
    for (std::size_t i = 0; i < slice.east.size(); ++i) {
      const bool dry =
          surface.empty() ? slice.east[i] == 0.0F && slice.north[i] == 0.0F : std::isnan(surface[i]);
      if (dry) slice.east[i] = slice.north[i] = missing;
    }
    return slice;
  }
  [[nodiscard]] Checked<std::vector<float>> level_depths(std::size_t /*time*/,
                                                         std::size_t /*level*/) const override {
    return refuse(messages::ingest_current_message<"levels-not-of-the-bed">("an ADCIRC file"));
  }

 private:
  AdcircOutput currents_;
  std::optional<AdcircOutput> elevations_;  // empty: no fort.63 was given
  std::vector<geo::LonLat> nodes_;
  SourceShape shape_;
};

/// The file of the group with this part of the run; empty if there is none.
std::optional<std::filesystem::path> part_of(const FileGroup& files, AdcircPart part) {
  for (const std::filesystem::path& file : files) {
    const auto head = adcirc_head(first_bytes(file, head_bytes));
    if (head && head->part == part) return file;
  }
  return std::nullopt;
}

}  // namespace

Checked<PreparedDataset> read_adcirc_currents(const FileGroup& files, const IngestOptions& options,
                                              const core::ProgressCallback& progress) {
  const auto of_currents = part_of(files, AdcircPart::currents);
  const auto of_mesh = part_of(files, AdcircPart::mesh);
  const auto of_elevations = part_of(files, AdcircPart::elevations);
  if (!of_currents)
    return refuse(messages::ingest_current_message<"adcirc-without-currents">(
        of_mesh ? "the mesh" : "elevations of the surface"));
  if (!of_mesh) return refuse(messages::ingest_current_message<"adcirc-without-mesh">());
  if (!options.time) return refuse(messages::ingest_current_message<"adcirc-without-start">());

  auto mesh = read_adcirc_mesh(*of_mesh);
  if (!mesh) return refuse(mesh.error());
  auto currents = AdcircOutput::open(*of_currents);
  if (!currents) return refuse(currents.error());
  if (currents->head().nodes != mesh->points.size())
    return refuse(messages::ingest_current_message<"adcirc-meshes-differ">(currents->head().nodes,
                                                                           mesh->points.size()));
  std::optional<AdcircOutput> elevations;
  if (of_elevations) {
    auto opened = AdcircOutput::open(*of_elevations);
    if (!opened) return refuse(opened.error());
    if (opened->head().nodes != currents->head().nodes || opened->seconds() != currents->seconds())
      return refuse(messages::ingest_current_message<"adcirc-times-differ">());
    elevations = std::move(*opened);
  }

  CurrentInput input;
  input.variables = {"u", "v"};
  input.layout = "the nodes of a mesh";
  input.warnings.push_back(
      messages::ingest_current_message<"current-of-the-column">("The currents of the file"));
  if (!elevations) input.warnings.push_back(messages::ingest_current_message<"adcirc-zeros-are-dry">());
  input.source = std::make_shared<const AdcircSource>(std::move(*currents), std::move(elevations),
                                                      mesh->points, *options.time);
  input.mesh = std::move(*mesh);
  return prepare_currents(std::move(input), progress);
}

}  // namespace floeplan::ingest
