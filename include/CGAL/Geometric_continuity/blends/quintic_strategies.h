#include <CGAL/Geometric_continuity/blends/blend_strategies.h> // moved
