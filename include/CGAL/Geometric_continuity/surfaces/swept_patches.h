#include <CGAL/Geometric_continuity/surfaces/elementary_surfaces.h> // moved
