#include <CGAL/Geometric_continuity/curves/Rational_curve.h> // moved
