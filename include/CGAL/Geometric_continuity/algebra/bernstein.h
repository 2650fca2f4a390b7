#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h> // moved
