#include <CGAL/Geometric_continuity/repairs/align_handles.h> // moved
