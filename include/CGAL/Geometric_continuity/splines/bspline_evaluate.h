#include <CGAL/Geometric_continuity/splines/Bspline_function.h> // moved
