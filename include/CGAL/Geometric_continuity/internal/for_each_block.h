#include <CGAL/Geometric_continuity/internal/parallel.h> // moved
