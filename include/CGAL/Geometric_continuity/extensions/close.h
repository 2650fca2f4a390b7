#include <CGAL/Geometric_continuity/extensions/extend.h> // moved
