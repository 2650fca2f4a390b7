// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_INSTANTIATED_ONCE_H
#define GEOMETRIC_CONTINUITY_TOOLS_INSTANTIATED_ONCE_H

#include "formats/g2_text/curves.h"

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/surfaces/internal/surface_denominator.h>

#include <string>
#include <string_view>
#include <vector>

// Functions that several units of the program use are compiled in the unit of
// instantiated_once.cpp. The other units include this file first. Some functions are internal: they
// are large.
#ifndef GEOMETRIC_CONTINUITY_INSTANTIATE
#define GEOMETRIC_CONTINUITY_INSTANTIATE extern template
#endif

namespace CGAL {
namespace Geometric_continuity {

GEOMETRIC_CONTINUITY_INSTANTIATE class G2_piece_reader<Program_traits<Exact>>;
GEOMETRIC_CONTINUITY_INSTANTIATE class G2_piece_reader<Program_traits<double>>;
GEOMETRIC_CONTINUITY_INSTANTIATE Exact internal::number_value<Exact>(std::string_view);
GEOMETRIC_CONTINUITY_INSTANTIATE double internal::number_value<double>(std::string_view);
GEOMETRIC_CONTINUITY_INSTANTIATE std::string internal::exact_text(const Exact&);

GEOMETRIC_CONTINUITY_INSTANTIATE Sign_pattern
internal::exact_sign_pattern<Exact>(const internal::Whole_polynomial<Exact>&);
GEOMETRIC_CONTINUITY_INSTANTIATE Sign_pattern sign_pattern(const Bernstein_polynomial<Exact>&);
GEOMETRIC_CONTINUITY_INSTANTIATE Sign_pattern sign_pattern(const Bernstein_polynomial<Exact>&, const Exact&,
                                                           const Exact&);
GEOMETRIC_CONTINUITY_INSTANTIATE std::vector<Isolated_root<Exact>> isolate_roots(const Bernstein_polynomial<Exact>&,
                                                                                 const Exact&, int);
GEOMETRIC_CONTINUITY_INSTANTIATE std::vector<Isolated_root<Exact>> isolate_roots(const Bernstein_polynomial<Exact>&);
GEOMETRIC_CONTINUITY_INSTANTIATE Enclosure sqrt_enclosure(const Exact&);
GEOMETRIC_CONTINUITY_INSTANTIATE Enclosure internal::angle_of_squares(const Exact&, const Exact&, bool);

GEOMETRIC_CONTINUITY_INSTANTIATE void internal::check_knots(int, const std::vector<Exact>&);
GEOMETRIC_CONTINUITY_INSTANTIATE void internal::check_knots(int, const std::vector<double>&);
GEOMETRIC_CONTINUITY_INSTANTIATE std::vector<Exact> internal::bernstein_pieces(const Knot_vector<Exact>&,
                                                                               const std::vector<Exact>&);
GEOMETRIC_CONTINUITY_INSTANTIATE std::vector<Coordinate_vector<Exact, 0>>
internal::bernstein_pieces(const Knot_vector<Exact>&, const std::vector<Coordinate_vector<Exact, 0>>&);
GEOMETRIC_CONTINUITY_INSTANTIATE Coordinate_jet<Exact, 0> project(const Coordinate_jet<Exact, 0>&);
GEOMETRIC_CONTINUITY_INSTANTIATE void internal::require_positive(const internal::Bernstein_rows<Exact>&, int&,
                                                                 const char*);

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_INSTANTIATED_ONCE_H
