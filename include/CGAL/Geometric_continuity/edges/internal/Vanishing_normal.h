#include <CGAL/Geometric_continuity/edges/internal/Edge_bounds.h> // moved
