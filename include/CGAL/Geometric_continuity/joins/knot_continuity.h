#include <CGAL/Geometric_continuity/joins/chain_continuity.h> // moved
