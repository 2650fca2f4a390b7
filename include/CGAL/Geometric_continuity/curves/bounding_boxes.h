#include <CGAL/Geometric_continuity/curves/polyline.h> // moved
