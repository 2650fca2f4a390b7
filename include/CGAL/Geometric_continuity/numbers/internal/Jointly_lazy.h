#include <CGAL/Geometric_continuity/blends/internal/exact_blend.h> // moved
