// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Figures of curves and pictures of surfaces: what the legend says, and what is refused.

#include "support/net_of.h"

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>
#include <CGAL/ipower.h>
#include <Geometric_continuity_figures/Svg_figure.h>
#include <Geometric_continuity_figures/svg_surfaces.h>

BOOST_AUTO_TEST_SUITE(Svg_figure)

typedef CGAL::Simple_cartesian<double> Kernel;
typedef GC::Traits_2<Kernel> Plane;
typedef GC::Traits_3<Kernel> Space;
typedef GC::Bezier_curve<Plane> Curve;
typedef GC::Bezier_patch<Space> Patch;
typedef Plane::Point P;
typedef Space::Point Q;
using GC::Svg_role;
using GC::Svg_style;

namespace {

const Curve arch{P(0, 0), P(1, 2), P(3, 2), P(4, 0)}, line{P(4, 0), P(6, -4)}, point{P(1, 1)};

std::string svg(const GC::Svg_figure& figure) { return text(figure); }
std::string svg(const GC::Svg_panel& panel) { return svg(GC::Svg_figure().add(panel)); }
template <class Drawn> std::string drawn(const Drawn& curve, const Svg_style& style) {
  return svg(GC::Svg_panel().add(curve, style));
}
template <class Surface>
std::string drawn(const std::vector<Surface>& surfaces, const GC::Svg_surface_style& style = {}) {
  return written_by([&](std::ostream& os) { GC::write_svg_surfaces(os, surfaces, style); });
}

bool is_finite(const std::string& picture) { return !contains(picture, "nan") && !contains(picture, "inf"); }

int count(const std::string& text, const std::string& word) {
  int n = 0;
  for (std::size_t i = text.find(word); i != std::string::npos; i = text.find(word, i + 1)) ++n;
  return n;
}

// All that stands in text elements, one to a line.
std::string texts(const std::string& document) {
  std::string result;
  for (std::size_t i = document.find("<text "); i != std::string::npos; i = document.find("<text ", i + 1)) {
    const std::size_t begin = document.find('>', i) + 1;
    result += document.substr(begin, document.find("</text>", i) - begin) + '\n';
  }
  return result;
}
std::string texts(const GC::Svg_figure& figure) { return texts(svg(figure)); }

} // namespace

BOOST_AUTO_TEST_CASE(the_legend_names_what_is_drawn) {
  GC::Svg_panel panel("caption");
  panel.add(arch).join("G0").add(line, Svg_style{Svg_role::result, false, false, "line of alternatives"});
  BOOST_CHECK_EQUAL(texts(svg(panel)), "G0\ncaption\ngiven curve\nline of alternatives\njoin\n");
  // without a name: that of the role; in the order of the roles
  panel = GC::Svg_panel();
  panel.add(line, Svg_style{Svg_role::construction}).add(line, Svg_style{Svg_role::result}).add(arch);
  BOOST_CHECK_EQUAL(texts(svg(panel)), "given curve\nresult\nconstruction\n");
  // curves of one role with other names, each once, also in other panels
  const Svg_style combed{Svg_role::result, false, true};
  BOOST_CHECK_EQUAL(svg(GC::Svg_figure().add(arch).add(arch, combed)),
                    svg(GC::Svg_figure().add(GC::Svg_panel().add(arch).add(arch, combed))));

  GC::Svg_figure figure("title");
  for (const char* name : {"first", "second", "first"})
    figure.add(GC::Svg_panel().add(arch, Svg_style{Svg_role::given, false, false, name}));
  BOOST_CHECK_EQUAL(texts(figure), "title\nfirst\nsecond\n");
  // one name in two roles has two lines
  panel = GC::Svg_panel();
  panel.add(arch, Svg_style{Svg_role::given, false, false, "a < b"});
  panel.add(line, Svg_style{Svg_role::result, false, false, "a < b"});
  BOOST_CHECK_EQUAL(texts(svg(panel)), "a &lt; b\na &lt; b\n");
  BOOST_CHECK(svg(panel).find("a < b") == std::string::npos);
  // a point is no line, and no join
  panel = GC::Svg_panel();
  panel.add(line, Svg_style{Svg_role::result}).add(point).join("b");
  BOOST_CHECK_EQUAL(texts(svg(panel)), "b\nresult\n");
  // details
  panel = GC::Svg_panel();
  panel.add(arch, Svg_style{Svg_role::given, true, true});
  BOOST_CHECK_EQUAL(texts(svg(panel)),
                    "given curve\ncontrol polygon\ncurvature comb\ntooth of curvature 0.1 (1/unit)\n");
  BOOST_CHECK_EQUAL(texts(GC::Svg_figure()), "");
}

BOOST_AUTO_TEST_CASE(texts_are_valid_in_xml) {
  const std::string r = "\xef\xbf\xbd"; // U+FFFD
  GC::Svg_figure figure("a\xff\x1b \xef\xbf\xbe&\xef\xbf\xbf\xc3\xa9");
  figure.add(
      GC::Svg_panel("\xe2\x82").add(arch, Svg_style{Svg_role::given, false, false, "\xed\xa0\x80"}).join("\x01<"));
  const std::string title = 'a' + r + ' ' + r + "&amp;" + r + "\xc3\xa9";
  BOOST_CHECK_EQUAL(texts(figure), title + "\n &lt;\n" + r + '\n' + r + r + r + "\njoin\n");
  BOOST_CHECK(svg(figure).find("<title>a" + r + "  " + r + "&amp;") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_legend_shows_the_line_of_each_role) {
  const auto sample = [](Svg_role role) {
    const std::string s = drawn(line, Svg_style{role, false, false, "name"});
    const std::size_t end = s.find(">name<"), begin = s.rfind("<g transform", end);
    return s.substr(begin, end - begin);
  };
  BOOST_CHECK(sample(Svg_role::given).find("stroke=\"#2f4058\"") != std::string::npos);
  BOOST_CHECK(sample(Svg_role::result).find("stroke=\"#d55e00\"") != std::string::npos);
  BOOST_CHECK(sample(Svg_role::construction).find("stroke-dasharray") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_range_of_curves_is_drawn_as_its_curves) {
  const std::vector<Curve> both{arch, line};
  BOOST_CHECK_EQUAL(svg(GC::Svg_figure().add(both)), svg(GC::Svg_figure().add(arch).add(line)));
  BOOST_CHECK_EQUAL(svg(GC::Svg_figure().add(GC::Bspline_curve<Curve::Traits>(arch).bezier_pieces())),
                    svg(GC::Svg_figure().add(arch)));
}

BOOST_AUTO_TEST_CASE(figures_that_are_refused) {
  CHECK_ERROR(GC::Svg_figure("", 0), wrong_number_of_points);
  CHECK_ERROR(GC::Svg_figure("", -1), negative_count);
  CHECK_ERROR(GC::Svg_figure("", (std::numeric_limits<int>::min)()), negative_count);
  BOOST_CHECK_EQUAL(GC::Svg_figure("", (std::numeric_limits<int>::max)()).add(GC::Svg_panel()).number_of_panels(), 1);
  BOOST_CHECK_EQUAL(texts(GC::Svg_figure("", (std::numeric_limits<int>::max)()).add(GC::Svg_panel().add(arch))),
                    "given curve\n");
  GC::Svg_panel panel;
  CHECK_ERROR(panel.join("G1"), wrong_number_of_points);
  BOOST_CHECK_EQUAL(texts(svg(panel)), "");
  const GC::Bspline_curve<Plane> two_spans({P(0, 0), P(1, 1), P(2, 0)}, GC::Knot_vector<double>(1, 0., 2., {{1., 1}}));
  CHECK_ERROR(panel.add(two_spans), wrong_number_of_points);
  typedef CGAL::Cartesian_d<double> Kernel_d;
  typedef Kernel_d::Point_d D;
  const double x[] = {0, 1, 2, 3};
  for (int d : {1, 4})
    CHECK_ERROR(panel.add(GC::Bezier_curve<GC::Traits_d<Kernel_d>>{D(d, x, x + d), D(d, x, x + d)}),
                dimension_mismatch);
}

// Labels are placed one after the other, until one finds no room.
BOOST_AUTO_TEST_CASE(the_first_label_without_room) {
  GC::Svg_panel panel;
  panel.add(arch);
  std::string legend;
  for (int n = 0; n < 100 && legend.find("no room") == std::string::npos; ++n)
    legend = texts(GC::Svg_figure().add(panel.join("a label of a join")));
  BOOST_CHECK(legend.find("\n1 label has no room\n") != std::string::npos);
}

// A line upwards, a curve that stays at its start for many steps, and control points that are far
// to the left and the right.
BOOST_AUTO_TEST_CASE(frames_and_combs_of_special_curves) {
  const auto height = [](const Curve& curve) {
    const std::string s = drawn(curve, Svg_style{Svg_role::given, true, true});
    BOOST_CHECK(is_finite(s));
    return std::stod(s.substr(s.find(" height=\"") + 9));
  };
  const Curve up{P(0, 0), P(0, 3)}, across{P(0, 0), P(3, 0)};
  BOOST_CHECK_GT(height(up), 2 * height(across));
  std::vector<P> points(30, P(1, 1));
  points.push_back(P(2, 3));
  points.push_back(P(4, 3));
  height(Curve(points.begin(), points.end()));
  std::vector<P> level;
  for (int j = 0; j <= 10; ++j) level.emplace_back(j, j % 2);
  const double without = height(Curve(level.begin(), level.end()));
  level[5] = P(40, 0); // which the frame does not show
  BOOST_CHECK_GT(height(Curve(level.begin(), level.end())), 0.25 * without);
}

// An infinite control point is left out of the polygon.
BOOST_AUTO_TEST_CASE(a_half_circle) {
  const auto points = [](double weight) {
    const GC::Rational_bezier_curve<Plane> conic({P(1, 0), P(0, 1), P(-1, 0)}, {1., weight, 1.});
    return count(drawn(conic, Svg_style{Svg_role::given, true}), "<circle");
  };
  BOOST_CHECK_EQUAL(points(0), points(1) - 1);
}

// A line from the bottom to the top of a plot where a curve ends, in space as in the plane.
BOOST_AUTO_TEST_CASE(joins_in_plots) {
  const Svg_style style{Svg_role::given, false, false, "", true};
  const auto lines = [&](const auto& first, const auto& second) {
    const std::string s = svg(GC::Svg_panel().add(first, style).add(second, style));
    const std::size_t plumb = s.find("#b4b4b4", s.find(">\xce\xba</text>")), begin = s.find(" d=\"", plumb);
    return s.substr(begin, s.find('\n', begin) - begin);
  };
  const GC::Bezier_curve<Space> first{Q(0, 0, 0), Q(1, 3, 2), Q(4, 1, -3)}, second{Q(4, 1, -3), Q(5, 5, 1)};
  for (const std::string& path : {lines(arch, line), lines(first, second)}) {
    BOOST_CHECK_EQUAL(std::count(path.begin(), path.end(), 'M'), 1);
    BOOST_CHECK_MESSAGE(path.find(" 88L") != std::string::npos && path.find(" 8\"/>") != std::string::npos, path);
  }
}

// The coordinates are finite in double, or refused; then what is drawn is finite.
BOOST_AUTO_TEST_CASE(coordinates_of_all_sizes) {
  typedef CGAL::Exact_rational Number;
  typedef GC::Bezier_curve<GC::Traits_2<CGAL::Simple_cartesian<Number>>> Exact_curve;
  const auto power = [](int n) { return Number(CGAL::ipower(Number(10), n)); };
  const auto curve = [](const Number& size) {
    typedef Exact_curve::Point Point;
    return Exact_curve{Point(0, 0), Point(size, Number(-size)), Point(Number(2 * size), size),
                       Point(Number(3 * size), 0)};
  };
  for (const Number& size : {power(307), power(0), Number(1 / power(307)), Number(1 / power(4000))}) {
    GC::Svg_panel panel;
    panel.add(curve(size), Svg_style{Svg_role::given, true, true}).join("G0").add(curve(1));
    BOOST_CHECK(is_finite(svg(panel)));
    BOOST_CHECK(texts(svg(panel)).find("G0") == 0);
  }
  GC::Svg_panel panel;
  panel.add(curve(1));
  CHECK_ERROR(panel.add(curve(power(400))), not_finite);
  BOOST_CHECK(contains(error_of([&] { panel.add(curve(power(400))); }), "curve 1: control point 1 is too far away"));
  BOOST_CHECK_EQUAL(texts(svg(panel)), "given curve\n"); // as it was before
}

// Each of many curves is drawn, with its comb, its polygon and its join; labels only where there is
// room.
BOOST_AUTO_TEST_CASE(many_curves) {
  const int n = 2000;
  GC::Svg_panel panel;
  for (int i = 0; i < n; ++i) // a chain of arches, and one that is as long as all
    panel
        .add(i == 7 ? Curve{P(0, 0), P(0, n), P(4 * n, n), P(4 * n, 0)}
                    : arch.transform(CGAL::Aff_transformation_2<Kernel>(CGAL::TRANSLATION, Kernel::Vector_2(4 * i, 0))),
             Svg_style{Svg_role::given, true, true})
        .join("G1");
  const std::string drawn = svg(panel);
  const int labels = count(drawn, ">G1</text>");
  BOOST_CHECK(8 <= labels && labels < n);
  BOOST_CHECK_EQUAL(count(drawn, '>' + std::to_string(n - labels) + " labels have no room</text>"), 1);
  BOOST_CHECK_EQUAL(count(drawn, "<circle"), 5 * n + 4); // points, joins and the legend
  BOOST_CHECK(drawn.find("nan") == std::string::npos);
}

// A quarter of a circle of radius 2 and its tangent: the axes have the units of what is given, and
// so has the comb.
BOOST_AUTO_TEST_CASE(numbers_of_curvature_and_arc_length) {
  const auto numbers = [](double size) {
    const double k = 0.5522847498 * 2 * size, r = 2 * size;
    const Curve arc{P(r, 0), P(r, k), P(k, r), P(0, r)}, straight{P(0, r), P(-r, r)};
    const Svg_style style{Svg_role::given, false, true, "", true};
    return texts(svg(GC::Svg_panel().add(arc, style).add(straight, style)));
  };
  const std::string end = "\xce\xba\ns\ngiven curve\ncurvature comb\n", minus = "\xe2\x88\x92";
  const std::string below = "below: curvature \xce\xba (1/unit) against arc length s (units)\n";
  BOOST_CHECK_EQUAL(numbers(1),
                    minus + "0.5\n0\n0.5\n0\n1\n2\n3\n4\n5\n" + end + "tooth of curvature 0.1 (1/unit)\n" + below);
  BOOST_CHECK_EQUAL(numbers(1e-9).substr(0, 8), minus + "5e8\n0");
  BOOST_CHECK_EQUAL(numbers(1e3).substr(0, 11), minus + "0.0005\n0");
}

// A point has no curvature; its plot has axes.
BOOST_AUTO_TEST_CASE(the_plot_of_a_point) {
  const std::string s = drawn(point, Svg_style{Svg_role::given, false, false, "", true});
  for (const char* word : {"nan", "inf", "e-2147483648"}) BOOST_CHECK(s.find(word) == std::string::npos);
  BOOST_CHECK_EQUAL(texts(s).find("\xe2\x88\x92" + std::string("0.5\n0\n0.5\n")), 0u);
}

// Captions are broken between words, and words that are longer than a line within, but not within a
// letter.
BOOST_AUTO_TEST_CASE(long_captions) {
  const auto without_breaks = [](std::string text) {
    text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == ' ' || c == '\n'; }), text.end());
    return text;
  };
  const std::string letter = "\xc3\xa4";
  std::string word, caption;
  for (int i = 0; i < 200; ++i) word += letter;
  for (int i = 0; i < 30; ++i) caption += "words of several lengths and ";
  for (const std::string& text : {caption, word, caption + word, word + ' ' + caption}) {
    const std::string drawn = texts(GC::Svg_figure().add(GC::Svg_panel(text).add(arch)));
    BOOST_CHECK_EQUAL(without_breaks(drawn), without_breaks(text) + "givencurve");
    std::istringstream lines(drawn);
    int n = 0;
    for (std::string line; std::getline(lines, line); ++n)
      BOOST_CHECK(line.size() < 200 && line.substr(0, 1) != "\xa4");
    BOOST_CHECK_GE(n, 4);
  }
}

// A curve that almost has a cusp, one that starts slowly, and the pieces of a rational one.
BOOST_AUTO_TEST_CASE(combs_and_plots_that_are_cut_off) {
  const Svg_style style{Svg_role::given, true, true, "a > \"b\"", true};
  const Curve sharp{P(0, 0), P(4, 4), P(0, 4.02), P(4, 0)}, slow{P(0, 0), P(0, 0), P(1, 1), P(3, 0)};
  const std::string legend = texts(GC::Svg_figure().add(GC::Svg_panel().add(sharp, style)));
  for (const char* text :
       {"a &gt; &quot;b&quot;\n", "\ncurvature comb (long teeth cut off)\n", " (1/unit, cut off) against "})
    BOOST_CHECK_MESSAGE(legend.find(text) != std::string::npos, legend + " has not " + text);
  // a short curve with the longest teeth: it is its part of the whole length that counts, not how
  // its parameter runs
  const Curve flat{P(0, 0), P(50, 2.5), P(100, 0)}, bent{P(0, 10), P(2.5, 12), P(5, 10)};
  const Svg_style combed{Svg_role::given, false, true};
  const auto cut_off = [&](const Curve& curve) {
    return contains(texts(svg(GC::Svg_panel().add(flat, combed).add(curve, combed))),
                    "\ncurvature comb (long teeth cut off)\n");
  };
  BOOST_CHECK(cut_off(bent) && !cut_off(flat));
  const GC::Bezier_curve<Space> spatial{Q(0, 0, 0), Q(1, 3, 2), Q(4, 1, -3), Q(5, 5, 1)};
  const std::string s =
      svg(GC::Svg_figure().add(GC::Svg_panel().add(spatial, style)).add(GC::Svg_panel().add(slow, style)));
  BOOST_CHECK(is_finite(s));
  // a rational curve is plotted as one; where its weights are equal it is that without weights
  const std::vector<P> points{P(0, 0), P(1, 2), P(3, 2)};
  typedef GC::Rational_bezier_curve<Plane> Conic;
  const std::string plain = drawn(Curve(points.begin(), points.end()), style);
  BOOST_CHECK_EQUAL(drawn(Conic(points, std::vector<double>{4, 4, 4}), style), plain);
  BOOST_CHECK(drawn(Conic(points, std::vector<double>{1, 2, 5}), style) != plain);
}

// In the plane a left turn is plotted above the middle and a right turn below it, as far as it is
// curved; the most curved point is at the top, however little that is. In space the plot goes from
// the bottom to the top.
BOOST_AUTO_TEST_CASE(heights_of_curvature) {
  const auto heights = [](const auto& curve) { // of the plot of a curve, the least and the greatest
    const std::string s = drawn(curve, Svg_style{Svg_role::result, false, false, "", true});
    // in a panel in a figure
    const std::size_t plot = s.find("<svg", s.find("<svg", s.find("<svg") + 1) + 1), line = s.find("#d55e00", plot),
                      begin = s.find(" d=\"", line) + 4, end = s.find('"', begin);
    std::pair<double, double> found(1000, -1000);
    std::istringstream path(s.substr(begin, end - begin));
    double x, y;
    for (char c; path >> c;) {
      if (std::isalpha(static_cast<unsigned char>(c)) == 0) path.unget();
      if (!(path >> x)) continue;
      if (path.peek() == ',') path.get();
      path >> y;
      found = {(std::min)(found.first, y), (std::max)(found.second, y)};
    }
    return found;
  };
  const Curve left{P(0, 0), P(2, -0.01), P(4, 0)}, right{P(0, 0), P(2, 0.01), P(4, 0)};
  const std::pair<double, double> above = heights(left), below = heights(right), middle = heights(line);
  BOOST_CHECK_EQUAL(middle.first, middle.second);
  BOOST_CHECK_CLOSE_FRACTION(above.first + below.second, 2 * middle.first, 1e-3);
  BOOST_CHECK_LT(above.first, 10); // near the top of about 100 pixels
  BOOST_CHECK_GT(below.second, 80);
  const GC::Bezier_curve<Space> straight{Q(0, 0, 0), Q(1, 1, 1)}, bent{Q(0, 0, 0), Q(2, 0.01, 0), Q(4, 0, 0)};
  BOOST_CHECK_LT(heights(bent).first, 15);
  BOOST_CHECK_GT(heights(straight).first, below.second); // at the bottom
}

// The frame follows the curves that may not leave it, whatever the others do.
BOOST_AUTO_TEST_CASE(curves_that_leave_the_frame) {
  const Svg_style leaves{Svg_role::result, false, true, "", true, false};
  const auto picture = [&](const Curve& far) {
    const std::string s = svg(GC::Svg_panel().add(arch).join("G1").add(far, leaves).join("G0"));
    const std::size_t begin = s.find("#2f4058"); // of the arch
    return s.substr(begin, s.find('\n', begin) - begin);
  };
  const Curve beside{P(4, 0), P(5, 1), P(6, 0)}, far{P(4, 0), P(5, 1e20), P(6e20, 0)};
  BOOST_CHECK_EQUAL(picture(beside), picture(far));
  // alone, it is the frame
  BOOST_CHECK(!contains(drawn(beside, leaves), "nan"));
}

BOOST_AUTO_TEST_CASE(texts_without_a_mark) {
  GC::Svg_panel panel;
  CHECK_ERROR(panel.label("d"), wrong_number_of_points);
  panel.add(point).label("d");
  const std::string s = svg(panel);
  BOOST_CHECK(texts(s) == "d\ngiven curve\n" || texts(s) == "d\n");
  BOOST_CHECK(s.find("<circle") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(pictures_of_surfaces) {
  const Patch bent{{Q(0, 0, 0), Q(0, 2, 0)}, {Q(1, 0, 2), Q(1, 2, 2)}, {Q(2, 0, 0), Q(2, 2, 0)}},
      next{{Q(2, 0, 0), Q(2, 2, 0)}, {Q(3, 0, 2), Q(3, 2, 2)}};
  GC::Svg_surface_style style;
  style.title = "roof & wall";
  style.shading = GC::Svg_shading::smooth;
  BOOST_CHECK_EQUAL(texts(drawn(std::vector<Patch>{bent, next}, style)),
                    "roof &amp; wall\nedge, only G0: a crease\nboundary\n");
  style.shading = GC::Svg_shading::isophotes;
  style.title.clear();
  BOOST_CHECK_EQUAL(texts(drawn(std::vector<Patch>{bent}, style)),
                    "isophotes: kinked where only G1, broken where only G0\nboundary\n");
  typedef GC::Svg_surface_style Style;
  std::ostringstream os;
  for (double x : {infinity, -infinity, std::nan("")})
    for (const auto member : {&Style::azimuth, &Style::elevation, &Style::width}) {
      Style wrong;
      wrong.*member = x;
      CHECK_ERROR(GC::write_svg_surfaces(os, std::vector<Patch>{bent}, wrong), not_finite);
    }
  Style thin;
  thin.width = 99;
  CHECK_ERROR(GC::write_svg_surfaces(os, std::vector<Patch>{bent}, thin), empty_domain);
  BOOST_CHECK(os.str().empty());
  // a flat patch that is curved along one parameter has as many facets when the parameters are
  // exchanged
  const Patch curved{{Q(0, 0, 0), Q(4, 1, 0), Q(0, 2, 0)}, {Q(1, 0, 0), Q(5, 1, 0), Q(1, 2, 0)}};
  const auto numbers = [](const Patch& patch) { // that occur
    return count(drawn(std::vector<Patch>{patch}), ".");
  };
  BOOST_CHECK_EQUAL(numbers(curved), numbers(curved.swap_parameters()));
  style.width = 100;
  BOOST_CHECK(contains(drawn(std::vector<Patch>{bent}, style), "width=\"148\"")); // with margins of 24
}

// Edges by their order, knot lines where the derivatives jump, and a pole.
BOOST_AUTO_TEST_CASE(lines_of_surfaces) {
  typedef GC::Bspline_surface<Space> Surface;
  const auto legend = [](const std::vector<Surface>& surfaces) { return texts(drawn(surfaces)); };
  const GC::Knot_vector<double> line(1, 0., 1.), plain(2, 0., 1.), kinked(2, 0., 2., {{1., 2}});
  const Surface smooth({{Q(0, 0, 0), Q(0, 2, 0)}, {Q(1, 0, 1), Q(1, 2, 1)}, {Q(2, 0, 1), Q(2, 2, 1)}}, plain, line),
      goes_on({{Q(2, 0, 1), Q(2, 2, 1)}, {Q(3, 0, 1), Q(3, 2, 1)}, {Q(4, 0, 4), Q(4, 2, 4)}}, plain, line),
      folded({{Q(0, 0, 0), Q(0, 2, 0)},
              {Q(1, 0, 1), Q(1, 2, 1)},
              {Q(2, 0, 0), Q(2, 2, 0)},
              {Q(3, 0, 1), Q(3, 2, 1)},
              {Q(4, 0, 0), Q(4, 2, 0)}},
             kinked, line),
      pole({{Q(0, 0, 0), Q(0, 0, 0)}, {Q(1, 0, 1), Q(1, 2, 1)}, {Q(2, 0, 0), Q(2, 2, 0)}}, plain, line);
  const std::string first = "isophotes: kinked where only G1, broken where only G0\n";
  BOOST_CHECK_EQUAL(legend({smooth, goes_on}), first + "edge, G1\nboundary\n");
  BOOST_CHECK_EQUAL(legend({folded}), first + "edge, only G0: a crease\nboundary\n");
  BOOST_CHECK_EQUAL(legend({pole}), first + "boundary\n");
  BOOST_CHECK_EQUAL(legend({folded.swap_parameters()}), first + "edge, only G0: a crease\nboundary\n");
  const Surface flat({{Q(0, 0, 0), Q(0, 2, 0)}, {Q(1, 0, 0), Q(1, 2, 0)}}, line, line),
      beside({{Q(1, 0, 0), Q(1, 2, 0)}, {Q(3, 0, 0), Q(3, 2, 0)}}, line, line),
      corner({{Q(1, 0, 0), Q(1, 2, 0)}, {Q(1, 0, 0), Q(3, 2, 0)}}, line, line);
  BOOST_CHECK_EQUAL(legend({flat, beside}), first + "edge, G2\nboundary\n");
  BOOST_CHECK_EQUAL(legend({flat, corner}), first + "edge, G1 but where a normal vanishes\nboundary\n");
}

// The test draws one surface with and without infinite control points. A surface that cannot be
// drawn is named by its number.
BOOST_AUTO_TEST_CASE(rational_and_exact_surfaces) {
  typedef GC::Rational_bezier_patch<Space> Rational;
  const Rational half({{Q(1, 0, 0), Q(1, 0, 2)}, {Q(0, 1, 0), Q(0, 1, 0)}, {Q(-1, 0, 0), Q(-1, 0, 2)}},
                      {{1., 1.}, {0., 0.}, {1., 1.}});
  BOOST_CHECK_EQUAL(drawn(std::vector<Rational>{half}), drawn(std::vector<Rational>{half.elevate(1, 0)}));
  BOOST_CHECK(is_finite(drawn(std::vector<Rational>{half})));
  const Patch point{{Q(1, 2, 3), Q(1, 2, 3)}, {Q(1, 2, 3), Q(1, 2, 3)}};
  BOOST_CHECK(is_finite(drawn(std::vector<Patch>{point})));

  typedef CGAL::Exact_rational Number;
  typedef GC::Traits_3<CGAL::Simple_cartesian<Number>> Exact;
  typedef GC::Bspline_surface<Exact> Surface;
  typedef Exact::Point R;
  const Number huge = CGAL::ipower(Number(10), 400), tiny = Number(1) / huge;
  const auto surface = [](const Number& x, const Number& knot) {
    const GC::Knot_vector<Number> line(1, Number(0), Number(1)), bent(1, Number(0), Number(2), {{knot, 1}});
    return Surface({{R(0, 0, 0), R(0, 1, 0)}, {R(1, 0, x), R(1, 1, x)}, {R(2, 0, 0), R(2, 1, 0)}}, bent, line);
  };
  const Surface good = surface(1, 1);
  const auto message = [&](const Surface& wrong) {
    return error_of([&] { drawn(std::vector<Surface>{good, wrong}); });
  };
  const std::string begin = "svg_surfaces: surface 1 cannot be drawn: ";
  BOOST_CHECK(message(good) == "no error");
  BOOST_CHECK(contains(message(surface(huge, 1)), begin + "a number is too large"));
  typedef CGAL::Cartesian_d<double> Kernel_d;
  typedef Kernel_d::Point_d D;
  const double x[] = {0, 1, 2, 3};
  const GC::Bezier_patch<GC::Traits_d<Kernel_d>> flat(
      std::vector<std::vector<D>>{{D(4, x, x + 4), D(4, x, x + 4)}, {D(4, x, x + 4), D(4, x, x + 4)}});
  BOOST_CHECK(contains(error_of([&] { drawn(std::vector<GC::Bezier_patch<GC::Traits_d<Kernel_d>>>{flat}); }),
                       "surface 0 cannot be drawn: it is not in dimension 3"));
  BOOST_CHECK(contains(message(surface(1, tiny)), begin + "knots become equal by rounding"));
}

// A closed silhouette is seen as a closed line, around a hump that is seen from above.
BOOST_AUTO_TEST_CASE(silhouettes_of_a_hump) {
  const std::vector<Patch> hump{Patch(net_of(7, 7, [](int i, int j) { return Q(i, j, i == 3 && j == 3 ? 30. : 0.); }))};
  const std::string silhouette = "stroke=\"#1b1b1b\" stroke-width=\"0.9\"";
  GC::Svg_surface_style style;
  style.elevation = 50;
  BOOST_CHECK(contains(drawn(hump, style), silhouette));
  style.elevation = 90; // from above there is none
  BOOST_CHECK(!contains(drawn(hump, style), silhouette));
}

// Pictures stay what they are, to the last digit. Who changes how they look, and has looked at
// them, puts in the new number.
BOOST_AUTO_TEST_CASE(domains_do_not_show) { // nor do those of rational curves
  const auto picture = [](double first, double last) {
    const std::vector<P> points{P(0, 0), P(1, 2), P(3, 2)};
    const GC::Rational_bezier_curve<Plane> conic(points, std::vector<double>{1, 2, 5}, first, last);
    return svg(GC::Svg_panel().add(conic));
  };
  BOOST_CHECK_EQUAL(picture(0, 1), picture(2, 3));
  BOOST_CHECK_EQUAL(picture(0, 1), picture(-2, 2));
}

BOOST_AUTO_TEST_CASE(pictures_stay_what_they_are) {
  const auto fingerprint = [](const std::string& picture) { // FNV-1a
    std::uint64_t hash = 0xcbf29ce484222325;
    for (char c : picture) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return hash;
  };
  GC::Svg_figure figure("A title that is long enough to be broken into two lines, because the figure is not as wide",
                        2);
  const Svg_style detailed{Svg_role::given, true, true, "", true};
  figure.add(GC::Svg_panel("first").add(arch, detailed).join("G0").add(line, Svg_style{Svg_role::result, false, true}));
  const GC::Rational_bezier_curve<Plane> conic({P(0, 0), P(1, 2), P(3, 2)}, {1., 2., 5.});
  figure.add(GC::Svg_panel().add(conic, Svg_style{Svg_role::construction, true}).label("end").add(arch).join());
  figure.add(GC::Svg_panel("third").add(
      GC::Bezier_curve<Space>{Q(0, 0, 0), Q(1, 3, 2), Q(4, 1, -3), Q(5, 5, 1), Q(0, 7, 1)}, detailed));
  BOOST_CHECK_EQUAL(fingerprint(svg(figure)), 0x7dc76f5538912ed8);
  // labels that find room away from their joins only, and teeth of curves of different speeds
  GC::Svg_panel crowded;
  for (int i = 0; i < 24; ++i) {
    const auto moved = CGAL::Aff_transformation_2<Kernel>(CGAL::TRANSLATION, Kernel::Vector_2(0.3 * (i % 6), 0.2 * i));
    crowded.add(arch.transform(moved), detailed).join("C" + std::to_string(i));
  }
  crowded.add(Curve{P(0, -9), P(9, -8), P(9, -7), P(9, 12)}, detailed);
  BOOST_CHECK_EQUAL(fingerprint(svg(GC::Svg_figure().add(crowded))), 0xd7fea0207057760a);

  const Patch bent{{Q(0, 0, 0), Q(0, 2, 1)}, {Q(1, 0, 2), Q(1, 2, 2)}, {Q(2, 0, 0), Q(2, 2, 0)}},
      next{{Q(2, 0, 0), Q(2, 2, 0)}, {Q(3, 0, -2), Q(3, 2, -2)}},
      last{{Q(3, 0, -2), Q(3, 2, -2)}, {Q(5, 1, 1), Q(4, 3, 0)}};
  GC::Svg_surface_style style;
  std::vector<std::uint64_t> prints;
  for (GC::Svg_shading shading : {GC::Svg_shading::smooth, GC::Svg_shading::isophotes}) {
    style.shading = shading;
    style.azimuth += 40;
    prints.push_back(fingerprint(drawn(std::vector<Patch>{bent, next, last}, style)));
  }
  BOOST_CHECK_EQUAL(prints[0], 0x3a3d210532b52c4e);
  BOOST_CHECK_EQUAL(prints[1], 0x4580b214210fb7d0);
}

BOOST_AUTO_TEST_SUITE_END()
