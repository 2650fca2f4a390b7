#include <CGAL/Geometric_continuity/joins/deviation.h> // moved
