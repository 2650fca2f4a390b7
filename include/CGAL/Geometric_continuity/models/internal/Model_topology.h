#include <CGAL/Geometric_continuity/models/internal/Model_mesh.h> // moved
