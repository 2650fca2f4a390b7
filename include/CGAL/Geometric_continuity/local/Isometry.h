#include <CGAL/Geometric_continuity/local/congruence.h> // moved
