// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

// The full suites.

#include "algebra/typed_Bernstein_polynomial.h"
#include "algebra/typed_Plane_coordinates.h"
#include "blends/typed_quintic_blend.h"
#include "blends/typed_septic_blend.h"
#include "curves/typed_Bezier_curve.h"
#include "curves/typed_Cubic_blended_curve.h"
#include "curves/typed_is_planar.h"
#include "extensions/typed_alternatives.h"
#include "joins/typed_join_continuity.h"
#include "local/typed_Curve_jet.h"
