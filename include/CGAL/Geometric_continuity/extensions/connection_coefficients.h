#include <CGAL/Geometric_continuity/extensions/alternatives.h> // moved
