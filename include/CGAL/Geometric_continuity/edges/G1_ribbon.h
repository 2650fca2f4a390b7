#include <CGAL/Geometric_continuity/edges/connect_g1.h> // moved
