#include <CGAL/Geometric_continuity/curves/Path_segment.h> // moved
