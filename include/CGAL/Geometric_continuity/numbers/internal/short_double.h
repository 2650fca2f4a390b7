#include <CGAL/Geometric_continuity/blends/automatic_shape.h> // moved
