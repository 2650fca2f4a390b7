#include <CGAL/Geometric_continuity/algebra/sign_pattern.h> // moved
