#include <CGAL/Geometric_continuity/IO/number.h> // moved
