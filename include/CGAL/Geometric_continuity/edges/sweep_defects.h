#include <CGAL/Geometric_continuity/edges/swept_continuity.h> // moved
