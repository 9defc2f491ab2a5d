#include "engine/tide/constituent.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "engine/tide/nodal_factor.hpp"

namespace floeplan::tide {
namespace {

/// A constituent of the astronomical tide.
struct Line {
  const char* name;
  std::array<int, 6> doodson;
  int quarter_turns;  // added to the argument
  NodalClass nodal;
};

using enum NodalClass;
constexpr std::array lines{
    Line{"SA", {0, 0, 1, 0, 0, 0}, 0, none},     Line{"SSA", {0, 0, 2, 0, 0, 0}, 0, none},
    Line{"MSM", {0, 1, -2, 1, 0, 0}, 0, mm},     Line{"MM", {0, 1, 0, -1, 0, 0}, 0, mm},
    Line{"MSF", {0, 2, -2, 0, 0, 0}, 0, none},   Line{"MF", {0, 2, 0, 0, 0, 0}, 0, mf},
    Line{"MTM", {0, 3, 0, -1, 0, 0}, 0, mf},     Line{"MSTM", {0, 3, -2, 1, 0, 0}, 0, mf},
    Line{"MSQM", {0, 4, -2, 0, 0, 0}, 0, mf},    Line{"ALP1", {1, -4, 2, 1, 0, 0}, -1, q1},
    Line{"2Q1", {1, -3, 0, 2, 0, 0}, -1, q1},    Line{"SIG1", {1, -3, 2, 0, 0, 0}, -1, q1},
    Line{"Q1", {1, -2, 0, 1, 0, 0}, -1, q1},     Line{"RHO1", {1, -2, 2, -1, 0, 0}, -1, q1},
    Line{"O1", {1, -1, 0, 0, 0, 0}, -1, o1},     Line{"TAU1", {1, -1, 2, 0, 0, 0}, 1, none},
    Line{"BET1", {1, 0, -2, 1, 0, 0}, 1, beta1}, Line{"M1", {1, 0, 0, 1, 0, 0}, 1, m1},
    Line{"CHI1", {1, 0, 2, -1, 0, 0}, 1, chi1},  Line{"PI1", {1, 1, -3, 0, 0, 1}, -1, none},
    Line{"P1", {1, 1, -2, 0, 0, 0}, -1, none},   Line{"S1", {1, 1, -1, 0, 0, 0}, 2, none},
    Line{"K1", {1, 1, 0, 0, 0, 0}, 1, k1},       Line{"PSI1", {1, 1, 1, 0, 0, -1}, 1, none},
    Line{"PHI1", {1, 1, 2, 0, 0, 0}, 1, none},   Line{"THE1", {1, 2, -2, 1, 0, 0}, 1, j1},
    Line{"J1", {1, 2, 0, -1, 0, 0}, 1, j1},      Line{"OO1", {1, 3, 0, 0, 0, 0}, 1, oo1},
    Line{"UPS1", {1, 4, 0, -1, 0, 0}, 1, oo1},   Line{"OQ2", {2, -3, 0, 3, 0, 0}, 0, m2},
    Line{"EPS2", {2, -3, 2, 1, 0, 0}, 0, m2},    Line{"2N2", {2, -2, 0, 2, 0, 0}, 0, m2},
    Line{"MU2", {2, -2, 2, 0, 0, 0}, 0, m2},     Line{"N2", {2, -1, 0, 1, 0, 0}, 0, m2},
    Line{"NU2", {2, -1, 2, -1, 0, 0}, 0, m2},    Line{"GAM2", {2, 0, -2, 2, 0, 0}, 2, none},
    Line{"H1", {2, 0, -1, 0, 0, 1}, 2, m2},      Line{"M2", {2, 0, 0, 0, 0, 0}, 0, m2},
    Line{"H2", {2, 0, 1, 0, 0, -1}, 0, m2},      Line{"LAM2", {2, 1, -2, 1, 0, 0}, 2, m2},
    Line{"L2", {2, 1, 0, -1, 0, 0}, 2, l2},      Line{"T2", {2, 2, -3, 0, 0, 1}, 0, none},
    Line{"S2", {2, 2, -2, 0, 0, 0}, 0, none},    Line{"R2", {2, 2, -1, 0, 0, -1}, 2, none},
    Line{"K2", {2, 2, 0, 0, 0, 0}, 0, k2},       Line{"ETA2", {2, 3, 0, -1, 0, 0}, 0, eta2},
    Line{"M3", {3, 0, 0, 0, 0, 0}, 2, m3},       Line{"S3", {3, 3, -3, 0, 0, 0}, 2, none},
};

/// A shallow-water constituent, as a sum of parents with whole factors: "2 M2 -1 K1".
struct Compound {
  const char* name;
  const char* parents;
};

constexpr std::array compounds{
    Compound{"2PO1", "2 P1 -1 O1"},
    Compound{"SO1", "1 S2 -1 O1"},
    Compound{"MP1", "1 M2 -1 P1"},
    Compound{"KP1", "1 K2 -1 P1"},
    Compound{"RP1", "1 R2 -1 P1"},
    Compound{"TK1", "1 T2 -1 K1"},
    Compound{"2ML2S2", "2 M2 1 L2 -2 S2"},
    Compound{"2MS2K2", "2 M2 1 S2 -2 K2"},
    Compound{"2NS2", "2 N2 -1 S2"},
    Compound{"2KMSN2", "2 K2 1 M2 -1 S2 -1 N2"},
    Compound{"2SK2", "2 S2 -1 K2"},
    Compound{"2SM2", "2 S2 -1 M2"},
    Compound{"2SN2", "2 S2 -1 N2"},
    Compound{"2SNMK2", "2 S2 1 N2 -1 M2 -1 K2"},
    Compound{"KJ2", "1 K1 1 J1"},
    Compound{"M2KS2", "1 M2 2 K2 -2 S2"},
    Compound{"M2SK2", "1 M2 2 S2 -2 K2"},
    Compound{"MKL2S2", "1 M2 1 K2 1 L2 -2 S2"},
    Compound{"MKS2", "1 M2 1 K2 -1 S2"},
    Compound{"MLN2S2", "1 M2 1 L2 1 N2 -2 S2"},
    Compound{"MNS2", "1 M2 1 N2 -1 S2"},
    Compound{"MSK2", "1 M2 1 S2 -1 K2"},
    Compound{"MSN2", "1 M2 1 S2 -1 N2"},
    Compound{"O2", "2 O1"},
    Compound{"OO2", "1 O1 1 Q1"},
    Compound{"OP2", "1 O1 1 P1"},
    Compound{"SKM2", "1 S2 1 K2 -1 M2"},
    Compound{"SNK2", "1 S2 1 N2 -1 K2"},
    Compound{"2MK3", "2 M2 -1 K1"},
    Compound{"2MO3", "2 M2 -1 O1"},
    Compound{"2MP3", "2 M2 -1 P1"},
    Compound{"MK3", "1 M2 1 K1"},
    Compound{"MO3", "1 M2 1 O1"},
    Compound{"NK3", "1 N2 1 K1"},
    Compound{"NO3", "1 N2 1 O1"},
    Compound{"SK3", "1 S2 1 K1"},
    Compound{"SO3", "1 S2 1 O1"},
    Compound{"SP3", "1 S2 1 P1"},
    Compound{"2MLS4", "2 M2 1 L2 -1 S2"},
    Compound{"2MNS4", "2 M2 1 N2 -1 S2"},
    Compound{"3MS4", "3 M2 -1 S2"},
    Compound{"KN4", "1 K2 1 N2"},
    Compound{"M4", "2 M2"},
    Compound{"MK4", "1 M2 1 K2"},
    Compound{"ML4", "1 M2 1 L2"},
    Compound{"MN4", "1 M2 1 N2"},
    Compound{"MS4", "1 M2 1 S2"},
    Compound{"N4", "2 N2"},
    Compound{"S4", "2 S2"},
    Compound{"SK4", "1 S2 1 K2"},
    Compound{"SL4", "1 S2 1 L2"},
    Compound{"SN4", "1 S2 1 N2"},
    Compound{"2MK5", "2 M2 1 K1"},
    Compound{"2MO5", "2 M2 1 O1"},
    Compound{"2MP5", "2 M2 1 P1"},
    Compound{"2SK5", "2 S2 1 K1"},
    Compound{"3KM5", "3 K1 1 M2"},
    Compound{"3MP5", "3 M2 -1 P1"},
    Compound{"MNK5", "1 M2 1 N2 1 K1"},
    Compound{"MNO5", "1 M2 1 N2 1 O1"},
    Compound{"MSK5", "1 M2 1 S2 1 K1"},
    Compound{"2MK6", "2 M2 1 K2"},
    Compound{"2ML6", "2 M2 1 L2"},
    Compound{"2MLNS6", "2 M2 1 L2 1 N2 -1 S2"},
    Compound{"2MN6", "2 M2 1 N2"},
    Compound{"2MS6", "2 M2 1 S2"},
    Compound{"2NM6", "2 N2 1 M2"},
    Compound{"2NMLS6", "2 N2 1 M2 1 L2 -1 S2"},
    Compound{"2SM6", "2 S2 1 M2"},
    Compound{"3MLS6", "3 M2 1 L2 -1 S2"},
    Compound{"M6", "3 M2"},
    Compound{"MKN6", "1 M2 1 K2 1 N2"},
    Compound{"MSK6", "1 M2 1 S2 1 K2"},
    Compound{"MSL6", "1 M2 1 S2 1 L2"},
    Compound{"MSN6", "1 M2 1 S2 1 N2"},
    Compound{"NSK6", "1 N2 1 S2 1 K2"},
    Compound{"S6", "3 S2"},
    Compound{"2MNO7", "2 M2 1 N2 1 O1"},
    Compound{"2MSO7", "2 M2 1 S2 1 O1"},
    Compound{"2NMK7", "2 N2 1 M2 1 K1"},
    Compound{"3MK7", "3 M2 1 K1"},
    Compound{"MSKO7", "1 M2 1 S2 1 K2 1 O1"},
    Compound{"2MN8", "2 M2 2 N2"},
    Compound{"2MS8", "2 M2 2 S2"},
    Compound{"2MSK8", "2 M2 1 S2 1 K2"},
    Compound{"2MSL8", "2 M2 1 S2 1 L2"},
    Compound{"2MSN8", "2 M2 1 S2 1 N2"},
    Compound{"3MK8", "3 M2 1 K2"},
    Compound{"3ML8", "3 M2 1 L2"},
    Compound{"3MN8", "3 M2 1 N2"},
    Compound{"3MS8", "3 M2 1 S2"},
    Compound{"4MLS8", "4 M2 1 L2 -1 S2"},
    Compound{"M8", "4 M2"},
    Compound{"S8", "4 S2"},
    Compound{"2M2NK9", "2 M2 2 N2 1 K1"},
    Compound{"3MNK9", "3 M2 1 N2 1 K1"},
    Compound{"3MSK9", "3 M2 1 S2 1 K1"},
    Compound{"4MK9", "4 M2 1 K1"},
    Compound{"3M2S10", "3 M2 2 S2"},
    Compound{"3MNS10", "3 M2 1 N2 1 S2"},
    Compound{"3MSL10", "3 M2 1 S2 1 L2"},
    Compound{"4MN10", "4 M2 1 N2"},
    Compound{"4MS10", "4 M2 1 S2"},
    Compound{"M10", "5 M2"},
    Compound{"4MSK11", "4 M2 1 S2 1 K1"},
    Compound{"4M2S12", "4 M2 2 S2"},
    Compound{"4MNS12", "4 M2 1 N2 1 S2"},
    Compound{"4MSL12", "4 M2 1 S2 1 L2"},
    Compound{"5MS12", "5 M2 1 S2"},
    Compound{"M12", "6 M2"},
};

/// Pairs of an alternative name of a constituent and its name in the catalogue.
constexpr std::array<std::pair<const char*, const char*>, 33> aliases{{
    {"NO1", "M1"},
    {"RHO", "RHO1"},
    {"LAMBDA2", "LAM2"},
    {"LDA2", "LAM2"},
    {"LA2", "LAM2"},
    {"LABDA2", "LAM2"},
    {"SIGMA1", "SIG1"},
    {"THETA1", "THE1"},
    {"ALPHA1", "ALP1"},
    {"BETA1", "BET1"},
    {"UPSILON1", "UPS1"},
    {"EPSILON2", "EPS2"},
    {"GAMMA2", "GAM2"},
    {"ALPHA2", "H1"},
    {"MA2", "H1"},
    {"ALP2", "H1"},
    {"M2A", "H1"},
    {"BETA2", "H2"},
    {"MB2", "H2"},
    {"BET2", "H2"},
    {"M2B", "H2"},
    {"MT", "MTM"},
    {"MSQ", "MSQM"},
    {"MQM", "MSQM"},
    {"MST", "MSTM"},
    {"KQ1", "UPS1"},
    {"E2", "EPS2"},
    {"PHI", "PHI1"},
    // XTide's names for constituents whose names NOAA writes without brackets.
    {"2MNLS6", "2MLNS6"},
    {"2(MS)8", "2MS8"},
    {"2(MN)8", "2MN8"},
    {"2KM(SN)2", "2KMSN2"},
    {"M2(KS)2", "M2KS2"},
}};

/// A constituent as the catalogue stores it.
struct Entry {
  std::string name;
  std::array<int, 6> doodson{};
  int quarter_turns{};
  std::vector<std::pair<NodalClass, int>> nodal;  // nodal factors, and the number of times each applies
};

std::string upper(std::string_view name) {
  std::string result;
  for (const char c : name) result += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return result;
}

Entry entry_of(const Line& line) { return {line.name, line.doodson, line.quarter_turns, {{line.nodal, 1}}}; }

Entry entry_of(const Compound& compound) {
  Entry entry{compound.name, {}, 0, {}};
  std::string_view rest = compound.parents;
  while (!rest.empty()) {
    const std::size_t gap = rest.find(' ');
    const std::size_t end = std::min(rest.find(' ', gap + 1), rest.size());
    const int times = std::stoi(std::string{rest.substr(0, gap)});
    const auto* parent = std::ranges::find(lines, rest.substr(gap + 1, end - gap - 1),
                                           [](const Line& line) { return std::string_view{line.name}; });
    if (parent == lines.end()) throw std::logic_error{entry.name + " has a parent that is no line"};
    for (std::size_t i = 0; i < 6; ++i) entry.doodson[i] += times * parent->doodson[i];
    entry.quarter_turns += times * parent->quarter_turns;
    entry.nodal.emplace_back(parent->nodal, times);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return entry;
}

const std::vector<Entry>& catalogue() {
  static const std::vector<Entry> entries = [] {
    std::vector<Entry> result;
    result.reserve(lines.size() + compounds.size());
    for (const Line& line : lines) result.push_back(entry_of(line));
    for (const Compound& compound : compounds) result.push_back(entry_of(compound));
    return result;
  }();
  return entries;
}

const Entry& entry(Constituent constituent) { return catalogue().at(constituent.index); }

/// Factor f^n exp(i n u) of a parent that takes part n times. A subtracted parent (n < 0) still multiplies
/// the amplitude by f^|n|.
std::complex<double> repeated(std::complex<double> factor, int times) {
  std::complex<double> result{1.0};
  const std::complex<double> once = times < 0 ? std::conj(factor) : factor;
  for (int i = 0; i < std::abs(times); ++i) result *= once;
  return result;
}

}  // namespace

std::optional<Constituent> find_constituent(std::string_view name) {
  std::string wanted = upper(name);
  for (const auto& [alias, line] : aliases)
    if (wanted == alias) wanted = line;
  const auto found = std::ranges::find(catalogue(), wanted, &Entry::name);
  if (found == catalogue().end()) return std::nullopt;
  return Constituent{static_cast<std::uint16_t>(found - catalogue().begin())};
}

const std::string& constituent_name(Constituent constituent) { return entry(constituent).name; }

std::vector<Constituent> all_constituents() {
  std::vector<Constituent> result;
  result.reserve(catalogue().size());
  for (std::size_t i = 0; i < catalogue().size(); ++i) result.push_back({static_cast<std::uint16_t>(i)});
  return result;
}

std::array<int, 6> doodson_numbers(Constituent constituent) { return entry(constituent).doodson; }

double angular_speed(Constituent constituent) {
  // Difference over a century: long enough against rounding, short enough against the curvature of the
  // longitudes.
  constexpr double half_century_s = 50.0 * 365.25 * 86'400.0;
  constexpr double epoch_s =
      946'684'800.0;  // a midnight, as are both ends, so that full days cancel in the lunar time
  const MeanLongitudes before = mean_longitudes(core::from_unix_seconds(epoch_s - half_century_s));
  const MeanLongitudes after = mean_longitudes(core::from_unix_seconds(epoch_s + half_century_s));
  const auto a = before.in_doodsons_order();
  const auto b = after.in_doodsons_order();
  constexpr double turns_of_day_deg = 2.0 * half_century_s / 86'400.0 * 360.0;
  const auto& doodson = entry(constituent).doodson;
  double degrees = doodson[0] * turns_of_day_deg;
  for (std::size_t i = 0; i < 6; ++i) degrees += doodson[i] * (b[i] - a[i]);
  return core::degrees_to_radians(degrees / (2.0 * half_century_s));
}

std::complex<double> equilibrium_phasor(Constituent constituent, const MeanLongitudes& longitudes) {
  const Entry& line = entry(constituent);
  const auto angles = longitudes.in_doodsons_order();
  double degrees = 90.0 * line.quarter_turns;
  for (std::size_t i = 0; i < 6; ++i) degrees += line.doodson[i] * std::fmod(angles[i], 360.0);
  return std::polar(1.0, core::degrees_to_radians(std::fmod(degrees, 360.0)));
}

std::complex<double> nodal_factor(Constituent constituent, const MeanLongitudes& longitudes) {
  std::complex<double> result{1.0};
  for (const auto& [nodal, times] : entry(constituent).nodal)
    result *= repeated(nodal_factor(nodal, longitudes), times);
  return result;
}

}  // namespace floeplan::tide
