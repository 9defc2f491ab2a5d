#include "engine/tide/constituent.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/engine/tide/published.hpp"

namespace floeplan::tide::constituent_test {
namespace {

using test::utc;

double degrees_an_hour(const char* name) {
  return core::radians_to_degrees(angular_speed(find_constituent(name).value())) * 3600.0;
}

TEST(MeanLongitudesOfTheSunAndMoon, AreThoseOfTheAlmanac) {
  // Meeus 1998, example 47.a: 1992-04-12, 0 h dynamical time; the sun by his equation (25.2).
  const MeanLongitudes longitudes = mean_longitudes(utc(1992, 4, 12));

  EXPECT_NEAR(std::fmod(longitudes.moon_deg, 360.0) + 360.0, 134.290182, 1e-4);
  EXPECT_NEAR(std::fmod(longitudes.moon_deg - longitudes.lunar_perigee_deg, 360.0) + 360.0, 5.150833, 1e-3);
}

TEST(Constituent, GoesByItsOldAndNewNamesInAnyCase) {
  EXPECT_EQ(find_constituent("lambda2"), find_constituent("LDA2"));
  EXPECT_EQ(find_constituent("NO1"), find_constituent("m1"));
  EXPECT_EQ(find_constituent("rho"), find_constituent("RHO1"));
  EXPECT_EQ(constituent_name(find_constituent("2n2").value()), "2N2");
}

TEST(Constituent, ThatNobodyKnowsIsNotFound) {
  EXPECT_FALSE(find_constituent("Z9"));
  EXPECT_FALSE(find_constituent(""));
}

TEST(Constituent, HasTheSpeedOfSchuremansTable) {
  // Schureman 1958, table 2, degrees an hour.
  EXPECT_NEAR(degrees_an_hour("M2"), 28.9841042, 2e-7);
  EXPECT_NEAR(degrees_an_hour("S2"), 30.0, 1e-9);
  EXPECT_NEAR(degrees_an_hour("K1"), 15.0410686, 2e-7);
  EXPECT_NEAR(degrees_an_hour("O1"), 13.9430356, 2e-7);
  EXPECT_NEAR(degrees_an_hour("N2"), 28.4397295, 2e-7);
  EXPECT_NEAR(degrees_an_hour("M1"), 14.4966939, 2e-7);
  EXPECT_NEAR(degrees_an_hour("2SM2"), 31.0158958, 2e-7);
  EXPECT_NEAR(degrees_an_hour("MM"), 0.5443747, 2e-7);
}

TEST(Constituent, HasANameOfItsOwn) {
  std::set<std::string> names;
  for (const Constituent line : all_constituents()) EXPECT_TRUE(names.insert(constituent_name(line)).second);
  EXPECT_GE(names.size(), 150U);
}

TEST(Constituent, OfShallowWaterTurnsWithItsParentsTogether) {
  const MeanLongitudes then = mean_longitudes(utc(2026, 11, 21, 17));
  const auto phasor = [&](const char* name) {
    return equilibrium_phasor(find_constituent(name).value(), then);
  };
  const auto nodal = [&](const char* name) { return nodal_factor(find_constituent(name).value(), then); };

  EXPECT_LT(std::abs(phasor("2MS6") - phasor("M2") * phasor("M2") * phasor("S2")), 1e-12);
  EXPECT_LT(std::abs(phasor("2MK3") - phasor("M2") * phasor("M2") * std::conj(phasor("K1"))), 1e-12);
  EXPECT_LT(std::abs(nodal("2MK3") - nodal("M2") * nodal("M2") * std::conj(nodal("K1"))), 1e-12);
  EXPECT_GT(std::abs(nodal("2MK3")), 0.9 * std::abs(nodal("K1")));
}

TEST(EquilibriumArgument, IsThatOfTheProgramsOfOtisAtTheirEpoch) {
  // Phases at 1992-01-01 of the table "constit" in OTIS and TMD, radians.
  const MeanLongitudes epoch = mean_longitudes(utc(1992, 1, 1));
  const auto off = [&](const char* name, double phase_rad) {
    return std::abs(
        std::arg(equilibrium_phasor(find_constituent(name).value(), epoch) * std::polar(1.0, -phase_rad)));
  };

  EXPECT_LT(off("M2", 1.731557546), 5e-3);
  EXPECT_LT(off("S2", 0.0), 5e-3);
  EXPECT_LT(off("K1", 0.173003674), 5e-3);
  EXPECT_LT(off("O1", 1.558553872), 5e-3);
  EXPECT_LT(off("N2", 6.050721243), 5e-3);
  EXPECT_LT(off("P1", 6.110181633), 5e-3);
  EXPECT_LT(off("K2", 3.487600001), 5e-3);
  EXPECT_LT(off("Q1", 5.877717569), 5e-3);
  EXPECT_LT(off("2N2", 4.086699633), 5e-3);
  EXPECT_LT(off("MU2", 3.463115091), 5e-3);
  EXPECT_LT(off("NU2", 5.427136701), 5e-3);
  EXPECT_LT(off("L2", 0.553986502), 5e-3);
  EXPECT_LT(off("T2", 0.052841931), 5e-3);
  EXPECT_LT(off("J1", 2.137025284), 5e-3);
  EXPECT_LT(off("OO1", 1.929046130), 5e-3);
  EXPECT_LT(off("RHO1", 5.254133027), 5e-3);
  EXPECT_LT(off("MF", 1.756042456), 5e-3);
  EXPECT_LT(off("MM", 1.964021610), 5e-3);
  EXPECT_LT(off("M4", 3.463115091), 5e-3);
  EXPECT_LT(off("MS4", 1.731557546), 5e-3);
  EXPECT_LT(off("MN4", 1.499093481), 5e-3);
}

TEST(NodalFactor, SwellsAndShrinksByTheSharesOfSchuremansTable) {
  // Schureman 1958, table 14, the largest and smallest f of 18.6 years: M2 1.038 and 0.963, K1 1.113 and 0.882,
  // O1 1.183 and 0.806, K2 1.317 and 0.748, Mf 1.454 and 0.623, J1 1.167 and 0.827, OO1 1.783 and 0.484.
  const auto expect_span = [](const char* name, double least, double greatest) {
    double low = 9.0;
    double high = 0.0;
    for (int month = 0; month < 224; ++month) {
      const auto then = mean_longitudes(utc(2000, 1, 1) + core::Seconds{86'400.0 * 30.4 * month});
      const double f = std::abs(nodal_factor(find_constituent(name).value(), then));
      low = std::min(low, f);
      high = std::max(high, f);
    }
    EXPECT_NEAR(low, least, 0.015) << name;
    EXPECT_NEAR(high, greatest, 0.015) << name;
  };
  expect_span("M2", 0.963, 1.038);
  expect_span("K1", 0.882, 1.113);
  expect_span("O1", 0.806, 1.183);
  expect_span("K2", 0.748, 1.317);
  expect_span("MF", 0.623, 1.454);
  expect_span("J1", 0.827, 1.167);
}

}  // namespace
}  // namespace floeplan::tide::constituent_test
