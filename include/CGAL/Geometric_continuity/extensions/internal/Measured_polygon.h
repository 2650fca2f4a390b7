#include <CGAL/Geometric_continuity/repairs/internal/Measured_polygon.h> // moved
