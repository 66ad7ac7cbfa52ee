#include "scene_io/mesh/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <numbers>
#include <random>
#include <utility>

namespace candela::mesh {
namespace {

using Polygon = std::vector<Vec3d>;
using std::numbers::pi;

double signed_area(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}
double signed_area(const Polygon& polygon) {
  double sum = 0.0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    sum += signed_area(polygon[0], polygon[i - 1], polygon[i]);
  }
  return sum;
}
double bounding_area(const Polygon& polygon) {
  Vec3d low = polygon[0], high = polygon[0];
  for (const Vec3d& p : polygon) low = glm::min(low, p), high = glm::max(high, p);
  return (high.x - low.x) * (high.y - low.y) + 1e-300;
}

// Each edge of the polygon is in one triangle and each other edge in two, run through once either
// way: with the right area and no flipped triangle that is a covering without overlaps.
bool is_closed_fan_of_edges(const std::vector<IndexTriangle>& triangles, std::size_t corners) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const IndexTriangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : uses) {
    if (count != 1) return false;
    const bool is_side = (edge.first + 1) % corners == edge.second;
    if (is_side == uses.contains({edge.second, edge.first})) return false;
  }
  return uses.size() == corners + 2 * (corners - 3);
}

std::vector<IndexTriangle> triangulated(const Polygon& polygon) {
  Triangulator triangulator;
  const auto span = triangulator.triangulate(polygon);
  return {span.begin(), span.end()};
}

void expect_covered_once(const Polygon& polygon, const char* what) {
  const std::vector<IndexTriangle> triangles = triangulated(polygon);
  ASSERT_EQ(triangles.size(), polygon.size() - 2) << what;
  const double orientation = signed_area(polygon) < 0 ? -1.0 : 1.0;
  // Snapping to 2^-30 of the extent moves an edge's triangles by that share of the box.
  const double slack = bounding_area(polygon) * 0x1p-28;
  double sum = 0.0;
  double flipped = 0.0;
  for (const IndexTriangle& t : triangles) {
    const double area = orientation * signed_area(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
    sum += std::abs(area);
    flipped = std::max(flipped, -area);
  }
  EXPECT_LE(flipped, slack) << what;
  EXPECT_NEAR(sum, std::abs(signed_area(polygon)), slack * std::sqrt(double(polygon.size())))
      << what;
  EXPECT_TRUE(is_closed_fan_of_edges(triangles, polygon.size())) << what;
}

Polygon star(int corners, double inner, std::mt19937& random) {
  std::uniform_real_distribution<double> radius(inner, 1.0);
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * i / corners;
    const double r = radius(random);
    polygon.push_back({r * std::cos(angle), r * std::sin(angle), 0.0});
  }
  return polygon;
}

Polygon circle(int corners) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    polygon.push_back({std::cos(2 * pi * i / corners), std::sin(2 * pi * i / corners), 0.0});
  }
  return polygon;
}

// A band wound around the centre: out along one side and back along the other.
Polygon spiral(int corners, double turns, bool is_logarithmic) {
  Polygon polygon;
  const int half = corners / 2;
  const auto point = [&](double along, double width) {
    const double angle = 2 * pi * turns * along;
    const double r =
        is_logarithmic ? std::exp(8 * (along - 1)) * width : (along * turns + width) / turns;
    return Vec3d{r * std::cos(angle), r * std::sin(angle), 0.0};
  };
  // The band's outer side stays within the inner side one turn later.
  const double outer = is_logarithmic ? std::exp(4.0 / turns) : 0.9;
  const double inner = is_logarithmic ? 1.0 : 0.5;
  for (int i = 0; i < half; ++i) polygon.push_back(point(double(i) / half, outer));
  for (int i = half - 1; i >= 0; --i) polygon.push_back(point(double(i) / half, inner));
  return polygon;
}

Polygon square_spiral(int turns) {
  Polygon outer, inner;
  for (int i = 0; i < turns; ++i) {
    const double r = turns - i;
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      const double shrink = (x == -1 && y == 1) ? 0.0 : 0.0;
      outer.push_back({x * (r - shrink), y * r - (x == -1 && y == -1 && i > 0 ? -1.0 : 0.0), 0.0});
      inner.push_back(
          {x * (r - 0.25), y * (r - 0.25) - (x == -1 && y == -1 && i > 0 ? -1.0 : 0.0), 0.0});
    }
  }
  std::reverse(inner.begin(), inner.end());
  outer.insert(outer.end(), inner.begin(), inner.end());
  return outer;
}

Polygon comb(int teeth, double slant) {
  Polygon polygon{{0.0, -1.0, 0.0}, {double(teeth), -1.0, 0.0}};
  for (int i = teeth; i > 0; --i) {
    polygon.push_back({i - 0.1, 0.0, 0.0});
    polygon.push_back({i - 0.5 + slant, double(teeth), 0.0});
    polygon.push_back({i - 0.9, 0.0, 0.0});
  }
  return polygon;
}

// Teeth from both sides, interlocked.
Polygon zipper(int teeth) {
  Polygon lower, upper;
  for (int i = 0; i < teeth; ++i) {
    lower.insert(lower.end(), {{double(i), 0, 0}, {i + 0.5, 9.0, 0}});
    upper.insert(upper.end(), {{i + 0.1, 1.8 + 0.05, 0}, {i + 0.55, 10.0, 0}});
  }
  std::reverse(upper.begin(), upper.end());
  lower.insert(lower.end(), upper.begin(), upper.end());
  return lower;
}

Polygon reversed(Polygon polygon) {
  std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

Polygon turned(Polygon polygon, int axis) {
  for (Vec3d& p : polygon) p = Vec3d{p[axis % 3], p[(axis + 1) % 3], p[(axis + 2) % 3]};
  return polygon;
}

TEST(Unit_Triangulate, CoversRandomStarsOnce) {
  std::mt19937 random(7);
  for (int corners = 4; corners < 200; ++corners) {
    const Polygon polygon = star(corners, corners % 3 == 0 ? 0.02 : 0.4, random);
    expect_covered_once(polygon, "star");
    expect_covered_once(reversed(polygon), "reversed star");
  }
}

TEST(Unit_Triangulate, CoversNastyShapesOnce) {
  for (const int size : {5, 6, 7, 16, 100, 2000}) {
    expect_covered_once(circle(size), "circle");
    expect_covered_once(comb(size, 0.0), "comb");
    expect_covered_once(comb(size, 30.0), "slanting comb");
    expect_covered_once(reversed(comb(size, 0.3)), "reversed comb");
    expect_covered_once(zipper(size), "zipper");
  }
  expect_covered_once(spiral(4000, 20, false), "spiral");
  expect_covered_once(spiral(4000, 20, true), "logarithmic spiral");
  expect_covered_once(square_spiral(300), "square spiral");
}

TEST(Unit_Triangulate, TakesTheDiagonalOfAConcaveQuadThatLiesInside) {
  // A dart: the diagonal 1-3 is the shorter one and runs outside.
  expect_covered_once({{0, 0, 0}, {0.5, 3, 0}, {0, 2, 0}, {-0.5, 3, 0}}, "dart");
  const Polygon kite{{0, 0, 0}, {1, 1, 0}, {0, 5, 0}, {-1, 1, 0}};
  EXPECT_EQ(triangulated(kite), (std::vector<IndexTriangle>{{0, 1, 3}, {1, 2, 3}}));
}

TEST(Unit_Triangulate, WorksInAnyPlaneAndAtAnyScale) {
  std::mt19937 random(11);
  const Polygon polygon = star(50, 0.1, random);
  const std::vector<IndexTriangle> expected = triangulated(polygon);
  for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(triangulated(turned(polygon, axis)), expected);
  for (const double scale : {1e-300, 1e-30, 1e30, 1e300}) {
    Polygon scaled = polygon;
    for (Vec3d& p : scaled) p *= scale;
    EXPECT_EQ(triangulated(scaled).size(), expected.size()) << scale;
    double sum = 0.0;
    for (const IndexTriangle& t : triangulated(scaled)) {
      sum += signed_area(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
    }
    EXPECT_NEAR(sum, signed_area(polygon), 1e-7) << scale;
  }
}

TEST(Unit_Triangulate, KeepsCollinearCornersInUse) {
  Polygon polygon;
  for (int i = 0; i < 10; ++i) polygon.push_back({double(i), 0.0, 0.0});
  for (int i = 0; i < 10; ++i) polygon.push_back({10.0, double(i), 0.0});
  for (int i = 0; i < 10; ++i) polygon.push_back({10.0 - i, 10.0, 0.0});
  for (int i = 0; i < 10; ++i) polygon.push_back({0.0, 10.0 - i, 0.0});
  expect_covered_once(polygon, "square with corners on its sides");
  for (const IndexTriangle& t : triangulated(polygon)) {
    EXPECT_GT(signed_area(polygon[t[0]], polygon[t[1]], polygon[t[2]]), 0.0);
  }
}

// An outline, a bridge to each hole, the hole, and the bridge back.
Polygon with_holes(int holes, int corners_of_hole) {
  Polygon polygon{{0, 0, 0}};
  for (int h = 0; h < holes; ++h) {
    const Vec3d centre{h + 0.5, 0.5, 0.0};
    polygon.push_back({h + 0.5, 0.0, 0.0});
    for (int i = 0; i <= corners_of_hole; ++i) {
      const double angle = -pi / 2 - 2 * pi * (i % corners_of_hole) / corners_of_hole;
      polygon.push_back(centre + 0.3 * Vec3d{std::cos(angle), std::sin(angle), 0.0});
    }
    polygon.push_back({h + 0.5, 0.0, 0.0});
  }
  polygon.insert(polygon.end(), {{double(holes), 0, 0}, {double(holes), 1, 0}, {0, 1, 0}});
  return polygon;
}

TEST(Unit_Triangulate, CoversPolygonsWithBridgedHoles) {
  for (const auto& [holes, corners] : {std::pair{1, 4}, {1, 3}, {3, 7}, {20, 50}}) {
    const Polygon polygon = with_holes(holes, corners);
    const std::vector<IndexTriangle> triangles = triangulated(polygon);
    ASSERT_EQ(triangles.size(), polygon.size() - 2);
    double sum = 0.0;
    for (const IndexTriangle& t : triangles) {
      const double area = signed_area(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
      EXPECT_GE(area, -1e-8 * holes * holes);
      sum += std::abs(area);
    }
    EXPECT_NEAR(sum, signed_area(polygon), 1e-7 * holes * holes) << holes << ' ' << corners;
  }
}

TEST(Stress_Triangulate, BadPolygonsEndInTheRightCountOfTriangles) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  std::uniform_int_distribution<int> few(0, 3);
  for (int round = 0; round < 300; ++round) {
    Polygon crossing, lattice;
    for (int i = 0; i < 3 + round; ++i) {
      crossing.push_back({any(random), any(random), any(random)});
      lattice.push_back({double(few(random)), double(few(random)), 0.0});
    }
    EXPECT_EQ(triangulated(crossing).size(), crossing.size() - 2);
    EXPECT_EQ(triangulated(lattice).size(), lattice.size() - 2);
  }
  EXPECT_EQ(triangulated(Polygon(1000, Vec3d{2.0})).size(), 998u);
  EXPECT_TRUE(triangulated(Polygon(2, Vec3d{0.0})).empty());
  Polygon line;
  for (int i = 0; i < 1000; ++i) line.push_back({double(i % 37), 2.0 * (i % 37), 0.0});
  EXPECT_EQ(triangulated(line).size(), 998u);
}

// 200,000 corners each (noise, which is not simple and uses up the allowance of work: 25,000). No
// time is asserted; a quadratic method would run into the suite's limit.
TEST(Stress_Triangulate, LargePolygonsEnd) {
  constexpr int corners = 200'000;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  Polygon noise, pentagram, line, again;
  for (int i = 0; i < corners; ++i) {
    if (i % 8 == 0) noise.push_back({any(random), any(random), 0.0});
    const double angle = 2 * pi * i * 0.4 / 1.00001;
    pentagram.push_back({std::cos(angle), std::sin(angle), 0.0});
    line.push_back({double(i), 0.0, 0.0});
    again.push_back({double(i % 3 == 1), double(i % 3 == 2), 0.0});
  }
  const std::vector<std::pair<const char*, Polygon>> polygons{
      {"circle", circle(corners)},
      {"star", star(corners, 0.01, random)},
      {"comb", comb(corners / 3, 0.0)},
      {"slanting comb", comb(corners / 3, 300.0)},
      {"zipper", zipper(corners / 4)},
      {"spiral", spiral(corners, 100, false)},
      {"long spiral", spiral(corners, 2000, false)},
      {"logarithmic spiral", spiral(corners, 100, true)},
      {"square spiral", square_spiral(corners / 8)},
      {"holes", with_holes(1000, 200)},
      {"noise", noise},
      {"pentagram", pentagram},
      {"straight", line},
      {"point", Polygon(corners, Vec3d{1.0})},
      {"triangle again and again", again},
  };
  for (const auto& [name, polygon] : polygons) {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(triangulated(polygon).size(), polygon.size() - 2) << name;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    RecordProperty(name, std::to_string(seconds.count()));
    if (std::getenv("CANDELA_TIMES") != nullptr) {
      fmt::print("{:20} {:.3f} s\n", name, seconds.count());
    }
  }
}

// Both bows that one can tie of a square's corners become the square again, in the orientation of
// the bow's first three corners.
TEST(Unit_Triangulate, UntiesBows) {
  const Polygon square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  for (const std::array<std::size_t, 4>& o :
       {std::array<std::size_t, 4>{0, 2, 3, 1}, {0, 1, 3, 2}, {3, 1, 2, 0}, {2, 0, 1, 3}}) {
    const Polygon bow{square[o[0]], square[o[1]], square[o[2]], square[o[3]]};
    Triangulator triangulator;
    const auto triangles = triangulator.triangulate(bow);
    ASSERT_TRUE(triangulator.was_bow());
    ASSERT_EQ(triangles.size(), 2u);
    const double side = signed_area(bow[0], bow[1], bow[2]);
    for (const IndexTriangle& t : triangles) {
      EXPECT_DOUBLE_EQ(signed_area(bow[t[0]], bow[t[1]], bow[t[2]]), side);
    }
  }
  Triangulator triangulator;
  EXPECT_EQ(triangulator.triangulate(square).size(), 2u);
  EXPECT_FALSE(triangulator.was_bow());
  EXPECT_EQ(triangulator.triangulate(Polygon(4, Vec3d{1.0})).size(), 2u);
  EXPECT_FALSE(triangulator.was_bow());
}

}  // namespace
}  // namespace candela::mesh
