#include <CGAL/Geometric_continuity/edges/Cad_geometry.h> // moved
