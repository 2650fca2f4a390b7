#include <CGAL/Geometric_continuity/blends/blend.h> // moved
