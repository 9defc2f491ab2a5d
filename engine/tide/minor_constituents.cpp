#include "engine/tide/minor_constituents.hpp"

#include <algorithm>

namespace floeplan::tide {
namespace {

struct Inference {
  const char* minor;
  const char* first;
  double first_weight;
  const char* second;
  double second_weight;
};

/// M1 and L2 have the weights of their stronger line; the other line is part of their nodal factor here.
constexpr std::array<Inference, 16> inferences{{
    {"2Q1", "Q1", 0.263, "O1", -0.0252},
    {"SIG1", "Q1", 0.297, "O1", -0.0264},
    {"RHO1", "Q1", 0.164, "O1", 0.0048},
    {"M1", "O1", 0.0389, "K1", 0.0282},
    {"CHI1", "O1", 0.0064, "K1", 0.0060},
    {"PI1", "O1", 0.0030, "K1", 0.0171},
    {"PHI1", "O1", -0.0015, "K1", 0.0152},
    {"THE1", "O1", -0.0065, "K1", 0.0155},
    {"J1", "O1", -0.0389, "K1", 0.0836},
    {"OO1", "O1", -0.0431, "K1", 0.0613},
    {"2N2", "N2", 0.264, "M2", -0.0253},
    {"MU2", "N2", 0.298, "M2", -0.0264},
    {"NU2", "N2", 0.165, "M2", 0.00487},
    {"LAM2", "M2", 0.0040, "S2", 0.0074},
    {"L2", "M2", 0.0131, "S2", 0.0326},
    {"T2", "M2", 0.0, "S2", 0.0585},
}};

std::optional<std::size_t> position(std::span<const Constituent> among, const char* name) {
  const auto found = std::ranges::find(among, find_constituent(name).value());
  if (found == among.end()) return std::nullopt;
  return static_cast<std::size_t>(found - among.begin());
}

}  // namespace

std::vector<MinorConstituent> inferable_minors(std::span<const Constituent> majors) {
  for (const char* needed : {"Q1", "O1", "K1", "N2", "M2", "S2"})
    if (!position(majors, needed)) return {};
  std::vector<MinorConstituent> result;
  for (const Inference& inference : inferences) {
    if (position(majors, inference.minor)) continue;
    result.push_back({find_constituent(inference.minor).value(),
                      {*position(majors, inference.first), *position(majors, inference.second)},
                      {inference.first_weight, inference.second_weight}});
  }
  return result;
}

std::vector<HarmonicConstant> with_minors(std::vector<HarmonicConstant> constants) {
  std::vector<Constituent> majors;
  majors.reserve(constants.size());
  for (const HarmonicConstant& constant : constants) majors.push_back(constant.constituent);
  for (const MinorConstituent& minor : inferable_minors(majors))
    constants.push_back({minor.constituent, minor.weights[0] * constants[minor.majors[0]].value +
                                                minor.weights[1] * constants[minor.majors[1]].value});
  return constants;
}

}  // namespace floeplan::tide
