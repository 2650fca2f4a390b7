#include <CGAL/Geometric_continuity/joins/path_continuity.h> // moved
