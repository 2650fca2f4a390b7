// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Fair curves through 18 hard inputs, beside those of others:
//   compare_fair_curves [PICTURE.svg]
// prints a table and draws the curves with the combs of their curvature. A cell has the number of
// inflections; L^3 int (dk/ds)^2 ds of the pieces; and, where they are not small, the largest jump
// of the curvature times the size of the points, and how far the curve leaves the convex hull of
// the points, in per cent of their size. All is measured on samples, in one way for all curves.

#include "fair_curves_by_others.h"

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/blends/interpolate_fair.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/squared_distance_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

namespace {

typedef GC::Traits_2<CGAL::Simple_cartesian<double>> Traits;
typedef Traits::Point Point;

struct Input {
  std::string name;
  bool closed;
  Plane_points points;
};

std::vector<Input> hard_inputs() {
  std::vector<Input> all;
  const auto add = [&](const std::string& name, bool closed, int n, const std::function<Plane_point(int)>& point) {
    Input input{name, closed, {}};
    for (int i = 0; i < n; ++i) input.points.push_back(point(i));
    all.push_back(input);
  };
  const auto given = [&](const std::string& name, bool closed, const Plane_points& points) {
    all.push_back({name, closed, points});
  };
  const auto ellipse = [](double a) {
    return [a](int i) { return Plane_point(a * std::cos(2 * pi * i / 12), std::sin(2 * pi * i / 12)); };
  };
  add("circle, 7 points", true, 7, [](int i) { return std::polar(1., 2 * pi * i / 7); });
  add("circle, uneven", true, 9, [](int i) { return std::polar(1., 2 * pi * std::pow(i / 9., 1.8)); });
  add("ellipse 4:1", true, 12, ellipse(4));
  add("ellipse 10:1", true, 12, ellipse(10));
  add("NACA 0012", true, 17, [](int i) {
    const double x = (1 + std::cos(2 * pi * i / 17)) / 2,
                 y = .6 * (.2969 * std::sqrt(x) - .126 * x - .3516 * x * x + .2843 * x * x * x - .1036 * x * x * x * x);
    return Plane_point(x, 2 * i < 17 ? y : -y);
  });
  add("parabola", false, 7, [](int i) { return Plane_point(i - 3, (i - 3) * (i - 3)); });
  add("spiral", false, 16, [](int i) { return std::polar(1. + i, .7 * i); });
  add("sine, 4 points a wave", false, 13, [](int i) { return Plane_point(i, std::round(1.5 * std::sin(pi * i / 2))); });
  add("star", true, 10, [](int i) { return std::polar(i % 2 == 0 ? 2. : 1., pi * i / 5); });
  given("square", true, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  given("long rectangle", true, {{0, 0}, {6, 0}, {6, 1}, {0, 1}});
  given("triangle, one side cut", true, {{0, 0}, {4, 0}, {2, 3}, {1.9, 3}});
  given("zigzag", false, {{0, 0}, {1, 3}, {2, 0}, {3, 3}, {4, 0}, {5, 3}});
  given("step", false, {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3.2, 2}, {4, 2}, {5, 2}, {6, 2}});
  given("bump on a line", false, {{0, 0}, {1, 0}, {2, 0}, {3, .4}, {4, 0}, {5, 0}, {6, 0}});
  given("short beside long", false, {{0, 0}, {4, .5}, {4.1, .6}, {8, 0}, {8.1, -.2}});
  given("figure of eight", true, {{0, 0}, {2, 1}, {3, 0}, {2, -1}, {0, 0.05}, {-2, 1}, {-3, 0}, {-2, -1}});
  std::mt19937 random(1);
  add("ten random points", false, 10, [&](int i) {
    const double x = static_cast<double>(random()), y = static_cast<double>(random());
    return Plane_point(i + x / 4294967296., 4 * y / 4294967296.);
  });
  return all;
}

Sampled_curve fair_spline(const Plane_points& p, bool closed) {
  std::vector<Point> points;
  for (const Plane_point& x : p) points.emplace_back(x.real(), x.imag());
  const GC::Fair_spline<Traits> spline =
      GC::interpolate_fair<Traits>(points.begin(), points.end(), closed ? GC::Closure::closed : GC::Closure::open);
  Sampled_curve curve;
  for (const auto& piece : spline.segments()) {
    Plane_points control;
    for (const Point& x : piece) control.emplace_back(x.x(), x.y());
    curve.push_back(sampled_bezier(control));
  }
  return curve;
}

struct Measured {
  int inflections = 0;
  double variation = 0, jump = 0, overshoot = 0;
};

double size_of(const Plane_points& p) {
  double size = 0;
  for (const Plane_point& a : p)
    for (const Plane_point& b : p) size = (std::max)(size, std::abs(b - a));
  return size;
}

Measured measured(const Sampled_curve& curve, const Input& input) {
  Measured m;
  const double size = size_of(input.points);
  double length = 0, integral = 0;
  int sign = 0, first_sign = 0;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const std::vector<Curve_sample>& piece = curve[k];
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const double bend = piece[i].curvature * size;
      if (std::abs(bend) > 1e-4) {
        const int now = bend > 0 ? 1 : -1;
        if (sign == 0) first_sign = now;
        m.inflections += sign * now < 0;
        sign = now;
      }
      if (i == 0) continue;
      const double step = std::abs(piece[i].point - piece[i - 1].point),
                   change = piece[i].curvature - piece[i - 1].curvature;
      length += step;
      if (step > 0 && std::isfinite(change)) integral += change * change / step;
    }
    if (k > 0 || input.closed) {
      const std::vector<Curve_sample>& before = curve[(k + curve.size() - 1) % curve.size()];
      m.jump = (std::max)(m.jump, size * std::abs(piece.front().curvature - before.back().curvature));
    }
  }
  m.inflections += input.closed && sign * first_sign < 0;
  m.variation = length * length * length * integral;
  std::vector<Point> points, hull;
  for (const Plane_point& x : input.points) points.emplace_back(x.real(), x.imag());
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
  for (const std::vector<Curve_sample>& piece : curve)
    for (const Curve_sample& s : piece) {
      const Point p(s.point.real(), s.point.imag());
      bool outside = false;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < hull.size(); ++i) {
        const Point &a = hull[i], &b = hull[(i + 1) % hull.size()];
        outside = outside || CGAL::right_turn(a, b, p);
        least = (std::min)(least, CGAL::squared_distance(p, Traits::Kernel::Segment_2(a, b)));
      }
      if (outside) m.overshoot = (std::max)(m.overshoot, std::sqrt(least) / size);
    }
  return m;
}

std::string cell(const std::optional<Sampled_curve>& curve, const Input& input) {
  if (!curve) return "no result";
  const Measured m = measured(*curve, input);
  char text[100];
  int n = std::snprintf(text, sizeof text, m.variation < 1e6 ? "%d, %.0f" : "%d, %.0e", m.inflections, m.variation);
  if (m.jump > .05) n += std::snprintf(text + n, sizeof text - n, ", jump %.1f", m.jump);
  if (m.overshoot > .005) std::snprintf(text + n, sizeof text - n, ", out %.0f %%", 100 * m.overshoot);
  return text;
}

struct Frame {
  double left = 1e300, right = -1e300, low = 1e300, high = -1e300;
  void add(const Plane_point& p) {
    left = (std::min)(left, p.real()), right = (std::max)(right, p.real());
    low = (std::min)(low, p.imag()), high = (std::max)(high, p.imag());
  }
};

// Draws a curve with its comb and its points into a cell of the picture, in tenths of a pixel.
void draw(std::ostream& os, const std::optional<Sampled_curve>& curve, const Input& input, const Frame& frame, double x,
          double y, double width, double height) {
  const double scale = 7.4 * (std::min)(width / (frame.right - frame.left), height / (frame.high - frame.low)),
               size = size_of(input.points);
  int last_x = 0, last_y = 0;
  const auto out = [&](const char* command, const Plane_point& p, bool relative) {
    const int now_x = static_cast<int>(10 * x + 5 * width + scale * (p.real() - (frame.left + frame.right) / 2)),
              now_y = static_cast<int>(10 * y + 5 * height - scale * (p.imag() - (frame.low + frame.high) / 2));
    os << command << now_x - (relative ? last_x : 0) << ' ' << now_y - (relative ? last_y : 0);
    last_x = now_x, last_y = now_y;
  };
  const auto path = [&](const Plane_points& line, const char* style) {
    os << "<path " << style << " d=\"";
    for (std::size_t i = 0; i < line.size(); ++i) out(i == 0 ? "M" : "l", line[i], i > 0);
    os << "\"/>\n";
  };
  if (curve) {
    Plane_points line, comb;
    const std::size_t stride = (std::max)(std::size_t(1), curve->size() * samples_of_a_piece / 110);
    for (const std::vector<Curve_sample>& piece : *curve)
      for (std::size_t i = 0;; i = (std::min)(i + stride, piece.size() - 1)) {
        const bool at_end = i + 1 == piece.size();
        const Plane_point step = at_end ? piece[i].point - piece[i - 1].point : piece[i + 1].point - piece[i].point,
                          normal = std::abs(step) > 0 ? step / std::abs(step) * Plane_point(0, -1) : Plane_point(0);
        const double tooth = (std::max)(-.18, (std::min)(.18, .012 * piece[i].curvature * size)) * size;
        line.push_back(piece[i].point);
        comb.push_back(piece[i].point + tooth * normal);
        if (at_end) break;
      }
    path(comb, "stroke=\"#9bc\" stroke-width=\"7\"");
    path(line, "stroke=\"#124\" stroke-width=\"12\"");
  }
  os << "<path stroke=\"#c22\" stroke-width=\"30\" stroke-linecap=\"round\" d=\"";
  for (const Plane_point& p : input.points) {
    out("M", p, false);
    os << "h0";
  }
  os << "\"/>\n";
}

} // namespace

int main(int argc, char* argv[]) {
  const std::vector<std::pair<std::string, std::function<std::optional<Sampled_curve>(const Plane_points&, bool)>>>
      methods = {{"interpolate_fair", fair_spline},
                 {"C2, centripetal", centripetal_spline},
                 {"Hobby", hobby_spline},
                 {"spiro", spiro_spline},
                 {"kappa-curve", kappa_curve}};
  constexpr double width = 180, height = 100, top = 24, left = 130;
  const std::vector<Input> inputs = hard_inputs();
  std::ofstream picture;
  if (argc > 1) picture.open(argv[1]);
  const int w = static_cast<int>(left + width * static_cast<double>(methods.size())),
            h = static_cast<int>(top + height * static_cast<double>(inputs.size()));
  picture << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << w << ' ' << h << "\" width=\"" << w
          << "\" height=\"" << h << "\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"" << w
          << "\" height=\"" << h << "\" fill=\"#ffffff\"/>\n<g fill=\"none\" transform=\"scale(.1)\">\n";
  std::string texts;
  const auto write = [&](double x, double y, const std::string& words) {
    texts += "<text x=\"" + std::to_string(static_cast<int>(x)) + "\" y=\"" + std::to_string(static_cast<int>(y)) +
             "\">" + words + "</text>\n";
  };
  std::printf("| Points");
  for (std::size_t j = 0; j < methods.size(); ++j) {
    std::printf(" | %s", methods[j].first.c_str());
    write(left + width * static_cast<double>(j) + 10, 16, methods[j].first);
  }
  std::printf(" |\n|---|---|---|---|---|---|\n");
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double y = top + height * static_cast<double>(i);
    std::printf("| %s", inputs[i].name.c_str());
    write(4, y + height / 2, inputs[i].name);
    std::vector<std::optional<Sampled_curve>> curves;
    Frame frame;
    for (const auto& method : methods) {
      curves.push_back(method.second(inputs[i].points, inputs[i].closed));
      std::printf(" | %s", cell(curves.back(), inputs[i]).c_str());
      if (curves.back())
        for (const std::vector<Curve_sample>& piece : *curves.back())
          for (const Curve_sample& s : piece) frame.add(s.point);
    }
    for (std::size_t j = 0; j < methods.size(); ++j)
      draw(picture, curves[j], inputs[i], frame, left + width * static_cast<double>(j), y, width, height);
    std::printf(" |\n");
    std::fflush(stdout);
  }
  picture << "</g>\n" << texts << "</svg>\n";
  return picture || argc < 2 ? 0 : 1;
}
