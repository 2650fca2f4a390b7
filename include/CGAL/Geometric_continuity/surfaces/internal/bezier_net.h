#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h> // moved
