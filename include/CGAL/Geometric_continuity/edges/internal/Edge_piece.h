#include <CGAL/Geometric_continuity/edges/internal/Common_edge_part.h> // moved
