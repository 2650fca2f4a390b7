#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h> // moved
