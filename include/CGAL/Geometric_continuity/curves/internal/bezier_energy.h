#include <CGAL/Geometric_continuity/curves/Bezier_curve.h> // moved
