#include <CGAL/Geometric_continuity/edges/internal/cad_curve_jet.h> // moved
