#include <CGAL/Geometric_continuity/edges/foot_points.h> // moved
