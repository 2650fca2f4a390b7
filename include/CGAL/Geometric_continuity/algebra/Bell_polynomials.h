#include <CGAL/Geometric_continuity/local/Curve_jet.h> // moved
