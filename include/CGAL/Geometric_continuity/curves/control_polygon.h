#include <CGAL/Geometric_continuity/curves/bezier_properties.h> // moved
