#include <CGAL/Geometric_continuity/edges/internal/exact_cad_geometry.h> // moved
