#include <CGAL/Geometric_continuity/blends/internal/Fair_minimum.h> // moved
