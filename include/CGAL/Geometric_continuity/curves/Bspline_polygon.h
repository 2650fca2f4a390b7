#include <CGAL/Geometric_continuity/curves/Bspline_curve.h> // moved
