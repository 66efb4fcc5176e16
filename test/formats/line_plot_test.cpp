// Plots show every point at its position.
#include "formats/line_plot.h"

#include <doctest/doctest.h>

#include <limits>

using namespace resect;

namespace {

int occurrences(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

}  // namespace

TEST_CASE("a line starts and ends where its first and last points are on the axes") {
  const std::string svg = toSvg({"Force", "s", "N", {{"baton", {{0, 0}, {5, 2.5}, {10, 5}}}}});
  // The plotting area: x from 64 to 880 for 0 to 10 s, y from 312 up to 44 for 0 to 5 N.
  CHECK(svg.find("M64.0 312.0L472.0 178.0L880.0 44.0") != std::string::npos);
  CHECK(svg.find(">baton<") != std::string::npos);
  CHECK(svg.find(">10<") != std::string::npos);
}

TEST_CASE("a value that is no number leaves a gap in its line") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::string svg = toSvg({"", "", "", {{"a", {{0, 1}, {1, none}, {2, 1}, {3, 1}}}}});
  CHECK(svg.find("nan") == std::string::npos);
  const std::size_t path = svg.find("fill=\"none\"");
  const std::string line = svg.substr(svg.rfind("<path", path), path - svg.rfind("<path", path));
  CHECK(occurrences(line, "M") == 2);
  CHECK(occurrences(line, "L") == 1);
}

TEST_CASE("plots of nothing and of one constant are still pictures, and names are escaped") {
  CHECK(toSvg({"empty", "", "", {}}).ends_with("</svg>\n"));
  const std::string svg = toSvg({"a < b", "", "", {{"x&y", {{0, 0}, {0, 0}}}}});
  CHECK(svg.find("a &lt; b") != std::string::npos);
  CHECK(svg.find("x&amp;y") != std::string::npos);
  CHECK(svg.find("inf") == std::string::npos);
  CHECK(svg.find("nan") == std::string::npos);
}

TEST_CASE("negative values are on the axes too") {
  const std::string svg = toSvg({"", "", "", {{"a", {{0, -3}, {1, 4}}}}});
  CHECK(svg.find(">-4<") != std::string::npos);
  CHECK(svg.find(">4<") != std::string::npos);
}
