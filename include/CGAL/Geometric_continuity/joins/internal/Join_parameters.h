#include <CGAL/Geometric_continuity/joins/join_result.h> // moved
