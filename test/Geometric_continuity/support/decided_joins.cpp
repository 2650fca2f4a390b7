// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "support/decided_joins.h"

#include <CGAL/Cartesian_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/representable_blend.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>
#include <CGAL/Simple_cartesian.h>

// Who asks about joins of other curves adds a line; the linker names what is missing.

namespace CGAL {
namespace Geometric_continuity {

typedef Simple_cartesian<Exact_rational> Rational_kernel;
typedef Traits_2<Rational_kernel> Exact_2;
typedef Traits_3<Rational_kernel> Exact_3;
typedef Traits_d<Cartesian_d<Exact_rational>> Exact_d;
typedef Traits_2<Simple_cartesian<float>> Float_2;
typedef Traits_2<Simple_cartesian<double>> Double_2;

template <class Traits> using Quintic = Bezier_curve<Traits, 5>;
template <class Traits> using Quintic_blend = Blend_curve<Traits, 5, Quintic_parameters<typename Traits::FT>>;
template <class Curve> using Continuity_of = Join_continuity<Predicate_FT<typename Curve::Traits>>;

#define INSTANTIATE_CONTINUITY(Curve)                                                                                  \
  template Continuity_of<Curve> continuity(const Curve&, const Curve&, int);                                           \
  template Continuity_of<Curve> continuity(const Curve&, const Curve&);
INSTANTIATE_CONTINUITY(Bezier_curve<Traits_2<Epick>>)
INSTANTIATE_CONTINUITY(Bezier_curve<Traits_3<Epick>>)
INSTANTIATE_CONTINUITY(Bezier_curve<Exact_2>)
INSTANTIATE_CONTINUITY(Bezier_curve<Exact_3>)
INSTANTIATE_CONTINUITY(Bezier_curve<Exact_d>)
INSTANTIATE_CONTINUITY(Quintic<Traits_2<Epick>>)
INSTANTIATE_CONTINUITY(Quintic<Exact_3>)
INSTANTIATE_CONTINUITY(Quintic<Exact_d>)
INSTANTIATE_CONTINUITY(Quintic<Float_2>)

template Join_continuity<Exact_rational> continuity(const Curve_jet<Exact_2>&, const Curve_jet<Exact_2>&);

} // namespace Geometric_continuity
} // namespace CGAL

template <class Left, class Right> bool decide_g1_join(const Left& left, const Right& right) {
  return CGAL::Geometric_continuity::is_g1_join(left, right);
}
template <class Left, class Right> bool decide_g2_join(const Left& left, const Right& right) {
  return CGAL::Geometric_continuity::is_g2_join(left, right);
}

using namespace CGAL::Geometric_continuity;
using CGAL::Epick;
template bool decide_g1_join(const Bezier_curve<Double_2>&, const Bezier_curve<Double_2>&);
template bool decide_g2_join(const Bezier_curve<Double_2>&, const Bezier_curve<Double_2>&);
template bool decide_g2_join(const Bezier_curve<Traits_2<Epick>>&, const Representable_blend<Traits_2<Epick>>&);
template bool decide_g2_join(const Representable_blend<Traits_2<Epick>>&, const Bezier_curve<Traits_2<Epick>>&);
template bool decide_g2_join(const Bezier_curve<Traits_3<Epick>>&, const Representable_blend<Traits_3<Epick>>&);
template bool decide_g2_join(const Representable_blend<Traits_3<Epick>>&, const Bezier_curve<Traits_3<Epick>>&);
template bool decide_g2_join(const Bezier_curve<Exact_2>&, const Quintic_blend<Exact_2>&);
template bool decide_g2_join(const Quintic_blend<Exact_2>&, const Bezier_curve<Exact_2>&);
