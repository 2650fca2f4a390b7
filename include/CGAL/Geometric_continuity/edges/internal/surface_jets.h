#include <CGAL/Geometric_continuity/edges/internal/Cad_surface_jet.h> // moved
