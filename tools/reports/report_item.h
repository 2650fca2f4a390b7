// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_REPORTS_REPORT_ITEM_H
#define GEOMETRIC_CONTINUITY_TOOLS_REPORTS_REPORT_ITEM_H

#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// A page of `report` shows this of one join or edge. It is filled where things are decided; the
// page decides nothing.

namespace GC = CGAL::Geometric_continuity;

// The worst first. Bends and rounding are grades of fonts. CAD models have fading corners, which
// are corners in places only: they may not be meant, and come before those that are.
enum class Report_grade { gap, kink, bend, rounding, fading, corner, g0, undecided, g1, g2 };
constexpr std::size_t number_of_report_grades = 10;

// A curve as links of the page have it, its numbers as they are: e.g. points "0,0;1/3,2", weights
// "1;1/2", domain "0;1/4". The texts of weights that are equal and of the domain from 0 to 1 are
// empty; that of the points is, where there is no link.
struct Report_curve_link {
  std::string points, weights, domain;
};

// A curve as it is drawn: rounded numbers.
struct Report_curve {
  std::vector<double> points;  // the coordinates of the control points, one point after the other
  std::vector<double> weights; // empty when all are equal
  std::size_t group;           // the number of the contour or chain to which it belongs
  Report_curve_link link = {};
};

// The curves of a contour or chain, which are drawn around its joins.
typedef std::vector<std::shared_ptr<const Report_curve>> Report_outline;
constexpr std::size_t most_curves_of_outline = 2000;

// A place on a road: the road's number, the length along it, and where that is.
struct Report_road_place {
  std::size_t road;
  double s, x, y;
};

struct Report_item {
  std::size_t number = 0;         // in the order of the files, from 1 on
  std::string place, verdict;     // in words
  std::vector<std::string> marks; // what is to be known of it at first sight, e.g. "projected"
  Report_grade grade = Report_grade::undecided;
  std::optional<GC::Enclosure> angle;              // degrees
  std::optional<GC::Enclosure> curvature_jump;     // percent of the larger curvature
  std::optional<GC::Enclosure> gap;                // in the units of the file
  std::optional<GC::Enclosure> offset;             // how far a handle is off, in these units
  double severity = 0;                             // what the eye sees
  std::optional<double> units_off;                 // of fonts: by how many units of them it is off
  std::vector<std::string> point;                  // coordinates of the join
  std::string parameter;                           // of this point of an edge, if it has one
  std::shared_ptr<const Report_curve> left, right; // that meet there; none for an edge of a model
  std::shared_ptr<const Report_outline> outline;   // if it is not too long
  std::size_t edge = 0;                            // the number of an edge of the model
  std::optional<Report_road_place> road_place;     // of a road network

  // The worse of two of one grade has the larger one.
  double rank() const { return units_off ? *units_off : severity; }
};

// Returns whether `a` is shown before `b`, when the worst come first.
inline bool is_worse(const Report_item& a, const Report_item& b) {
  if (a.grade != b.grade) return a.grade < b.grade;
  if (a.rank() != b.rank()) return a.rank() > b.rank();
  return a.number < b.number;
}

// Roads as they are drawn: rounded numbers at places along each road.
struct Report_roads {
  struct Lane {
    bool is_driving;
    std::size_t first;               // of the places
    std::vector<double> left, right; // how far its borders are from the reference line
  };
  struct Road {
    std::string id;
    std::vector<double> s, x, y, heading, curvature, elevation;
    std::vector<Lane> lanes;
  };
  double x, y; // of the origin of the coordinates
  std::vector<Road> roads;
};

// A model as it is drawn.
struct Report_model {
  struct Patch {
    int m, n; // cells in both directions
    // (m + 1) (n + 1) in space, the first index runs fastest
    std::vector<double> points;
    // if any, the points are theirs: three numbers each, and no cells
    std::vector<std::size_t> triangles = {};
    std::string colour = {}; // that it has in the file, "#rrggbb"
  };
  struct Edge {
    std::string grade;
    std::vector<std::size_t> patches; // which have it
    std::vector<double> points;       // in space
  };
  std::vector<Patch> patches;
  std::vector<Edge> edges;
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_REPORTS_REPORT_ITEM_H
