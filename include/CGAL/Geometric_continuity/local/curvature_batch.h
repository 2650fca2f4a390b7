#include <CGAL/Geometric_continuity/local/curvatures.h> // moved
