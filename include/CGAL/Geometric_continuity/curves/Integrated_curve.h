#include <CGAL/Geometric_continuity/curves/curve_from_curvatures.h> // moved
