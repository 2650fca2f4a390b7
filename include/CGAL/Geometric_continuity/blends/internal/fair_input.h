#include <CGAL/Geometric_continuity/blends/Fair.h> // moved
