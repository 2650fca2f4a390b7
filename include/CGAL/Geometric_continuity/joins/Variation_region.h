#include <CGAL/Geometric_continuity/joins/Variable_join.h> // moved
