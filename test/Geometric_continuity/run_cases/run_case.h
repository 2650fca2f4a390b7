// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "ops_bezier.h"
#include "ops_blend.h"
#include "ops_bspline.h"
#include "ops_edges.h"
#include "ops_errata.h"
#include "ops_hagen.h"
#include "ops_local.h"
#include "ops_matrices.h"
#include "ops_normals.h"
#include "ops_rational.h"
#include "ops_rational_edges.h"
#include "ops_ribbon.h"
#include "ops_surface_blend.h"

#include <stdexcept>
#include <string>

// The dimension of a case: the length of the first point of its input, 0 when it has no points.
inline int dimension_of(const Case& c) {
  for (const char* point : {"b0", "center"})
    if (c.has(std::string(point) + '#')) return c.length(point);
  for (const auto& [path, value] : c.in)
    if (path.size() > 3 && path.compare(path.size() - 3, 3, ".0#") == 0) {
      // nets are nested one level deeper
      const auto in_net = c.in.find(path.substr(0, path.size() - 1) + ".0#");
      return std::stoi(in_net == c.in.end() ? value : in_net->second);
    }
  return 0;
}

template <class FT> bool run_scalars(const Case& c, Report& report) {
  return run_bernstein<FT>(c, report) || run_connection_scalars<FT>(c, report) || run_basis_matrix<FT>(c, report);
}

template <class Traits> bool run_operation(const Case& c, Report& report) {
  return run_surface_blend<Traits>(c, report) || run_rational<Traits>(c, report) || run_bspline<Traits>(c, report) ||
         run_bezier<Traits>(c, report) || run_invariants<Traits>(c, report) || run_joins<Traits>(c, report) ||
         run_errata<Traits>(c, report) || run_hagen<Traits>(c, report) || run_rational_edges<Traits>(c, report) ||
         run_edges<Traits>(c, report) || run_ribbon<Traits>(c, report) || run_normals<Traits>(c, report) ||
         run_matrices<Traits>(c, report) || (c.has("strategy") && run_blends<Traits>(c, report));
}

// Computes the output of a case in one kernel family. It never looks at the expected output.
template <class Kernels> Report run_case(const Case& c) {
  Report report;
  try {
    const int d = dimension_of(c);
    const bool known = d == 0   ? run_scalars<typename Kernels::FT>(c, report)
                       : d == 2 ? run_operation<typename Kernels::Traits2>(c, report)
                       : d == 3 ? run_operation<typename Kernels::Traits3>(c, report)
                                : run_operation<typename Kernels::Traitsd>(c, report);
    if (!known) throw std::runtime_error("unknown operation '" + c.op + "'");
  } catch (const GC::Error& e) {
    report = Report();
    report.predicate("error", [&] { return to_string(e.code()); });
  } catch (const CGAL::Uncertain_conversion_exception&) {
    // interval arithmetic cannot take a decision that the operation needs: the leaves so far stand
  }
  return report;
}
