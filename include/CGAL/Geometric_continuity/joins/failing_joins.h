#include <CGAL/Geometric_continuity/joins/join_predicates.h> // moved
