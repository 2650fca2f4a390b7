#include <CGAL/Geometric_continuity/joins/internal/End_polygon.h> // moved
