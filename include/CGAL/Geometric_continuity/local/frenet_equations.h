#include <CGAL/Geometric_continuity/local/Frenet_frame.h> // moved
