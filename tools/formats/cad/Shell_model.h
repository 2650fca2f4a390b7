// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_SHELL_MODEL_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_SHELL_MODEL_H

#include <array>
#include <string>
#include <vector>

// A closed shell over doubles: faces that are cut out of surfaces, and the edges and vertices that
// they share. It is what is written as a solid to a CAD model, see write_shell().
struct Shell_model {
  // The knots are all knots, each as often as its multiplicity: degree + 1 more than points. There
  // are no weights, or as many as points.
  struct Spline_curve {
    int degree;
    std::vector<double> knots;
    std::vector<std::array<double, 3>> points;
    std::vector<double> weights = {};
  };

  // A curve in the parameters (u, v) of a face.
  struct Spline_curve_2 {
    int degree;
    std::vector<double> knots;
    std::vector<std::array<double, 2>> points;
    std::vector<double> weights = {};
  };

  // A B-spline surface or, if it says so, the plane origin + u x + v y, with orthonormal x and y.
  struct Surface {
    int degree_u, degree_v;
    std::vector<double> knots_u, knots_v;
    std::vector<std::vector<std::array<double, 3>>> points; // points[u][v]
    bool plane = false;
    std::array<double, 3> origin, x, y;
    std::vector<std::vector<double>> weights = {}; // weights[u][v], or none
  };

  struct Edge {
    Spline_curve curve;
    int start, end; // the numbers of its vertices; they are equal if it is closed
  };

  // An edge as a loop of a face passes along it. The parameter curve has the parameters of the edge
  // and runs in its direction, also where the loop runs against it.
  struct Use {
    int edge;
    bool reversed;
    Spline_curve_2 curve;
  };

  // Loops run counterclockwise, holes clockwise, as seen from the tip of the cross product of the
  // derivatives of the surface by u and by v. The outer loop is the first one; a surface that is
  // closed in one direction has a seam, an edge that its loop passes twice.
  struct Face {
    Surface surface;
    std::vector<std::vector<Use>> loops;
    bool reversed = false; // that cross product points into the solid
    std::string name;
  };

  std::vector<std::array<double, 3>> vertices;
  std::vector<Edge> edges;
  std::vector<Face> faces; // one closed shell
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_SHELL_MODEL_H
