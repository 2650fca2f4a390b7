#include <CGAL/Geometric_continuity/edges/edge_continuity.h> // moved
