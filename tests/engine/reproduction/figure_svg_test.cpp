
#include <gtest/gtest.h>

#include <regex>

#include "engine/reproduction/figure.hpp"

namespace floeplan::reproduction::figure_svg_test {
namespace {

/// Every start tag has its end tag, in order; attributes are not looked at.
bool is_balanced(const std::string& svg) {
  static const std::regex tag{R"(<(/?)(\w+)[^<>]*?(/?)>)"};
  std::vector<std::string> open;
  for (std::sregex_iterator each{svg.begin(), svg.end(), tag}; each != std::sregex_iterator{}; ++each) {
    const std::smatch& match = *each;
    if (match[3] == "/") continue;
    if (match[1] != "/") {
      open.push_back(match[2]);
    } else if (open.empty() || open.back() != match[2]) {
      return false;
    } else {
      open.pop_back();
    }
  }
  return open.empty();
}

const std::vector<Figure>& figures() {
  static const std::vector<Figure> all = reproduce_figures();
  return all;
}

TEST(Figures, AreThoseOfThePaperWithAllTheirPaths) {
  ASSERT_EQ(figures().size(), 6U);
  const std::vector<std::size_t> paths{4, 4, 4, 1, 4, 3};
  for (std::size_t i = 0; i < figures().size(); ++i) {
    EXPECT_EQ(figures()[i].number, 5 + static_cast<int>(i));
    for (const FigurePanel& panel : figures()[i].panels) EXPECT_EQ(panel.paths.size(), paths[i]);
  }
}

TEST(Figures, LeadFromStartToGoalInTheTimesOfTheTables) {
  const Figure& seventh = figures()[2];
  for (const FigurePath& path : seventh.panels.front().paths) {
    EXPECT_EQ(path.points.front(), seventh.start);
    EXPECT_EQ(path.points.back(), seventh.goal);
  }
  EXPECT_NEAR(seventh.panels.front().paths[2].travel_time, 162.362, 0.02);
  EXPECT_NEAR(figures()[4].panels.front().paths[3].travel_time, 17.1588, 0.0001);
}

TEST(Figures, EndTheTimeSequenceAtTheGoal) {
  const Figure& eighth = figures()[3];
  ASSERT_EQ(eighth.panels.size(), 6U);
  EXPECT_EQ(eighth.panels.front().vehicle.value(), eighth.start);
  EXPECT_EQ(eighth.panels.back().vehicle.value(), eighth.goal);
}

TEST(FigureSvg, IsAWholeDocumentWithoutNumbersThatAreNone) {
  for (const Figure& figure : figures()) {
    const std::string svg = figure_svg(figure);

    EXPECT_EQ(svg.substr(0, 4), "<svg");
    EXPECT_TRUE(is_balanced(svg)) << figure.number;
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    for (const FigurePath& path : figure.panels.front().paths) {
      EXPECT_NE(svg.find(path.name + ": "), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace floeplan::reproduction::figure_svg_test
