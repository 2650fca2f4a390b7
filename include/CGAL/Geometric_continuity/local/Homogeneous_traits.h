#include <CGAL/Geometric_continuity/local/homogeneous_jets.h> // moved
