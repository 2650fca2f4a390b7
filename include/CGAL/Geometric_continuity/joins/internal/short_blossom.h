#include <CGAL/Geometric_continuity/joins/internal/Grid_join.h> // moved
