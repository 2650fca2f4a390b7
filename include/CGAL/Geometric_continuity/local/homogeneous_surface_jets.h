#include <CGAL/Geometric_continuity/local/Surface_jet.h> // moved
