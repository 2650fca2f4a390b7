#include <CGAL/Geometric_continuity/edges/edge_deviation.h> // moved
