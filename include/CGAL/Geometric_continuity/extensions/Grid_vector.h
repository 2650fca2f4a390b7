#include <CGAL/Geometric_continuity/repairs/Grid_vector.h> // moved
