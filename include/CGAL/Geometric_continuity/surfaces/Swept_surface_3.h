#include <CGAL/Geometric_continuity/surfaces/swept_surfaces.h> // moved
