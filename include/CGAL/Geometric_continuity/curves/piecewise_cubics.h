#include <CGAL/Geometric_continuity/curves/Cubic_blended_curve.h> // moved
